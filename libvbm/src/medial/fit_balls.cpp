// SPDX-License-Identifier: GPL-3.0-or-later
// Gauss and Newton's method. Each point p belongs to the primitive that is best for it, and to that
// primitive's mixture (c, r) of balls that reaches it best. Its distance |p - c| - r changes with
// ball i, whose share in the mixture is w, by -w n . dc - w dr, where n points from c to p; that
// the best mixture changes too makes no difference to first order. The equations of all points are
// solved by conjugate gradients, ball by ball preconditioned, and balls are held where they are by
// a little, so that those no point moves stay. Distances far above the usual count more: the
// largest gap is to go down as well.
#include "medial/fit_balls.h"

#include "core/progress.h"
#include "medial/ball_quadric.h"
#include "medial/envelope.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vbm::impl {
namespace {

/// Share of the weight of a ball's points with which it is held, at least; how many times tighter
/// after a step that did not help, and looser after one that did (Levenberg and Marquardt).
constexpr double kHold = 0.02, kTighten = 10, kEase = 3;

/// Share of the mean weight of all balls with which each is held besides.
constexpr double kHoldAll = 1e-3;

/// Times the root of the mean square at which a distance counts twice, and the most it counts.
constexpr double kFarFrom = 2, kMostWeight = 25;

/// Share of its radius by which a ball moves at most in one step.
constexpr double kStep = 0.5;

/// Radii. A point farther than this from a ball, and than the shape is thick at it, belongs to a
/// feature that has no ball: more than a corner of a cube is from the largest ball within.
constexpr double kCorner = 0.75;

/// Of conjugate gradients; and the share of the first residual at which they end.
constexpr int kMostSteps = 40;
constexpr double kEnough = 1e-3;

using Four = std::array<double, 4>;

struct Row {
  Primitive ball;
  std::array<double, 3> share;
  Vec3 normal;
  double distance, weight;
  int32_t primitive = -1;
};

class Fitter {
public:
  Fitter(BallComplex &complex, const std::vector<Ball> &points, Progress &progress)
      : complex_(complex), points_(points), progress_(progress) {}

  void run(int iterations) {
    leave_out();
    std::vector<Ball> best = complex_.ball;
    double least = measure();
    std::vector<Row> rows = row_;
    for (int i = 0; i < iterations; ++i) {
      step(solve());
      const double sum = measure();
      if (sum < least) {
        least = sum;
        best = complex_.ball;
        rows = row_;
        hold_ = std::max(kHold, hold_ / kEase);
      } else {
        complex_.ball = best;
        row_ = rows;
        hold_ *= kTighten;
      }
    }
    complex_.ball = best;
  }

private:
  void leave_out() {
    const Envelope envelope(complex_, progress_);
    for (const Ball &point : points_) {
      progress_.tick(0, 1);
      const EnvelopeHit hit = envelope.nearest(point.center);
      if (hit.distance <= std::max(point.radius, kCorner * envelope.at(hit).radius))
        used_.push_back(point);
    }
  }

  /// The rows of the balls as they are, and the sum of squared distances.
  double measure() {
    const Envelope envelope(complex_, progress_);
    row_.resize(used_.size());
    double sum = 0;
    for (std::size_t i = 0; i < used_.size(); ++i) {
      progress_.tick(0, 1);
      Row &row = row_[i];
      const EnvelopeHit hit = envelope.nearest(used_[i].center, row.primitive);
      row.primitive = hit.primitive;
      row.ball = envelope.primitives()[hit.primitive];
      row.share = hit.weight;
      row.normal = unit(used_[i].center - envelope.at(hit).center);
      row.distance = hit.distance;
      sum += hit.distance * hit.distance;
    }
    const double usual = kFarFrom * kFarFrom * sum / double(std::max<std::size_t>(1, row_.size()));
    double weighted = 0;
    for (Row &row : row_) {
      const double d2 = row.distance * row.distance;
      row.weight = usual > 0 ? std::min(1 + d2 / usual, kMostWeight) : 1;
      weighted += d2 * d2;
    }
    // Of the fourth powers and the squares together: neither the mean nor the far ones may get
    // lost.
    return sum + (usual > 0 && sum > 0 ? std::sqrt(weighted * double(row_.size())) : 0);
  }

