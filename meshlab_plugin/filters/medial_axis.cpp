// SPDX-License-Identifier: GPL-3.0-or-later
// Build Medial Axis: a layer with the sheets and curves of the axis.
#include "axis_layer.h"
#include "filter.h"
#include "model.h"
#include "pruning.h"

namespace vbm_filters {
namespace {

std::vector<Param> params() {
  std::vector<Param> params = axis_params();
  // The axis has vertices of its own, whichever balls the model keeps.
  for (Param &param : model_params({"balls"})) params.push_back(std::move(param));
  params.push_back(hide_param());
  return params;
}

Outcome run(const Task &task) {
  const auto &[layer, values, progress, axes] = task;
  vbm::Context context;
  progress.stage(context, 0, 60);
  const vbm::Model model = build_model(context, layer, values);
  progress.stage(context, 60, 99);
  const auto made =
      std::make_shared<const KeptAxis>(KeptAxis{build_axis(context, model, values), layer.colors});

  Outcome outcome;
  describe(model, layer, outcome.log);
  describe(made->axis, outcome.log);
  outcome.layers.push_back(axis_layer(made->axis, layer.name + " axis"));
  outcome.layers.back().hide_source = values.flag("hide");
  axes.keep(made);
  return outcome;
}

} // namespace

const Filter medial_axis_filter = {
    "Voronoi Balls: Build Medial Axis",
    "generate_medial_axis_by_voronoi_balls",
    "Adds a layer with the <b>medial axis</b> of the shape: the surfaces and curves in its middle, "
    "with the same components, tunnels and cavities as the shape itself. Every vertex is the "
    "centre "
    "of a ball that touches the boundary, with the ball's radius as <b>radius</b> and "
    "<b>quality</b>. Sheets are cut where three or more meet into parts, one for each feature of "
    "the shape: faces have the colour of their part, and its number as quality. <i>Back-Face: "
    "Double</i> in the layer's rendering options lights both sides.<br>"
    "Select a face of a part and apply <i>Remove Selected Parts</i> to take that feature off the "
    "shape.<br><br>"
    "See:<br>"
    "<i>R. Tam</i>, <b>\"Voronoi Ball Models for Computational Shape Applications\"</b>, PhD "
    "thesis, chapter 7<br>"
    "<i>T. K. Dey, W. Zhao</i>, <b>\"Approximating the medial axis from the Voronoi diagram with a "
    "convergence guarantee\"</b>, Algorithmica 38, 2004",
    kRemeshing | kPointSet,
    kNothing,
    params,
    run,
};

} // namespace vbm_filters
