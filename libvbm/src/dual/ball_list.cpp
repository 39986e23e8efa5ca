// SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/ball_list.h"

#include "core/error.h"
#include "core/progress.h"
#include "core/tolerances.h"
#include "sampling/checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vbm::impl {
namespace {

/// Balls of one list: their doubled extents are still counted in 32 bits.
constexpr std::size_t kMostBalls = std::numeric_limits<int32_t>::max() / 16;

void check(const double *centers, const double *radii, std::size_t count, Progress &progress) {
  if (count && (!centers || !radii))
    throw Error(VBM_ERROR_ARGUMENT, std::string(centers ? "radii" : "centers") + " is NULL, but " +
                                        counted(count, "ball was", "balls were") + " announced");
  if (count > kMostBalls)
    throw Error(VBM_ERROR_LIMIT, std::to_string(count) + " balls are more than the " +
                                     std::to_string(kMostBalls) + " that can be handled");
  const double most = std::ldexp(1.0, kMaxExponent);
  Offenders not_finite, negative, far;
  for (std::size_t b = 0; b < count; ++b) {
    if ((b & 1023) == 0) progress.tick(b, count);
    const double *c = centers + 3 * b, r = radii[b];
    if (!std::isfinite(c[0]) || !std::isfinite(c[1]) || !std::isfinite(c[2]) || !std::isfinite(r))
      not_finite.add(b);
    else if (r < 0)
      negative.add(b);
    else if (std::max({std::fabs(c[0]), std::fabs(c[1]), std::fabs(c[2])}) > most || r > most)
      far.add(b);
  }
  if (not_finite.total) throw_offenders(not_finite, "ball", "balls", "is not finite");
  if (negative.total) throw_offenders(negative, "ball", "balls", "has a negative radius");
  if (far.total) throw_offenders(far, "ball", "balls", "reaches beyond 2^1000");
}

} // namespace

BallList ball_list(const double *centers, const double *radii, std::size_t count,
                   Progress &progress) {
  check(centers, radii, count, progress);
  std::vector<double> extent(6 * count);
  for (std::size_t b = 0; b < count; ++b)
    for (int a = 0; a < 3; ++a) {
      if ((b & 1023) == 0) progress.tick(0, 1);
      extent[6 * b + a] = centers[3 * b + a] - radii[b];
      extent[6 * b + 3 + a] = centers[3 * b + a] + radii[b];
    }
  BallList list;
  list.frame = frame_of(extent.data(), 2 * count);
  list.balls.reserve(count);
  list.input.reserve(count);
  for (std::size_t b = 0; b < count; ++b) {
    if ((b & 1023) == 0) progress.tick(b, count);
    const Ball ball{list.frame.to_unit({centers[3 * b], centers[3 * b + 1], centers[3 * b + 2]}),
                    list.frame.length_to_unit(radii[b])};
    if (ball.radius < kLeastBall) {
      ++list.points;
      continue;
    }
    list.balls.push_back(ball);
    list.input.push_back(int32_t(b));
  }
  return list;
}

} // namespace vbm::impl
