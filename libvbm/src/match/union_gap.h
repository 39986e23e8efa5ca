// SPDX-License-Identifier: GPL-3.0-or-later
// How far a sphere goes away from a union of balls.
#pragma once

#include "match/ball_tree.h"
#include "match/directions.h"

#include <cstddef>

namespace vbm::impl {

class UnionGap {
public:
  UnionGap(const std::vector<Ball> &balls, Progress &progress);

  /// Whether no point of the ball's sphere is farther from the union than `most`: certain if true.
  bool at_most(const Ball &ball, double most);
  /// An upper bound of how far from the union the ball's sphere goes.
  double bound(const Ball &ball) const;

private:
  double cap(const Ball &ball, std::size_t direction) const;

  const std::vector<Ball> &balls_;
  BallTree tree_;
  Directions directions_;
  std::size_t first_ = 0; // direction that failed last: likely to fail again
};

} // namespace vbm::impl
