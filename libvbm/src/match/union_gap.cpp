// SPDX-License-Identifier: GPL-3.0-or-later
// The sphere is covered with caps. All of a cap is as near to the union as its farthest point is to
// the one ball that is nearest to its middle, and that point is known in closed form; so the bound
// holds between the directions looked at as well.
#include "match/union_gap.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

/// Caps of about 11 degrees, 162 of them: the nearest balls are nearly concentric with the sphere, so
/// that smaller ones change little.
constexpr int kCuts = 2;

} // namespace

UnionGap::UnionGap(const std::vector<Ball> &balls, Progress &progress)
    : balls_(balls), tree_(balls, progress), directions_(icosahedral_directions(kCuts)) {}

double UnionGap::cap(const Ball &ball, std::size_t direction) const {
  const Vec3 &u = directions_.list[direction];
  int32_t nearest = -1;
  tree_.to_union(ball.center + u * ball.radius, std::numeric_limits<double>::infinity(), &nearest);
  const Vec3 from = ball.center - balls_[nearest].center;
  const double d = length(from), r = ball.radius;
  const double angle = d > 0 ? std::acos(std::clamp(dot(from, u) / d, -1.0, 1.0)) : 0;
  const double c = std::cos(std::max(0.0, angle - directions_.angle));
  const double far = std::sqrt(std::max(0.0, r * r + d * d + 2 * r * d * c));
  return std::max(0.0, far - balls_[nearest].radius);
}

bool UnionGap::at_most(const Ball &ball, double most) {
  const std::size_t count = directions_.list.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t direction = (first_ + k) % count;
    if (cap(ball, direction) > most) {
      first_ = direction;
      return false;
    }
  }
  return true;
}

double UnionGap::bound(const Ball &ball) const {
  double gap = 0;
  for (std::size_t k = 0; k < directions_.list.size(); ++k) gap = std::max(gap, cap(ball, k));
  return gap;
}

} // namespace vbm::impl
