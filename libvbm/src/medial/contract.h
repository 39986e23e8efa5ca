// SPDX-License-Identifier: GPL-3.0-or-later
// Ball complexes made smaller by edge contractions that keep their homotopy type.
#pragma once

#include "medial/ball_complex.h"
#include "medial/ball_quadric.h"

#include <vector>

namespace vbm::impl {

class Progress;

/// Contract edges, the cheapest first, until `count` balls are left or no edge can go. `quadric` is
/// per ball and follows it, as `complex` does: what is left of both comes first, in their old
/// order. `into`, if not null, receives the ball of the result that each ball went into.
void contract(BallComplex &complex, std::vector<BallQuadric> &quadric, std::size_t count,
              std::vector<int32_t> *into, Progress &progress);

} // namespace vbm::impl
