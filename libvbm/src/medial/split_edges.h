// SPDX-License-Identifier: GPL-3.0-or-later
// A medial mesh of more balls with the same envelope.
#pragma once

#include "medial/ball_complex.h"

#include <cstddef>
#include <vector>

namespace vbm::impl {

class Progress;

/// Gives edges a ball in their middle, the mean of their ends', until there are `count` balls:
/// first those of primitives that the points are far from. Cones and slabs are linear in their
/// balls, so that neither the envelope nor the topology changes.
void split_edges(BallComplex &complex, const std::vector<Ball> &points, std::size_t count,
                 Progress &progress);

} // namespace vbm::impl
