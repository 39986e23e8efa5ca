// SPDX-License-Identifier: GPL-3.0-or-later
// Compute Thickness: values for the vertices of the layer itself.
#include "filter.h"
#include "model.h"
#include "ramp.h"
#include "text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vbm_filters {
namespace {

enum Measure { kThickness, kGap, kFeatureSize };

std::vector<Param> params() {
  std::vector<Param> params = model_params({"balls", "undersampling"});
  params.insert(
      params.begin(),
      enum_param(
          "measure", "Measure",
          "Thickness: the diameter of the largest inner ball at the vertex. Gap: that of the "
          "largest outer ball. Local feature size: the smaller of the two balls' radii",
          {"Thickness", "Gap", "Local Feature Size"}));
  params.insert(params.begin() + 1,
                bool_param("colorize", "Colour by Value",
                           "Colour the vertices from red (small) to blue (large)", true));
  return params;
}

// Infinite balls measure nothing.
double finite(double value) {
  return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
}

Outcome run(const Task &task) {
  const auto &[layer, values, progress, axes] = task;
  vbm::Context context;
  progress.stage(context, 0, 99);
  const vbm::Model model = build_model(context, layer, values);
  const auto inner = model.inner_radius();
  const auto outer = model.outer_radius();
  if (inner.size != layer.vertex_count() || outer.size != inner.size)
    throw Failure("The library gave " + count(inner.size) + " radii for " +
                  count(layer.vertex_count()) + " vertices.");

  VertexValues result;
  result.radius.reserve(inner.size);
  for (std::size_t i = 0; i < inner.size; ++i) {
    switch (static_cast<int>(values.get("measure"))) {
    case kThickness:
      result.radius.push_back(finite(inner[i]));
      break;
    case kGap:
      result.radius.push_back(finite(outer[i]));
      break;
    default:
      result.radius.push_back(finite(std::fmin(inner[i], outer[i])));
      break;
    }
  }
  result.quality = result.radius;
  if (values.get("measure") != kFeatureSize)
    for (double &value : result.quality) value *= 2;
  const Spread range = spread(result.quality);
  if (values.flag("colorize")) result.ramp = range.ramp;

  Outcome outcome;
  describe(model, layer, outcome.log);
  outcome.log.push_back("Quality from " + number(range.minimum) + " to " + number(range.maximum) +
                        ".");
  if (range.finite < inner.size)
    outcome.log.push_back(count(inner.size - range.finite, "vertex has", "vertices have") +
                          " no such ball: quality and radius 0 there.");
  outcome.values.push_back(std::move(result));
  return outcome;
}

} // namespace

const Filter thickness_filter = {
    "Voronoi Balls: Compute Thickness",
    "compute_thickness_by_voronoi_balls",
    "Measures how thick the shape is at every vertex, as the diameter of the largest ball that "
    "touches the surface there from inside, and writes it to the layer's own vertices: the "
    "diameter "
    "as <b>quality</b>, half of it as <b>radius</b>. From outside the same gives the gap to the "
    "next "
    "wall. Vertices without such a ball (used by no face, or inside the solid) receive 0. The log "
    "gives the smallest and largest value; colours run from red (thin) to blue (thick).<br><br>"
    "See:<br>"
    "<i>R. Tam</i>, <b>\"Voronoi Ball Models for Computational Shape Applications\"</b>, PhD "
    "thesis<br>"
    "<i>N. Amenta, S. Choi, R. Kolluri</i>, <b>\"The power crust, unions of balls, and the medial "
    "axis "
    "transform\"</b>, Computational Geometry 19(2-3), 2001",
    kQuality | kMeasure,
    kVertexQuality | kVertexRadius | kVertexColor,
    params,
    run,
};

} // namespace vbm_filters
