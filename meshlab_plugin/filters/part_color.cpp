// SPDX-License-Identifier: GPL-3.0-or-later
// Colour by Part: values for the vertices of the layer itself.
#include "axis_layer.h"
#include "ball_parts.h"
#include "filter.h"
#include "model.h"
#include "part_colors.h"
#include "pruning.h"
#include "text.h"

#include <limits>
#include <set>

namespace vbm_filters {
namespace {

enum By { kPart, kLevel };

std::vector<Param> params() {
  std::vector<Param> params = {enum_param(
      "by", "Colour by",
      "Part: each part has a colour, and its number is the quality. Level: all parts of a level "
      "have one; 1 are those at the border of the axis, 2 those next to them",
      {"Part", "Level"})};
  for (auto list : {pruning_params(), axis_params(), model_params({"balls", "undersampling"})})
    params.insert(params.end(), list.begin(), list.end());
  return params;
}

Outcome run(const Task &task) {
  const auto &[layer, values, progress, axes] = task;
  Outcome outcome;
  vbm::Context context;
  progress.stage(context, 0, 55);
  const vbm::Model model = build_model(context, layer, values);
  describe(model, layer, outcome.log);
  progress.stage(context, 55, 80);
  vbm::Axis axis = build_axis(context, model, values);
  axis = prune(context, std::move(axis), values, progress, 80, 99, outcome.log);
  describe(axis, outcome.log);

  const std::vector<std::int32_t> part = input_parts(model, ball_parts(model, axis));
  if (part.size() != layer.vertex_count())
    throw Failure("The library gave " + count(part.size()) + " parts for " +
                  count(layer.vertex_count()) + " vertices.");
  const auto list = axis.parts();
  VertexValues result;
  std::set<std::int32_t> seen;
  std::size_t without = 0;
  for (std::int32_t p : part) {
    if (p == kNoPart) {
      ++without;
      result.colors.push_back({128, 128, 128, 255});
      result.quality.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const std::int32_t number = values.get("by") == kLevel ? list[p].level : p;
    seen.insert(p);
    result.colors.push_back(part_color(number));
    result.quality.push_back(number);
  }
  outcome.log.push_back("The vertices belong to " + count(seen.size(), "part", "parts") + ".");
  if (without)
    outcome.log.push_back(count(without, "vertex belongs", "vertices belong") +
                          " to none: grey, with quality 0.");
  outcome.values.push_back(std::move(result));
  return outcome;
}

} // namespace

const Filter part_color_filter = {
    "Voronoi Balls: Colour by Part",
    "compute_color_by_medial_axis_part",
    "Shows which features the shape falls into: every vertex of the layer takes the colour of the "
    "part of the <b>medial axis</b> whose balls touch it, and the part's number as <b>quality</b>. "
    "Small parts are pruned first, as by <i>Simplify Shape</i>, and their vertices go with the "
    "part "
    "that is left nearby. Vertices without a ball (used by no face, or inside the solid) become "
    "grey.<br><br>"
    "See:<br>"
    "<i>R. Tam</i>, <b>\"Voronoi Ball Models for Computational Shape Applications\"</b>, PhD "
    "thesis, section 7.5",
    kQuality | kMeasure,
    kVertexQuality | kVertexColor,
    params,
    run,
};

} // namespace vbm_filters
