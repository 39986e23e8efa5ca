// SPDX-License-Identifier: GPL-3.0-or-later
// Squared distances of a ball's boundary to planes, summed: the spherical quadric of Thiery, Guy,
// Boubekeur, "Sphere-Meshes" (2013), here of the tangent planes at samples.
#pragma once

#include "core/model.h"

#include <array>
#include <cmath>

namespace vbm::impl {

/// Of the ball (c, r), sum of weight * (n . (p - c) - r)^2 over the planes (p, n) entered.
class BallQuadric {
public:
  /// The plane through p whose outward unit normal is n.
  void add_plane(const Vec3 &p, const Vec3 &n, double weight) {
    add({n.x, n.y, n.z, 1}, dot(n, p), weight);
  }
  /// weight * (|c - ball.center|^2 + (r - ball.radius)^2)
  void add_anchor(const Ball &ball, double weight) {
    add({1, 0, 0, 0}, ball.center.x, weight);
    add({0, 1, 0, 0}, ball.center.y, weight);
    add({0, 0, 1, 0}, ball.center.z, weight);
    add({0, 0, 0, 1}, ball.radius, weight);
  }
  BallQuadric &operator+=(const BallQuadric &other) {
    for (int i = 0; i < 10; ++i) a_[i] += other.a_[i];
    for (int i = 0; i < 4; ++i) b_[i] += other.b_[i];
    c_ += other.c_;
    return *this;
  }

  double at(const Ball &ball) const {
    const double x[4] = {ball.center.x, ball.center.y, ball.center.z, ball.radius};
    double sum = c_;
    for (int i = 0, k = 0; i < 4; ++i) {
      sum -= 2 * b_[i] * x[i];
      for (int j = i; j < 4; ++j, ++k) sum += (i == j ? 1 : 2) * a_[k] * x[i] * x[j];
    }
    return sum > 0 ? sum : 0; // rounding
  }
  double weight() const { return a_[9]; } // of the planes

  /// The ball of least value; false if there is no single one.
  bool least(Ball &ball) const;

private:
  /// weight * (g . x - d)^2
  void add(const std::array<double, 4> &g, double d, double weight) {
    for (int i = 0, k = 0; i < 4; ++i) {
      b_[i] += weight * g[i] * d;
      for (int j = i; j < 4; ++j, ++k) a_[k] += weight * g[i] * g[j];
    }
    c_ += weight * d * d;
  }

  std::array<double, 10> a_{}; // upper triangle, row by row
  std::array<double, 4> b_{};
  double c_ = 0;
};

/// Solve the positive definite system a x = b (upper triangle, row by row) by Cholesky's method;
/// false if it is not, as far as doubles tell.
inline bool solve4(const std::array<double, 10> &a, const std::array<double, 4> &b,
                   std::array<double, 4> &x) {
  /// Share of a pivot that rounding may leave of nothing.
  constexpr double kSingular = 1e-12;
  double l[4][4];
  const int row[4] = {0, 4, 7, 9}; // where a_ii is
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j <= i; ++j) {
      double sum = a[row[j] + i - j];
      for (int k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
      if (i == j) {
        if (!(sum > kSingular * a[row[i]])) return false;
        l[i][i] = std::sqrt(sum);
      } else {
        l[i][j] = sum / l[j][j];
      }
    }
  }
  for (int i = 0; i < 4; ++i) {
    double sum = b[i];
    for (int k = 0; k < i; ++k) sum -= l[i][k] * x[k];
    x[i] = sum / l[i][i];
  }
  for (int i = 3; i >= 0; --i) {
    double sum = x[i];
    for (int k = i + 1; k < 4; ++k) sum -= l[k][i] * x[k];
    x[i] = sum / l[i][i];
  }
  return true;
}

inline bool BallQuadric::least(Ball &ball) const {
  std::array<double, 4> x;
  if (!solve4(a_, b_, x)) return false;
  ball = {{x[0], x[1], x[2]}, x[3]};
  return true;
}

} // namespace vbm::impl
