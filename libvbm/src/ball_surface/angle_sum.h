// SPDX-License-Identifier: GPL-3.0-or-later
// Angles added up as products of complex numbers: one arc tangent for all of them.
#pragma once

#include <cmath>

namespace vbm::impl {

class AngleSum {
public:
  /// The angle of (x, y) from the x axis, y not negative: 0 to pi. Nothing for (0, 0).
  void add(double x, double y) {
    const double u = x_ * x - y_ * y, v = x_ * y + y_ * x;
    const double size = std::fabs(u) + std::fabs(v);
    if (!(size > 0)) return;
    take(u / size, v / size);
  }
  void add(const AngleSum &other) {
    halves_ += other.halves_;
    add(other.x_, other.y_);
  }
  double sum() const { return std::atan2(y_, x_) + kPi * halves_; }

private:
  /// What is left is between 0 and a half turn; a sum of two such needs one taken off at most.
  void take(double x, double y) {
    const bool over = y < 0 || (y == 0 && x < 0);
    x_ = over ? -x : x;
    y_ = over ? -y : y;
    halves_ += over;
  }

  static constexpr double kPi = 3.14159265358979323846;

  double x_ = 1, y_ = 0;
  int halves_ = 0;
};

} // namespace vbm::impl
