// SPDX-License-Identifier: GPL-3.0-or-later
// Cluster Balls: a layer with fewer balls that stand for the layer's.
#include "ball_layer.h"
#include "filter.h"
#include "model.h"
#include "options.h"
#include "text.h"

namespace vbm_filters {
namespace {

std::vector<Param> params() {
  std::vector<Param> params = library_params("cluster");
  params.push_back(hide_param());
  return params;
}

Outcome run(const Task &task) {
  const auto &[layer, values, progress, axes] = task;
  const Balls balls = balls_of(layer);
  vbm::ClusterOptions options;
  set_options(options, "cluster", values);
  vbm::Context context;
  progress.stage(context, 0, 99);
  const vbm::Clusters clusters = vbm::cluster_balls(context, balls.centers, balls.radii, options);
  const vbm_clusters_report report = clusters.report();

  Outcome outcome;
  outcome.log.push_back(count(report.balls, "ball", "balls") + " in " +
                        count(report.clusters, "cluster", "clusters") + ", " +
                        count(report.singles) + " of them of one ball; sphericity at least " +
                        number(report.sphericity) + ".");
  outcome.log.push_back("No boundary goes farther than " + number(report.gap) +
                        " beyond the balls' own; the bound is " + number(report.bound) + ".");
  add_notes(clusters.notes(), outcome.log);
  outcome.layers.push_back(
      ball_layer(clusters.centers(), clusters.radii(), layer.name + " clusters"));
  outcome.layers.back().hide_source = values.flag("hide");
  outcome.log.push_back(describe_balls(outcome.layers.back()));
  return outcome;
}

} // namespace

const Filter cluster_filter = {
    "Voronoi Balls: Cluster Balls",
    "generate_clustered_balls",
    "Replaces groups of a layer's balls by one ball each that encloses them, and adds a layer of "
    "these: a coarser model of the same shape. Every vertex is a ball, by its <b>radius</b>. "
    "Either "
    "the <b>sphericity</b> says how good a stand-in has to be, or the number of balls is given and "
    "the best so many are found. The log says how far the boundary moves at most.<br><br>"
    "See:<br>"
    "<i>R. Tam</i>, <b>\"Voronoi Ball Models for Computational Shape Applications\"</b>, PhD "
    "thesis, section 4.4.1<br>"
    "<i>V. Ranjan, A. Fournier</i>, <b>\"Matching and interpolation of shapes using unions of "
    "circles\"</b>, Computer Graphics Forum 15(3), 1996",
    kRemeshing | kPointSet,
    kNothing,
    params,
    run,
};

} // namespace vbm_filters
