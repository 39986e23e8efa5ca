// SPDX-License-Identifier: GPL-3.0-or-later
// Points are found by rays, because balls of a model cover each other nearly everywhere: of points
// spread over their spheres hardly one in a hundred would lie on the boundary.
#include "match/cluster_error.h"

#include "core/hash.h"
#include "core/progress.h"
#include "match/ball_tree.h"
#include "match/directions.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

/// Ratio to the ball a point is in: a point less deep than this share of its radius is on the
/// boundary. Above rounding, below any error worth telling.
constexpr double kOnBoundary = 1e-10;

/// Balls a ray may pass before it is given up: more than any real model's, and an end in any case.
constexpr int kMaxPassed = 10000;

constexpr double kTurn = 6.283185307179586;
constexpr double kGoldenTurn = 0.6180339887498949; // of a turn: spreads points along a spiral

double fraction(uint64_t bits) { return double(bits >> 11) * 0x1p-53; }

/// Where a ray from a point in the union first leaves it, as a distance from `from`; the first
/// `skip` of it is known to lie inside. Negative if it is given up.
double way_out(const Vec3 &from, const Vec3 &direction, double skip,
               const std::vector<Ball> &balls, const BallTree &tree) {
  double t = skip;
  for (int passed = 0; passed < kMaxPassed; ++passed) {
    int32_t deepest = -1;
    const double d = tree.to_union(from + direction * t, 0, &deepest);
    if (deepest < 0 || -d <= kOnBoundary * balls[deepest].radius) return t;
    // The far end of the ray's chord through the deepest ball.
    const Ball &ball = balls[deepest];
    const Vec3 to = ball.center - from;
    const double along = dot(to, direction);
    const Vec3 side = to - direction * along;
    const double half = (ball.radius - length(side)) * (ball.radius + length(side));
    const double next = along + std::sqrt(std::max(0.0, half));
    if (!(next > t)) return t;
    t = next;
  }
  return -1;
}

/// Radially out of the deepest ball, which is exact where that leads out; else the shortest of
/// several ways.
double depth(const Vec3 &point, const std::vector<Ball> &balls, const BallTree &tree,
             int32_t deepest, double least, const Directions &directions) {
  const Vec3 away = unit(point - balls[deepest].center);
  double best = way_out(point, dot(away, away) > 0 ? away : Vec3{1, 0, 0}, 0, balls, tree);
  if (best >= 0 && best <= least + kOnBoundary * balls[deepest].radius) return best;
  for (const Vec3 &direction : directions.list) {
    const double t = way_out(point, direction, 0, balls, tree);
    if (t >= 0 && (best < 0 || t < best)) best = t;
  }
  return best;
}

} // namespace

std::vector<Vec3> boundary_points(const std::vector<Ball> &balls, const BallTree &tree,
                                  std::size_t count, Progress &progress) {
  std::vector<Vec3> points;
  if (balls.empty()) return points;
  const std::size_t each = std::max<std::size_t>(1, (count + balls.size() / 2) / balls.size());
  for (std::size_t b = 0; b < balls.size(); ++b) {
    const double turn = fraction(hash_index(2 * b)), shift = fraction(hash_index(2 * b + 1));
    for (std::size_t k = 0; k < each; ++k) {
      progress.tick(b, balls.size());
      const double z = 1 - 2 * (double(k) + shift) / double(each);
      const double s = std::sqrt(std::max(0.0, 1 - z * z));
      const double angle = kTurn * (turn + kGoldenTurn * double(k));
      const Vec3 direction{s * std::cos(angle), s * std::sin(angle), z};
      const double t = way_out(balls[b].center, direction, balls[b].radius, balls, tree);
      if (t >= 0) points.push_back(balls[b].center + direction * t);
    }
  }
  return points;
}

OneSided distances(const std::vector<Vec3> &points, const std::vector<Ball> &balls,
                   const BallTree &tree, Progress &progress) {
  const Directions directions = icosahedral_directions(1);
  OneSided result;
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    progress.tick_slow(i, points.size());
    int32_t nearest = -1;
    double d = tree.to_union(points[i], std::numeric_limits<double>::infinity(), &nearest);
    if (d < 0) d = depth(points[i], balls, tree, nearest, -d, directions);
    if (d < 0) continue;
    ++result.points;
    sum += d;
    if (d > result.most || result.points == 1) result.most = d, result.where = points[i];
  }
  if (result.points) result.mean = sum / double(result.points);
  return result;
}

} // namespace vbm::impl
