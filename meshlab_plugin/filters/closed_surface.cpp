// SPDX-License-Identifier: GPL-3.0-or-later
// Rebuild Closed Surface: a layer with the surface of the ball model.
#include "filter.h"
#include "model.h"
#include "text.h"
#include "transfer.h"

#include <algorithm>
#include <tuple>

namespace vbm_filters {
namespace {

enum Method { kInterpolating, kPowerCrust };

std::vector<Param> params() {
  // Both surfaces are made from the polar balls.
  std::vector<Param> params = model_params({"balls"});
  params.insert(params.begin(),
                enum_param("method", "Surface",
                           "Interpolating: its vertices are the samples themselves, two triangles "
                           "each. Power crust: the faces between inner and outer balls, smoother "
                           "and with more vertices",
                           {"Interpolating", "Power Crust"}));
  params.insert(params.begin() + 3,
                bool_param("polygons", "Keep Polygons",
                           "Power crust: keep its polygons, instead of cutting them into triangles",
                           false));
  params.push_back(hide_param());
  return params;
}

// Corner by corner: is the edge to the next corner shared by two triangles of one polygon?
std::vector<std::uint8_t> inner_edges(const vbm::Surface &surface) {
  const auto triangles = surface.triangles();
  const auto polygon = surface.triangle_polygon();
  struct Edge {
    std::int32_t polygon, low, high;
    std::size_t corner;
    bool same(const Edge &o) const {
      return polygon == o.polygon && low == o.low && high == o.high;
    }
    bool operator<(const Edge &o) const {
      return std::tie(polygon, low, high, corner) < std::tie(o.polygon, o.low, o.high, o.corner);
    }
  };
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size);
  for (std::size_t t = 0; t < triangles.size; ++t)
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      edges.push_back({polygon[t], std::min(a, b), std::max(a, b), 3 * t + k});
    }
  std::sort(edges.begin(), edges.end());
  std::vector<std::uint8_t> inner(edges.size(), 0);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
    if (edges[i].same(edges[i + 1])) inner[edges[i].corner] = inner[edges[i + 1].corner] = 1;
  return inner;
}

void describe(const vbm::Surface &surface, std::vector<std::string> &log) {
  const vbm_surface_report report = surface.report();
  log.push_back("Closed surface: " + count(report.vertices, "vertex", "vertices") + ", " +
                count(report.triangles, "triangle", "triangles") + ", " +
                count(report.components, "component", "components") + ", genus " +
                std::to_string(report.genus) + ", area " + number(report.area) + ", volume " +
                number(report.volume) + ".");
  add_notes(surface.notes(), log);
}

Outcome run(const Layer &layer, const Values &values, Progress &progress) {
  const bool crust = values.get("method") == kPowerCrust;
  vbm::Context context;
  // The power diagram of all poles costs more than the triangulation of the samples.
  const int half = crust ? 40 : 80;
  progress.stage(context, 0, half);
  const vbm::Model model = build_model(context, layer, values);
  progress.stage(context, half, 99);
  const vbm::Surface surface = crust ? model.power_crust(context) : model.surface(context);

  NewLayer rebuilt;
  rebuilt.hide_source = values.flag("hide");
  rebuilt.suffix = crust ? "power crust" : "surface";
  const auto vertices = surface.vertices();
  const auto triangles = surface.triangles();
  const auto radius = surface.vertex_radius();
  const auto input = surface.vertex_input();
  rebuilt.points.assign(vertices.data, vertices.data + 3 * vertices.size);
  rebuilt.triangles.assign(triangles.data, triangles.data + 3 * triangles.size);
  rebuilt.radius.assign(radius.begin(), radius.end());
  rebuilt.quality = rebuilt.radius;
  if (crust && values.flag("polygons")) rebuilt.inner_edge = inner_edges(surface);
  if (!layer.colors.empty())
    rebuilt.colors = transfer_colors(layer.colors, {input.begin(), input.end()}, rebuilt.triangles);

  Outcome outcome;
  describe(model, layer, outcome.log);
  describe(surface, outcome.log);
  outcome.layers.push_back(std::move(rebuilt));
  return outcome;
}

} // namespace

const Filter closed_surface_filter = {
    "Voronoi Balls: Rebuild Closed Surface",
    "generate_surface_from_voronoi_balls",
    "Rebuilds a <b>closed surface</b> from a mesh with holes or from bare points, and adds it as a "
    "layer: every edge in two faces, all faces outwards. It runs through the samples, between the "
    "balls inside the shape and those outside it, and closes holes. <b>Quality</b> and "
    "<b>radius</b> of a vertex are the radius of the inner ball that touches it; vertex colours "
    "are "
    "kept. The log says where samples are too far apart to trust the surface.<br><br>"
    "See:<br>"
    "<i>N. Amenta, S. Choi, R. Kolluri</i>, <b>\"The power crust, unions of balls, and the medial "
    "axis "
    "transform\"</b>, Computational Geometry 19(2-3), 2001<br>"
    "<i>R. Tam</i>, <b>\"Voronoi Ball Models for Computational Shape Applications\"</b>, PhD "
    "thesis",
    true,
    params,
    run,
};

} // namespace vbm_filters
