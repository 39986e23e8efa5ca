// SPDX-License-Identifier: GPL-3.0-or-later
// The areas of patches.
#pragma once

#include "ball_surface/boundary_map.h"

#include <vector>

namespace vbm::impl {

/// The solid angle, as seen from its ball's centre, of what is on the left of the loop a side is
/// in, which is no whole circle; of a patch of several loops, their sum less 4 pi for all but one.
double loop_angle(const BoundaryMap &map, const DualShape &shape, int32_t side);

/// Per ball, the length of a square as large as what is bare of it: its own area where it has no
/// neighbours, else the mean of theirs and its own. What a face is about as long as, if every ball
/// gets one.
std::vector<double> spacings(const BoundaryMap &map, const DualShape &shape);

} // namespace vbm::impl
