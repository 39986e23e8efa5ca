// SPDX-License-Identifier: GPL-3.0-or-later
// The balls of a complex fitted to points its envelope should pass.
#pragma once

#include "medial/ball_complex.h"

#include <vector>

namespace vbm::impl {

class Progress;

/// Move balls and change their radii, cells staying as they are, so that the envelope passes nearer
/// to the points (unit frame); never farther, as squared distances go. A point is the centre of a
/// ball whose radius says how thick the shape is there; points of features that the complex does
/// not have are left out.
void fit_balls(BallComplex &complex, const std::vector<Ball> &points, int iterations,
               Progress &progress);

} // namespace vbm::impl