  double apply(const Row &row, const std::vector<Four> &x) const {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      if (row.ball[i] < 0) continue;
      const Four &at = x[row.ball[i]];
      sum += row.share[i] *
             (row.normal.x * at[0] + row.normal.y * at[1] + row.normal.z * at[2] + at[3]);
    }
    return sum;
  }
  void spread(const Row &row, double value, std::vector<Four> &y) const {
    for (int i = 0; i < 3; ++i) {
      if (row.ball[i] < 0) continue;
      const double v = value * row.share[i];
      Four &at = y[row.ball[i]];
      at[0] += v * row.normal.x;
      at[1] += v * row.normal.y;
      at[2] += v * row.normal.z;
      at[3] += v;
    }
  }
  static double product(const std::vector<Four> &x, const std::vector<Four> &y) {
    double sum = 0;
    for (std::size_t v = 0; v < x.size(); ++v)
      for (int a = 0; a < 4; ++a) sum += x[v][a] * y[v][a];
    return sum;
  }

  std::vector<Four> solve() {
    const std::size_t count = complex_.ball.size();
    std::vector<std::array<double, 10>> block(count);
    std::vector<Four> residual(count), x(count), along, image, scaled(count);
    std::vector<double> hold(count, 0);
    double all = 0;
    for (const Row &row : row_) {
      spread(row, row.weight * row.distance, residual);
      for (int i = 0; i < 3; ++i) {
        if (row.ball[i] < 0) continue;
        const double w = row.weight * row.share[i] * row.share[i];
        const double g[4] = {row.normal.x, row.normal.y, row.normal.z, 1};
        for (int a = 0, k = 0; a < 4; ++a)
          for (int b = a; b < 4; ++b, ++k) block[row.ball[i]][k] += w * g[a] * g[b];
        hold[row.ball[i]] += w;
        all += w;
      }
    }
    const double least = kHoldAll * all / double(count) + 1e-300; // not zero
    for (std::size_t v = 0; v < count; ++v) {
      hold[v] = hold_ * hold[v] + least;
      for (int k : {0, 4, 7, 9}) block[v][k] += hold[v];
    }
    const auto precondition = [&] {
      for (std::size_t v = 0; v < count; ++v)
        if (!solve4(block[v], residual[v], scaled[v]))
          for (int a = 0; a < 4; ++a) scaled[v][a] = residual[v][a] / (block[v][9]);
    };
    precondition();
    along = scaled;
    double old = product(residual, scaled);
    const double enough = kEnough * kEnough * old;
    for (int step = 0; step < kMostSteps && old > enough; ++step) {
      image.assign(count, Four{});
      for (const Row &row : row_) spread(row, row.weight * apply(row, along), image);
      for (std::size_t v = 0; v < count; ++v)
        for (int a = 0; a < 4; ++a) image[v][a] += hold[v] * along[v][a];
      const double curve = product(along, image);
      if (!(curve > 0)) break;
      const double far = old / curve;
      for (std::size_t v = 0; v < count; ++v) {
        for (int a = 0; a < 4; ++a) {
          x[v][a] += far * along[v][a];
          residual[v][a] -= far * image[v][a];
        }
      }
      precondition();
      const double now = product(residual, scaled);
      for (std::size_t v = 0; v < count; ++v)
        for (int a = 0; a < 4; ++a) along[v][a] = scaled[v][a] + now / old * along[v][a];
      old = now;
      progress_.tick_slow(0, 1);
    }
    return x;
  }

  void step(const std::vector<Four> &x) {
    for (std::size_t v = 0; v < x.size(); ++v) {
      Ball &ball = complex_.ball[v];
      const Vec3 move{x[v][0], x[v][1], x[v][2]};
      const double size = std::sqrt(dot(move, move) + x[v][3] * x[v][3]);
      const double most = kStep * ball.radius;
      const double share = size > most ? most / size : 1;
      if (!std::isfinite(size)) continue;
      ball.center += move * share;
      ball.radius += x[v][3] * share;
    }
  }

  BallComplex &complex_;
  const std::vector<Ball> &points_;
  Progress &progress_;
  std::vector<Ball> used_;
  std::vector<Row> row_;
  double hold_ = kHold;
};

} // namespace

void fit_balls(BallComplex &complex, const std::vector<Ball> &points, int iterations,
               Progress &progress) {
  if (complex.ball.empty() || points.empty() || iterations < 1) return;
  Fitter(complex, points, progress).run(iterations);
}

} // namespace vbm::impl
