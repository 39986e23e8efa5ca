// SPDX-License-Identifier: GPL-3.0-or-later
// Build Ball Model: a layer with a vertex at the centre of every ball.
#include "ball_layer.h"
#include "filter.h"
#include "model.h"

namespace vbm_filters {
namespace {

std::vector<Param> params() {
  std::vector<Param> params = model_params({});
  params.insert(params.begin() + 2,
                bool_param("outer", "Outer Balls Too",
                           "Add the balls outside the shape as well, which touch it from without",
                           false));
  params.push_back(hide_param());
  return params;
}

Outcome run(const Task &task) {
  const auto &[layer, values, progress, axes] = task;
  vbm::Context context;
  progress.stage(context, 0, 99);
  const vbm::Model model = build_model(context, layer, values);

  // Inner balls come first.
  const std::size_t wanted = values.flag("outer") ? model.radii().size : model.inner_count();
  NewLayer balls = ball_layer({model.centers().data, wanted}, {model.radii().data, wanted},
                              layer.name + " balls");
  balls.hide_source = values.flag("hide");

  Outcome outcome;
  describe(model, layer, outcome.log);
  outcome.log.push_back(describe_balls(balls));
  outcome.layers.push_back(std::move(balls));
  return outcome;
}

} // namespace

const Filter ball_model_filter = {
    "Voronoi Balls: Build Ball Model",
    "generate_voronoi_ball_model",
    "Fills the shape with balls, each as large as fits between the samples around it, and adds a "
    "layer with one vertex at the centre of each: points of the shape's <b>medial axis</b>. Their "
    "<b>radius</b> and <b>quality</b> are the balls' radii, their colours run from red (small) to "
    "blue (large). The input is a mesh, open or closed, or bare points such as a scan.<br><br>"
    "See:<br>"
    "<i>R. Tam</i>, <b>\"Voronoi Ball Models for Computational Shape Applications\"</b>, PhD "
    "thesis<br>"
    "<i>N. Amenta, S. Choi, R. Kolluri</i>, <b>\"The power crust, unions of balls, and the medial "
    "axis "
    "transform\"</b>, Computational Geometry 19(2-3), 2001",
    kRemeshing | kPointSet,
    kNothing,
    params,
    run,
};

} // namespace vbm_filters
