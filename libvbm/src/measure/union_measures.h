// SPDX-License-Identifier: GPL-3.0-or-later
// Volume and area of a union of balls, and of each ball's share.
#pragma once

#include "core/model.h"

#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// In the balls' own units. A ball's share is what lies in its cell of the balls' power diagram:
/// the shares do not overlap, and sum up to the whole.
struct UnionMeasures {
  double volume = 0, area = 0;
  std::vector<double> ball_volume, ball_area; // per ball; 0 for those that have no share
  std::size_t hidden = 0;                     // balls that have none
};

/// Of balls in a frame in which they reach no farther than about 1 from the origin. `touch`: as for
/// dual_shape(). Ticks the progress's current stage.
UnionMeasures union_measures(const std::vector<Ball> &balls, double touch, Progress &progress);

} // namespace vbm::impl
