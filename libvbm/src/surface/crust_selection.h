// SPDX-License-Identifier: GPL-3.0-or-later
// Which balls a power crust is made of.
#pragma once

#include "core/model.h"

#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// Inner balls, then outer ones. Most are balls of the model; others are Voronoi balls that support
/// them where the sampling is thin.
struct Selection {
  std::vector<Ball> balls;
  std::size_t inner = 0;
  std::vector<int32_t> origin; // ball of the model, or model.balls.size() + number of the support
  std::vector<std::array<int32_t, 4>> support_samples; // ascending
  std::vector<int32_t>
      support_ball; // the model's ball that stands for the support, -1 for outer ones

  /// The samples ball b touches: begin and end.
  std::pair<const int32_t *, const int32_t *> samples_of(const Model &model, int32_t b) const;
  /// The model's ball behind inner ball b.
  int32_t model_ball(const Model &model, int32_t b) const;
};

/// The model's inner and outer balls that are kept (a byte a ball; all if NULL). Throws
/// Error(VBM_ERROR_NO_INTERIOR) if no inner one is kept.
Selection select_balls(const Model &model, const uint8_t *keep, const uint8_t *keep_outer);

/// All balls of the model, and all Voronoi balls round the samples where the sampling is too thin.
Selection select_with_support(const Model &model, Progress &progress);

} // namespace vbm::impl
