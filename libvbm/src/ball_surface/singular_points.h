// SPDX-License-Identifier: GPL-3.0-or-later
// The singular-point surface (thesis 8.3): a closed surface from any balls.
#pragma once

#include "ball_surface/merge_points.h"
#include "core/frame.h"
#include "core/model.h"

#include <vbm/vbm.h>

#include <vector>

namespace vbm::impl {

class Progress;

/// Balls to make a surface of, and what is known about them.
struct UnionInput {
  Frame frame;
  std::vector<Ball> balls;      // unit frame
  std::vector<int32_t> number;  // the caller's of each
  std::size_t points = 0;       // left out, as they have no radius
  double touch = 0;             // see dual_shape()
  const Model *model = nullptr; // the balls are inner ones of this
};

/// Throws Error(VBM_ERROR_NO_INTERIOR) if there is no ball.
Surface singular_point_surface(const UnionInput &set, const vbm_ball_surface_options &options,
                               Progress &progress);

} // namespace vbm::impl
