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

/// The inner balls left if the parts from number `count` on had stayed.
std::vector<uint8_t> kept_before(const Axis &axis, std::size_t count) {
  std::vector<uint8_t> vertex = axis.state.vertex;
  for (std::size_t r = count; r < axis.removed.size(); ++r)
    for (int32_t v : axis.removed[r].vertices) vertex[v] = 1;
  std::vector<uint8_t> kept(axis.cells->vertex_of_ball.size());
  for (std::size_t b = 0; b < kept.size(); ++b) {
    const int32_t v = axis.cells->vertex_of_ball[b];
    kept[b] = v < 0 || vertex[v];
  }
  return kept;
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
  for (std::size_t back = 1;; back *= 2) {
    const std::vector<uint8_t> kept = kept_before(axis, count);
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
      return surface;
    }
    count -= std::min(count, back);
  }
}

} // namespace vbm::impl
