// SPDX-License-Identifier: GPL-3.0-or-later
// Simplify Shape: a layer with the surface of the pruned axis.
#include "axis_layer.h"
#include "filter.h"
#include "model.h"
#include "options.h"
#include "pruning.h"
#include "surface_layer.h"
#include "text.h"

namespace vbm_filters {
namespace {

std::vector<Param> params() {
  std::vector<Param> params = pruning_params();
  params.push_back(bool_param("axis", "Axis Too",
                              "Add a layer with the medial axis that is left as well, whose parts "
                              "can be selected and removed",
                              false));
  for (auto list : {library_params("axis_surface"), axis_params(), model_params({"balls"})})
    params.insert(params.end(), list.begin(), list.end());
  params.push_back(hide_param());
  return params;
}

Outcome run(const Task &task) {
  const auto &[layer, values, progress, axes] = task;
  Outcome outcome;
  vbm::Context context;
  progress.stage(context, 0, 30);
  const vbm::Model model = build_model(context, layer, values);
  describe(model, layer, outcome.log);
  progress.stage(context, 30, 50);
  vbm::Axis axis = build_axis(context, model, values);
  axis = prune(context, std::move(axis), values, progress, 50, 65, outcome.log);
  progress.stage(context, 65, 99);
  vbm::AxisSurfaceOptions options;
  set_options(options, "axis_surface", values);
  const vbm::Surface surface = axis.surface(context, options);

  describe(axis, outcome.log);
  describe(surface, outcome.log);
  if (values.flag("axis")) {
    const auto made = std::make_shared<const KeptAxis>(KeptAxis{std::move(axis), layer.colors});
    outcome.layers.push_back(axis_layer(made->axis, layer.name + " axis"));
    axes.keep(made);
  }
  outcome.layers.push_back(surface_layer(surface, layer.name + " simplified", layer.colors));
  outcome.layers.back().hide_source = values.flag("hide");
  return outcome;
}

} // namespace

const Filter simplify_filter = {
    "Voronoi Balls: Simplify Shape",
    "generate_simplified_shape_by_medial_axis",
    "Takes bumps and small features off the shape, and adds a layer with the <b>closed surface</b> "
    "of the rest. The shape's medial axis is cut into parts, one for each feature; the least "
    "significant ones at its border go, and their balls with them, unless a component, tunnel or "
    "cavity of the shape would be lost or made. First small parts go by their number of triangles, "
    "then others by their share of the volume, their width or their angle. What is left is not "
    "smoothed.<br><br>"
    "See:<br>"
    "<i>R. Tam, W. Heidrich</i>, <b>\"Shape simplification based on the medial axis "
    "transform\"</b>, IEEE Visualization 2003<br>"
    "<i>R. Tam</i>, <b>\"Voronoi Ball Models for Computational Shape Applications\"</b>, PhD "
    "thesis, chapter 7",
    kRemeshing | kPointSet,
    kNothing,
    params,
    run,
};

} // namespace vbm_filters
