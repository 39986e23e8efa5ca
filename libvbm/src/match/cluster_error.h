// SPDX-License-Identifier: GPL-3.0-or-later
// How far the boundaries of two unions of balls lie from each other, measured at points of them.
#pragma once

#include "core/model.h"

#include <cstddef>
#include <vector>

namespace vbm::impl {

class BallTree;
class Progress;

/// Distances from points on one boundary to the other boundary.
struct OneSided {
  std::size_t points = 0;
  double most = 0, mean = 0;
  Vec3 where; // of the largest
};

/// About `count` points on the boundary of the union, at least one for every ball: each is where a
/// ray from a ball's centre first leaves the union. Dense where balls are many.
std::vector<Vec3> boundary_points(const std::vector<Ball> &balls, const BallTree &tree,
                                  std::size_t count, Progress &progress);

/// From these points to the boundary of the union of balls. For a point outside it is exact; for one
/// inside it is the shortest of several ways out, never less than the distance, and equal to it where
/// the nearest ball's surface is free at the point's foot.
OneSided distances(const std::vector<Vec3> &points, const std::vector<Ball> &balls,
                   const BallTree &tree, Progress &progress);

} // namespace vbm::impl
