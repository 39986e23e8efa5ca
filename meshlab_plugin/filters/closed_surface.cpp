// SPDX-License-Identifier: GPL-3.0-or-later
// Rebuild Closed Surface: a layer with the surface of the ball model.
#include "filter.h"
#include "model.h"
#include "surface_layer.h"
#include "text.h"
#include "thin_sampling.h"

#include <algorithm>

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
  params.push_back(bool_param("select", "Select Where Too Thin",
                              "If samples are too far apart somewhere to trust the surface, select "
                              "the vertices there, on this "
                              "layer and on the new one, instead of those selected now",
                              true));
  params.push_back(hide_param());
  return params;
}

// Where the sampling is too thin, on both layers.
void select_thin(const vbm::Model &model, const Layer &layer, const vbm::Surface &surface,
                 Outcome &outcome) {
  outcome.selected = undersampled_vertices(model, layer);
  if (outcome.selected.empty()) return;
  NewLayer &rebuilt = outcome.layers.back();
  rebuilt.selected = undersampled_vertices(model, surface);
  const auto chosen = std::count(outcome.selected.begin(), outcome.selected.end(), 1);
  outcome.log.push_back(
      count(static_cast<std::uint64_t>(chosen), "vertex is", "vertices are") +
      " selected where it is too thin, on both layers (a layer's rendering options "
      "have Selection).");
}

Outcome run(const Task &task) {
  const auto &[layer, values, progress, axes] = task;
  const bool crust = values.get("method") == kPowerCrust;
  vbm::Context context;
  // The power diagram of all poles costs more than the triangulation of the samples.
  const int half = crust ? 40 : 80;
  progress.stage(context, 0, half);
  const vbm::Model model = build_model(context, layer, values);
  progress.stage(context, half, 99);
  const vbm::Surface surface = crust ? model.power_crust(context) : model.surface(context);

  NewLayer rebuilt = surface_layer(surface, layer.name + (crust ? " power crust" : " surface"),
                                   layer.colors, crust && values.flag("polygons"));
  rebuilt.hide_source = values.flag("hide");

  Outcome outcome;
  describe(model, layer, outcome.log);
  describe(surface, outcome.log);
  outcome.layers.push_back(std::move(rebuilt));
  if (values.flag("select")) select_thin(model, layer, surface, outcome);
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
    "kept. Where samples are too far apart to trust the surface, the vertices of both layers are "
    "selected; the log says "
    "how many samples these are.<br><br>"
    "See:<br>"
    "<i>N. Amenta, S. Choi, R. Kolluri</i>, <b>\"The power crust, unions of balls, and the medial "
    "axis "
    "transform\"</b>, Computational Geometry 19(2-3), 2001<br>"
    "<i>R. Tam</i>, <b>\"Voronoi Ball Models for Computational Shape Applications\"</b>, PhD "
    "thesis",
    kRemeshing | kPointSet,
    kNothing,
    params,
    run,
};

} // namespace vbm_filters
