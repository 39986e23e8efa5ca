// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the curves of a burnt axis are worth keeping.
#pragma once

#include "medial/burn.h"

namespace vbm::impl {

/// When a branch stays.
struct SpurLimit {
  double length = 0; // unit lengths: it is longer than the shape is wide at it by this, ...
  double ratio = 0;  // ... and by this many times that width
};

/// Cut the branches that are not. Every cut takes a vertex that has one edge and no triangle left,
/// with that edge: an elementary collapse.
void cut_spurs(const AxisCells &cells, const SpurLimit &limit, Burnt &burnt, Progress &progress);

} // namespace vbm::impl
