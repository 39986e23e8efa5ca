// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_layer.h"

#include "text.h"
#include "transfer.h"

#include <algorithm>
#include <tuple>

namespace vbm_filters {
namespace {

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

} // namespace

NewLayer surface_layer(const vbm::Surface &surface, std::string name,
                       const std::vector<Color> &input_colors, bool polygons) {
  const auto vertices = surface.vertices();
  const auto triangles = surface.triangles();
  const auto radius = surface.vertex_radius();
  NewLayer layer;
  layer.name = std::move(name);
  layer.points.assign(vertices.begin(), vertices.end());
  layer.triangles.assign(triangles.begin(), triangles.end());
  layer.radius.assign(radius.begin(), radius.end());
  layer.quality = layer.radius;
  if (polygons) layer.inner_edge = inner_edges(surface);
  if (!input_colors.empty()) {
    const auto input = surface.vertex_input();
    layer.colors = transfer_colors(input_colors, {input.begin(), input.end()}, layer.triangles);
  }
  return layer;
}

void describe(const vbm::Surface &surface, std::vector<std::string> &log) {
  const vbm_surface_report report = surface.report();
  log.push_back("Closed surface: " + count(report.vertices, "vertex", "vertices") + ", " +
                count(report.triangles, "triangle", "triangles") + ", " +
                count(report.components, "component", "components") + ", genus " +
                std::to_string(report.genus) + ", area " + number(report.area) + ", volume " +
                number(report.volume) + ".");
  if (report.surface_error_max > 0 || report.union_error_max > 0)
    log.push_back("From the surface to the balls' union: at most " +
                  number(report.surface_error_max) + ", on average " +
                  number(report.surface_error_mean) + "; from the union to the surface: at most " +
                  number(report.union_error_max) + ", on average " +
                  number(report.union_error_mean) + ".");
  add_notes(surface.notes(), log);
}

} // namespace vbm_filters
