// SPDX-License-Identifier: GPL-3.0-or-later
#include "match/clusters.h"

#include "core/error.h"
#include "core/progress.h"
#include "match/ball_tree.h"
#include "match/best_groups.h"
#include "match/cluster_error.h"
#include "match/grouping.h"
#include "match/union_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

namespace vbm::impl {
namespace {

/// Ratio to the largest ball. What rounding may add to a gap over its bound.
constexpr double kRounding = 1e-12;

/// Throws unless all are balls; returns the exponent that makes the largest number less than 1.
int check(const double *centers, const double *radii, std::size_t count) {
  if (!count) throw Error(VBM_ERROR_INPUT, "there are no balls to cluster");
  if (count > std::size_t(std::numeric_limits<int32_t>::max()))
    throw Error(VBM_ERROR_ARGUMENT, std::to_string(count) + " balls are more than indices can name");
  std::vector<int64_t> bad;
  std::size_t total = 0;
  const char *what = "";
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 c{centers[3 * i], centers[3 * i + 1], centers[3 * i + 2]};
    const char *why = !is_finite(c)               ? "has a centre that is not finite"
                      : !std::isfinite(radii[i]) ? "has a radius that is not finite"
                      : radii[i] < 0             ? "has a negative radius"
                                                 : nullptr;
    largest = std::max({largest, std::fabs(c.x), std::fabs(c.y), std::fabs(c.z), radii[i]});
    if (!why) continue;
    if (!total++) what = why;
    if (bad.size() < Error::kMaxListed) bad.push_back(int64_t(i));
  }
  if (total)
    throw Error(VBM_ERROR_INPUT,
                "ball " + std::to_string(bad.front()) + " " + what +
                    (total > 1 ? ", and " + std::to_string(total - 1) + " more are no balls" : ""),
                "ball", bad, total);
  int exponent = 0;
  if (largest > 0) std::frexp(largest, &exponent);
  return exponent;
}

void fill_views(Clusters &c, const vbm_cluster_options &options, const UnionGap *union_gap,
                Progress &progress) {
  c.ball_cluster.resize(c.balls.size());
  vbm_clusters_report &r = c.report;
  r = {};
  r.struct_size = sizeof r;
  r.balls = c.balls.size();
  r.clusters = c.enclosing.size();
  r.sphericity = 1;
  double largest = 0, largest_cluster = 0, gap_most = 0, bound = 0;
  const bool by_union = options.measure == VBM_CLUSTER_UNION;
  for (std::size_t k = 0; k < c.enclosing.size(); ++k) {
    progress.tick_slow(k, c.enclosing.size());
    const Ball &ball = c.enclosing[k];
    const std::size_t begin = c.members.offset[k], end = c.members.offset[k + 1];
    for (std::size_t i = begin; i < end; ++i) c.ball_cluster[c.members.index[i]] = int32_t(k);
    const Ball &a = c.balls[c.members.index[begin]];
    const double twice = 2 * (ball.radius - a.radius); // 2 r (1 - s) / s
    double gap = std::clamp(distance(ball.center, a.center) + ball.radius - a.radius, 0.0, twice);
    double sphericity = ball.radius > 0 ? a.radius / ball.radius : 1;
    if (union_gap && gap > 0) {
      gap = std::min(gap, union_gap->bound(ball));
      sphericity = std::max(sphericity, 1 - gap / (2 * ball.radius));
    }
    for (int axis = 0; axis < 3; ++axis)
      c.centers.push_back(std::ldexp(ball.center[axis], c.exponent));
    c.radii.push_back(std::ldexp(ball.radius, c.exponent));
    c.gap.push_back(std::ldexp(gap, c.exponent));
    c.sphericity.push_back(sphericity);
    r.singles += end - begin == 1;
    r.sphericity = std::min(r.sphericity, sphericity);
    bound = std::max(bound, by_union ? gap : twice);
    largest = std::max(largest, a.radius);
    largest_cluster = std::max(largest_cluster, ball.radius);
    gap_most = std::max(gap_most, gap);
  }
  const double s = options.sphericity;
  if (!options.count) bound = by_union ? 2 * largest_cluster * (1 - s) : 2 * largest * (1 - s) / s;
  if (gap_most > bound + kRounding * largest_cluster)
    throw Error(VBM_ERROR_INTERNAL, "a cluster's ball lies farther from its balls than Theorem 3.3 "
                                    "allows: please report the balls it was made of");
  r.largest = std::ldexp(largest, c.exponent);
  r.gap = std::ldexp(std::min(gap_most, bound), c.exponent);
  r.bound = std::ldexp(bound, c.exponent);
}

} // namespace

Clusters cluster_balls(const double *centers, const double *radii, std::size_t count,
                       const vbm_cluster_options &options, Progress &progress) {
  Clusters c;
  progress.stage("reading balls", 0.02);
  c.exponent = check(centers, radii, count);
  c.balls.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    progress.tick(i, count);
    for (int axis = 0; axis < 3; ++axis)
      c.balls[i].center[axis] = std::ldexp(centers[3 * i + std::size_t(axis)], -c.exponent);
    c.balls[i].radius = std::ldexp(radii[i], -c.exponent);
  }
  const bool by_union = options.measure == VBM_CLUSTER_UNION;
  Grouping groups;
  if (options.count) {
    groups = best_groups(c.balls, std::min<std::size_t>(options.count, count), by_union, progress);
    const std::size_t made = groups.enclosing.size();
    if (made < options.count)
      c.notes += std::to_string(made) + (made == 1 ? " ball is" : " balls are") +
                 " as good as the " + std::to_string(options.count) + " asked for\n";
  } else {
    progress.stage("clustering", 0.95);
    Allowance allowance;
    allowance.sphericity = options.sphericity;
    allowance.by_union = by_union;
    groups = group_balls(c.balls, allowance, 0, progress);
  }
  c.enclosing = std::move(groups.enclosing);
  c.members = std::move(groups.members);
  progress.stage("checking the error", 1);
  std::unique_ptr<UnionGap> union_gap;
  if (by_union) union_gap = std::make_unique<UnionGap>(c.balls, progress);
  fill_views(c, options, union_gap.get(), progress);
  return c;
}

vbm_cluster_error measure_clusters(const Clusters &c, std::size_t points, Progress &progress) {
  progress.stage("search trees", 0.05);
  const BallTree given(c.balls, progress), made(c.enclosing, progress);
  progress.stage("points on the clusters' boundary", 0.25);
  std::vector<Vec3> on = boundary_points(c.enclosing, made, points, progress);
  progress.stage("distance to the given balls", 0.4);
  const OneSided outward = distances(on, c.balls, given, progress);
  progress.stage("points on the given boundary", 0.8);
  on = boundary_points(c.balls, given, points, progress);
  progress.stage("distance to the clusters", 1);
  const OneSided inward = distances(on, c.enclosing, made, progress);

  vbm_cluster_error error{};
  error.struct_size = sizeof error;
  error.outward_points = outward.points;
  error.inward_points = inward.points;
  error.outward = std::ldexp(outward.most, c.exponent);
  error.outward_mean = std::ldexp(outward.mean, c.exponent);
  error.inward = std::ldexp(inward.most, c.exponent);
  error.inward_mean = std::ldexp(inward.mean, c.exponent);
  for (int axis = 0; axis < 3; ++axis) {
    error.outward_position[axis] = std::ldexp(outward.where[axis], c.exponent);
    error.inward_position[axis] = std::ldexp(inward.where[axis], c.exponent);
  }
  return error;
}

} // namespace vbm::impl
