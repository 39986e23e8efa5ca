// SPDX-License-Identifier: GPL-3.0-or-later
// Remove Selected Parts: of an axis layer; new layers with the axis and the shape without them.
#include "axis_layer.h"
#include "filter.h"
#include "model.h"
#include "options.h"
#include "part_choice.h"
#include "surface_layer.h"
#include "text.h"

#include <map>

namespace vbm_filters {
namespace {

std::vector<Param> params() {
  std::vector<Param> params = {
      bool_param("surface", "Surface Too",
                 "Add a layer with the closed surface of what is left of the shape as well", true)};
  for (Param &param : library_params("axis_surface")) params.push_back(std::move(param));
  params.push_back(hide_param());
  return params;
}

// "Part 3 stays: a tunnel or cavity of the shape would be lost." One by one for a few, else by
// reason.
std::vector<std::string> stays(const PartsRemoved &result) {
  const auto reason = [](std::int32_t lock) {
    return std::string(lock == VBM_LOCK_NONE ? "the others selected hold the shape's topology"
                                             : vbm_lock_text(lock));
  };
  constexpr std::size_t kFew = 8;
  std::vector<std::string> lines;
  if (result.left.size() <= kFew) {
    for (std::size_t i = 0; i < result.left.size(); ++i)
      lines.push_back("Part " + count(result.left[i]) + " stays: " + reason(result.why[i]) + ".");
    return lines;
  }
  std::map<std::int32_t, std::uint64_t> locks;
  for (std::int32_t lock : result.why) ++locks[lock];
  for (const auto &[lock, parts] : locks)
    lines.push_back(count(parts, "selected part stays", "selected parts stay") + ": " +
                    reason(lock) + ".");
  return lines;
}

std::string joined(const std::vector<std::string> &lines) {
  std::string text;
  for (const std::string &line : lines) text += (text.empty() ? "" : " ") + line;
  return text;
}

Outcome run(const Task &task) {
  const auto &[layer, values, progress, axes] = task;
  const std::shared_ptr<const KeptAxis> kept = axes.find(layer);
  if (!kept)
    throw Failure("This layer is not a medial axis of these filters, or its vertices or faces were "
                  "changed, or MeshLab was closed since it was made: apply \"Build Medial Axis\" "
                  "to the shape's own layer again, and select faces of the layer that makes.");
  const std::vector<std::int32_t> parts = chosen_parts(kept->axis, layer);
  if (parts.empty())
    throw Failure("Nothing is selected: select a face of every part that is to go, or, of a curve, "
                  "which has no faces, the two ends of one of its edges.");

  vbm::Context context;
  const bool wanted = values.flag("surface");
  progress.stage(context, 0, wanted ? 30 : 99);
  PartsRemoved result = remove_parts(context, kept->axis, parts);
  if (result.gone.empty()) throw Failure(joined(stays(result)));

  Outcome outcome;
  outcome.log.push_back(count(result.gone.size(), "part", "parts") + " removed.");
  for (std::string &line : stays(result)) outcome.log.push_back(std::move(line));
  const std::string name = without_axis(layer.name);
  if (wanted) {
    progress.stage(context, 30, 99);
    vbm::AxisSurfaceOptions options;
    set_options(options, "axis_surface", values);
    const vbm::Surface surface = result.axis.surface(context, options);
    outcome.layers.push_back(surface_layer(surface, name + " simplified", kept->input_colors));
    describe(surface, outcome.log);
  }
  const auto made =
      std::make_shared<const KeptAxis>(KeptAxis{std::move(result.axis), kept->input_colors});
  describe(made->axis, outcome.log);
  outcome.layers.push_back(axis_layer(made->axis, name + " axis"));
  outcome.layers.back().hide_source = values.flag("hide");
  axes.keep(made);
  return outcome;
}

} // namespace

const Filter remove_parts_filter = {
    "Voronoi Balls: Remove Selected Parts",
    "generate_shape_without_selected_parts",
    "Takes features off a shape by hand: applied to a layer with a <b>medial axis</b> (by <i>Build "
    "Medial Axis</i> or <i>Simplify Shape</i>), it removes every part that has a <b>selected "
    "face</b>, and adds a layer with the axis that is left and one with the <b>closed surface</b> "
    "of "
    "the shape without these features. The old axis stays, hidden, to go back to.<br>"
    "A part stays, and the log says why, if without it the shape would lose a tunnel or cavity or "
    "fall apart, or if it has no border yet because other parts surround it. Nothing may be "
    "changed "
    "in the axis layer but the selection.<br><br>"
    "See:<br>"
    "<i>R. Tam</i>, <b>\"Voronoi Ball Models for Computational Shape Applications\"</b>, PhD "
    "thesis, sections 7.5 and 7.7",
    kRemeshing | kSelection,
    kNothing,
    params,
    run,
};

} // namespace vbm_filters
