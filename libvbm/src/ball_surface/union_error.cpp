// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball_surface/union_error.h"

#include "core/progress.h"
#include "match/ball_tree.h"
#include "match/cluster_error.h"
#include "sampling/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vbm::impl {
namespace {

/// Points on the boundary of the union, and evenly on the surface: so many for each ball, and at
/// least so many in all.
constexpr std::size_t kPointsPerBall = 4;
constexpr std::size_t kLeastPoints = 10000;

/// The golden ratio's fractions in two dimensions: points that follow each other spread over a
/// triangle (Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018).
constexpr double kPlastic1 = 0.7548776662466927, kPlastic2 = 0.5698402909980532;

double fraction(double x) { return x - std::floor(x); }

/// Points at equal steps of area over all triangles.
std::vector<Vec3> even_points(const std::vector<Vec3> &position,
                              const std::vector<Triangle> &triangles, std::size_t count,
                              Progress &progress) {
  double area = 0;
  const auto corner = [&](const Triangle &t, int i) { return position[t[i]]; };
  const auto area_of = [&](const Triangle &t) {
    return length(cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0)));
  };
  for (const Triangle &t : triangles) {
    progress.tick(0, 1);
    area += area_of(t);
  }
  std::vector<Vec3> points;
  points.reserve(count);
  double passed = 0;
  for (const Triangle &t : triangles) {
    progress.tick(0, 1);
    passed += area_of(t);
    // The k-th point is at (k + 1/2) / count of the area.
    while (points.size() < count && (double(points.size()) + 0.5) * area < passed * double(count)) {
      double u = fraction(kPlastic1 * double(points.size())),
             v = fraction(kPlastic2 * double(points.size()));
      if (u + v > 1) u = 1 - u, v = 1 - v;
      points.push_back(corner(t, 0) * (1 - u - v) + corner(t, 1) * u + corner(t, 2) * v);
    }
  }
  return points;
}

} // namespace

void measure_errors(Surface &surface, const UnionInput &set, Progress &progress) {
  std::vector<Vec3> position(surface.vertices.size());
  for (std::size_t v = 0; v < position.size(); ++v)
    position[v] = set.frame.to_unit(surface.vertices[v]);
  const std::size_t count = std::max(kLeastPoints, kPointsPerBall * set.balls.size());
  vbm_surface_report &report = surface.report;
  const double unit = set.frame.length_to_input(1);

  progress.stage("balls for measuring", 0.05);
  const BallTree balls(set.balls, progress);
  progress.stage("from the surface", 0.5);
  const OneSided spread = distances(even_points(position, surface.triangles, count, progress),
                                    set.balls, balls, progress);
  progress.stage("from its corners", 0.6);
  std::vector<Vec3> corners(position);
  corners.reserve(corners.size() + surface.triangles.size());
  for (const Triangle &t : surface.triangles) {
    progress.tick(0, 1);
    corners.push_back((position[t[0]] + position[t[1]] + position[t[2]]) * (1.0 / 3));
  }
  const OneSided extreme = distances(corners, set.balls, balls, progress);
  report.surface_error_mean = unit * spread.mean;
  report.surface_error_max = unit * std::max(spread.most, extreme.most);

  progress.stage("points of the union", 0.7);
  const std::vector<Vec3> boundary = boundary_points(set.balls, balls, count, progress);
  progress.stage("from the union", 1);
  const TriangleTree tree(std::move(position), surface.triangles, {}, progress);
  double most = 0, sum = 0;
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    progress.tick(i, boundary.size());
    TriangleTree::Nearest found{std::numeric_limits<double>::infinity(), {}, -1};
    if (!tree.nearest(boundary[i], found)) continue;
    most = std::max(most, found.distance);
    sum += found.distance;
  }
  report.union_error_max = unit * most;
  report.union_error_mean = boundary.empty() ? 0 : unit * sum / double(boundary.size());
}

} // namespace vbm::impl
