// SPDX-License-Identifier: GPL-3.0-or-later
// Measure Union of Balls: in the log, and each ball's share as the layer's own quality.
#include "ball_layer.h"
#include "filter.h"
#include "text.h"

namespace vbm_filters {
namespace {

enum Share { kVolume, kArea };

std::vector<Param> params() {
  return {enum_param("share", "Quality",
                     "Each ball's share of the union's volume, or of its area: the part that lies "
                     "in the ball's cell of the power diagram. The shares sum up to the whole",
                     {"Volume", "Area"})};
}

Outcome run(const Task &task) {
  const auto &[layer, values, progress, axes] = task;
  const Balls balls = balls_of(layer);
  vbm::Context context;
  progress.stage(context, 0, 99);
  const vbm::Measures measures = vbm::union_measures(context, balls.centers, balls.radii);
  const vbm_measures_report report = measures.report();
  const auto shares =
      values.get("share") == kArea ? measures.ball_areas() : measures.ball_volumes();

  Outcome outcome;
  VertexValues result;
  result.quality.assign(shares.begin(), shares.end());
  outcome.values.push_back(std::move(result));
  outcome.log.push_back("Union of " + count(report.balls, "ball", "balls") + ": volume " +
                        number(report.volume) + ", area " + number(report.area) + ".");
  if (report.hidden)
    outcome.log.push_back(count(report.hidden, "ball has", "balls have") +
                          " no share: within others, or points.");
  if (layer.transformed)
    outcome.log.push_back("The layer has a transformation matrix: the measures are those before it "
                          "is applied.");
  outcome.measures = {{"volume", report.volume}, {"area", report.area}};
  return outcome;
}

} // namespace

const Filter ball_measures_filter = {
    "Voronoi Balls: Measure Union of Balls",
    "compute_union_of_balls_measures",
    "Computes the exact <b>volume</b> and <b>area</b> of the union of a layer's balls, however "
    "they "
    "overlap, and writes them to the log. Every vertex is a ball, by its <b>radius</b>; it "
    "receives "
    "its ball's share of the volume or of the area as <b>quality</b>.<br><br>"
    "See:<br>"
    "<i>H. Edelsbrunner</i>, <b>\"The union of balls and its dual shape\"</b>, Discrete and "
    "Computational Geometry 13, 1995<br>"
    "<i>R. Tam</i>, <b>\"Voronoi Ball Models for Computational Shape Applications\"</b>, PhD "
    "thesis, section 7.9",
    kMeasure | kPointSet,
    kVertexQuality,
    params,
    run,
};

} // namespace vbm_filters
