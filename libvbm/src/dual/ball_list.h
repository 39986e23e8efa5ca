// SPDX-License-Identifier: GPL-3.0-or-later
// A bare list of balls, as a caller gives it, checked and brought to the unit frame.
#pragma once

#include "core/frame.h"
#include "core/model.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

struct BallList {
  Frame frame;                // in which the balls' bounding box has a side in [0.5, 1]
  std::vector<Ball> balls;    // unit frame
  std::vector<int32_t> input; // the caller's number of each
  std::size_t points = 0;     // balls left out: of radius 0, or below kLeastBall
};

/// Throws Error: ARGUMENT (an array is NULL), LIMIT (too many), INPUT with kind "ball" (a number is
/// not finite, a radius is negative, a ball reaches too far).
BallList ball_list(const double *centers, const double *radii, std::size_t count,
                   Progress &progress);

} // namespace vbm::impl
