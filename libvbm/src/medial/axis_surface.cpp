// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 7.6: the power crust of the balls left. The axis has the solid's topology by construction,
// but the crust of a few balls need not have the axis's: two balls far apart may meet, others miss
// each other. So its components and handles are compared with the solid's, and if they differ, the
// twigs come back for the surface, then the parts that went last; with all of them it is right.
#include "medial/axis_surface.h"

#include "core/progress.h"
#include "surface/boundary.h"
#include "surface/power_crust.h"

#include <algorithm>
#include <string>

namespace vbm::impl {
namespace {

/// Outer balls of which every sample's inner polar ball is gone (7.6).
std::vector<uint8_t> outer_kept(const Model &model, const std::vector<uint8_t> &kept) {
  std::vector<uint8_t> out(model.balls.size() - model.inner, 0);
  for (std::size_t b = model.inner; b < model.balls.size(); ++b)
    for (uint64_t k = model.ball_samples.offset[b]; k < model.ball_samples.offset[b + 1]; ++k) {
      const int32_t pole = model.inner_pole[model.ball_samples.index[k]];
      if (pole < 0 || kept[pole]) {
        out[b - model.inner] = 1;
        break;
      }
    }
  return out;
}

/// Which twigs that were pruned come back for the surface, where it needs them.
enum class Details { none, of_narrow_parts, all };

/// A part with a smaller share of the volume than this may be too narrow for a crust of its axis's
/// balls alone to hang together.
constexpr double kNarrow = 0.02;

/// The inner balls left if the parts from number `count` on had stayed, and these twigs.
std::vector<uint8_t> kept_before(const Axis &axis, std::size_t count, Details details) {
  const AxisCells &cells = *axis.cells;
  AxisState state;
  state.vertex = axis.state.vertex;
  state.twig = axis.state.twig;
  if (details != Details::none)
    for (std::size_t b = 0; b < state.twig.size(); ++b) {
      const int32_t v = cells.vertex_of_ball[b];
      const int32_t part = v < 0 ? AxisParts::kNothing : axis.parts.of_vertex[v];
      state.twig[b] |=
          details == Details::all || part < 0 || axis.parts.list[part].volume < kNarrow;
    }
  for (std::size_t r = count; r < axis.removed.size(); ++r)
    for (int32_t v : axis.removed[r].vertices) state.vertex[v] = 1;
  return kept_balls(cells, state);
}

} // namespace

Surface axis_surface(const Axis &axis, const vbm_axis_surface_options &options,
                     Progress &progress) {
  const Model &model = *axis.model;
  progress.stage("topology", 0.01);
  const Boundary boundary = find_boundary(model.cells, model.inside, progress);
  const int64_t euler = boundary.euler();
  const uint64_t components = boundary.components(progress);
  std::size_t count = axis.removed.size();
  const std::vector<uint8_t> &twig = axis.state.twig;
  const bool pruned = std::find(twig.begin(), twig.end(), 0) != twig.end();
  Details details = pruned ? Details::none : Details::all;
  for (std::size_t back = 1;;) {
    const std::vector<uint8_t> kept = kept_before(axis, count, details);
    const bool all = std::find(kept.begin(), kept.end(), 0) == kept.end();
    // Where an axis's last vertices are not polar balls' there may be none.
    const bool any = std::find(kept.begin(), kept.end(), 1) != kept.end();
    const std::vector<uint8_t> outer =
        options.drop_outer && !all ? outer_kept(model, kept) : std::vector<uint8_t>();
    Surface surface;
    if (any)
      surface = power_crust(model, all ? nullptr : kept.data(),
                            outer.empty() ? nullptr : outer.data(), progress);
    if (all || (any && surface.report.euler == euler && surface.report.components == components)) {
      if (const std::size_t taken = axis.removed.size() - count)
        surface.notes += std::to_string(taken) + " of " + std::to_string(axis.removed.size()) +
                         " removed parts came back for the surface, whose topology would have "
                         "changed without them\n";
      if (pruned && details != Details::none)
        surface.notes += std::string("Details too small to have a part came back ") +
                         (details == Details::all ? "" : "at narrow parts ") +
                         "for the surface, whose topology would have changed without them\n";
      return surface;
    }
    if (details != Details::all) { // first the details, then parts
      details = details == Details::none ? Details::of_narrow_parts : Details::all;
    } else {
      count -= std::min(count, back);
      back *= 2;
    }
  }
}

} // namespace vbm::impl
