// SPDX-License-Identifier: GPL-3.0-or-later
// Searching among balls, by where they lie and how large they are.
#pragma once

#include "core/model.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace vbm::impl {

class Progress;

/// A k-d tree of balls, taken as points of four coordinates: centre and radius. Balls can leave.
class BallTree {
public:
  BallTree() = default;
  BallTree(const std::vector<Ball> &balls, Progress &progress);

  /// Take a ball out of all further searches.
  void remove(int32_t ball);

  /// Append the balls left that lie in the ball (center, radius) as a whole, in no special order.
  void inside(const Vec3 &center, double radius, std::vector<int32_t> &found) const;

  /// Distance from a point to the union of the balls left: the least |point - centre| - radius,
  /// negative inside. Infinite if none is left or all are farther than `limit`. `ball`, if not
  /// null, receives one where it is least.
  double to_union(const Vec3 &point, double limit = std::numeric_limits<double>::infinity(),
                  int32_t *ball = nullptr) const;

private:
  struct Node {
    Vec3 low, high; // of centres
    double smallest, largest; // radius
    int32_t begin, end;       // in order_
    int32_t left;             // its number from 1 on; right = left + 1; 0: a leaf
    int32_t alive;            // balls that have not left
  };

  void split(int32_t node, Progress &progress);
  void select(int32_t begin, int32_t middle, int32_t end, int axis, Progress &progress);
  double nearest(const Node &node, const Vec3 &point) const;

  std::vector<Node> nodes_;
  std::vector<Ball> balls_;     // as in order_
  std::vector<int32_t> order_;  // of the balls, leaf by leaf
  std::vector<int32_t> place_;  // of every ball in order_
  std::vector<uint8_t> gone_;   // as in order_
};

} // namespace vbm::impl
