// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 7.6: the power crust of the balls left. The axis has the solid's topology by construction,
// but the crust of a few balls need not have the axis's: two balls far apart may meet, others miss
// each other. So its components and handles are compared with the solid's, and if they differ, the
// parts that went last come back for the surface; with all of them it is right.
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

/// The inner balls left if the parts from number `count` on had stayed, and all twigs if any had.
std::vector<uint8_t> kept_before(const Axis &axis, std::size_t count, bool twigs) {
  AxisState state;
  state.vertex = axis.state.vertex;
  state.twig = axis.state.twig;
  if (twigs) std::fill(state.twig.begin(), state.twig.end(), 1);
  for (std::size_t r = count; r < axis.removed.size(); ++r)
    for (int32_t v : axis.removed[r].vertices) state.vertex[v] = 1;
  return kept_balls(*axis.cells, state);
}

} // namespace

Surface axis_surface(const Axis &axis, const vbm_axis_surface_options &options,
                     Progress &progress) {
  const Model &model = *axis.model;
  progress.stage("topology", 0.01);
  const Boundary boundary = find_boundary(model.cells, model.inside, progress);
  const int64_t euler = boundary.euler();
  const uint64_t components = boundary.components();
  std::size_t count = axis.removed.size();
  const std::vector<uint8_t> &twig = axis.state.twig;
  bool twigs = std::find(twig.begin(), twig.end(), 0) == twig.end();
  const bool all_twigs = twigs;
  for (std::size_t back = 1;;) {
    const std::vector<uint8_t> kept = kept_before(axis, count, twigs);
    const bool all = std::find(kept.begin(), kept.end(), 0) == kept.end();
    const std::vector<uint8_t> outer =
        options.drop_outer && !all ? outer_kept(model, kept) : std::vector<uint8_t>();
    Surface surface = power_crust(model, all ? nullptr : kept.data(),
                                  outer.empty() ? nullptr : outer.data(), progress);
    if (all || (surface.report.euler == euler && surface.report.components == components)) {
      if (const std::size_t taken = axis.removed.size() - count)
        surface.notes += std::to_string(taken) + " of " + std::to_string(axis.removed.size()) +
                         " removed parts came back for the surface, whose topology would have "
                         "changed without them\n";
      if (twigs && !all_twigs)
        surface.notes += "Details too small to have a part came back for the surface, whose "
                         "topology would have changed without them\n";
      return surface;
    }
    if (!twigs) {
      twigs = true; // first the details, then parts
    } else {
      count -= std::min(count, back);
      back *= 2;
    }
  }
}

} // namespace vbm::impl
