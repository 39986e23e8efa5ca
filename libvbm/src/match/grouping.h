// SPDX-License-Identifier: GPL-3.0-or-later
// Balls into groups, each of which one ball can stand for (thesis 4.4.1).
#pragma once

#include "core/model.h"

#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// How badly one ball may stand for a group.
struct Allowance {
  double sphericity = 1; // ratio: largest ball's radius to that of the enclosing one, at least
  double slack = 0;      // length: enclosing ball's radius minus the largest ball's, at most;
                         // instead of the sphericity where it is greater than 0
  bool by_union = false; // what is not to be farther from the enclosing ball's sphere than its largest
                         // ball may be is the union of all balls: UnionGap

  /// The greatest radius allowed about a largest ball, whatever lies around it.
  double limit(double largest) const;
  /// The greatest gap allowed between a ball of this radius and the union.
  double gap(double radius) const;
};

struct Grouping {
  std::vector<Ball> enclosing; // of every group, in the order they were made
  Incidence members;           // of every group: its largest ball, then the rest ascending
};

/// Every ball in exactly one group: the largest one left takes as many others as one ball within
/// the allowance can enclose, again and again. Ends with balls left over after `most` groups, if
/// that is not 0.
Grouping group_balls(const std::vector<Ball> &balls, const Allowance &allowance, std::size_t most,
                     Progress &progress);

} // namespace vbm::impl
