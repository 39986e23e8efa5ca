// SPDX-License-Identifier: GPL-3.0-or-later
// Build Axis of N Balls: a layer with a medial mesh of as many balls as asked for.
#include "axis_layer.h"
#include "ball_layer.h"
#include "filter.h"
#include "model.h"
#include "options.h"
#include "orient.h"
#include "pruning.h"
#include "text.h"

namespace vbm_filters {
namespace {

std::vector<Param> params() {
  std::vector<Param> params = library_params("simplify_axis");
  for (auto list : {axis_params(), model_params({"balls"})})
    params.insert(params.end(), list.begin(), list.end());
  params.push_back(hide_param());
  return params;
}

// The axis behind the layer, with the parts that are left of it, or one made from the layer's
// shape.
std::shared_ptr<const KeptAxis> axis_of(vbm::Context &context, const Task &task, int end,
                                        std::vector<std::string> &log) {
  const auto &[layer, values, progress, axes] = task;
  if (std::shared_ptr<const KeptAxis> kept = axes.find(layer)) return kept;
  progress.stage(context, 0, end * 2 / 3);
  const vbm::Model model = build_model(context, layer, values);
  describe(model, layer, log);
  progress.stage(context, end * 2 / 3, end);
  return std::make_shared<const KeptAxis>(
      KeptAxis{build_axis(context, model, values), layer.colors});
}

NewLayer mesh_layer(const vbm::MedialMesh &mesh, std::string name) {
  NewLayer layer = ball_layer(mesh.vertices(), mesh.radii(), std::move(name));
  const auto triangles = mesh.triangles();
  layer.triangles.assign(triangles.begin(), triangles.end());
  orient_sheets(layer.triangles, layer.points);
  return layer;
}

void describe(const vbm::MedialMesh &mesh, std::vector<std::string> &log) {
  const vbm_medial_mesh_report report = mesh.report();
  describe_simplices("Axis of " + count(report.vertices, "ball", "balls") + ": ", report, log);
  log.push_back("The shape that it stands for is off by at most " + number(report.error_max) +
                ", on average " + number(report.error_mean) + "; the diagonal is " +
                number(report.diagonal) + ".");
  add_notes(mesh.notes(), log);
}

Outcome run(const Task &task) {
  const auto &[layer, values, progress, axes] = task;
  Outcome outcome;
  vbm::Context context;
  const std::shared_ptr<const KeptAxis> whole = axis_of(context, task, 60, outcome.log);
  progress.stage(context, 60, 99);
  vbm::SimplifyOptions options;
  set_options(options, "simplify_axis", values);
  const vbm::MedialMesh mesh = vbm::simplify(context, whole->axis, options);

  describe(mesh, outcome.log);
  NewLayer made = mesh_layer(mesh, without_axis(layer.name) + " axis of " +
                                       count(mesh.radii().size, "ball", "balls"));
  made.hide_source = values.flag("hide");
  outcome.layers.push_back(std::move(made));
  return outcome;
}

} // namespace

const Filter axis_of_balls_filter = {
    "Voronoi Balls: Build Axis of N Balls",
    "generate_medial_axis_of_n_balls",
    "Adds a layer with a <b>medial axis of as many balls as you ask for</b>: few balls, joined by "
    "triangles and curves, that stand for the shape with the same components, tunnels and "
    "cavities. Neighbouring balls are joined where that costs least and changes no topology, then "
    "fitted to the shape. Every vertex is the centre of a ball, with the ball's radius as "
    "<b>radius</b> and <b>quality</b>; colours run from red (small) to blue (large). Applied to a "
    "layer with a medial axis (by <i>Build Medial Axis</i>, <i>Simplify Shape</i> or <i>Remove "
    "Selected Parts</i>) it takes that axis, with the parts that are left. The log says how far "
    "the shape is off.<br><br>"
    "See:<br>"
    "<i>R. Tam</i>, <b>\"Voronoi Ball Models for Computational Shape Applications\"</b>, PhD "
    "thesis, chapter 7<br>"
    "<i>P. Li, B. Wang, F. Sun, X. Guo, C. Zhang, W. Wang</i>, <b>\"Q-MAT: Computing medial axis "
    "transform by quadratic error minimization\"</b>, ACM Transactions on Graphics 35(1), 2015<br>"
    "<i>J.-M. Thiery, E. Guy, T. Boubekeur</i>, <b>\"Sphere-Meshes: Shape approximation using "
    "spherical quadric error metrics\"</b>, ACM Transactions on Graphics 32(6), 2013",
    kRemeshing | kPointSet,
    kNothing,
    params,
    run,
};

} // namespace vbm_filters
