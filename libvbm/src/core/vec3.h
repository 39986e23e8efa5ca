// SPDX-License-Identifier: GPL-3.0-or-later
// Three doubles and the arithmetic on them.
#pragma once

#include <cmath>

namespace vbm::impl {

struct Vec3 {
  double x = 0, y = 0, z = 0;

  double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  double &operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
};

inline Vec3 operator+(const Vec3 &a, const Vec3 &b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3 &a, const Vec3 &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator-(const Vec3 &a) { return {-a.x, -a.y, -a.z}; }
inline Vec3 operator*(const Vec3 &a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vec3 operator*(double s, const Vec3 &a) { return a * s; }
inline Vec3 &operator+=(Vec3 &a, const Vec3 &b) { return a = a + b; }
inline bool operator==(const Vec3 &a, const Vec3 &b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

inline double dot(const Vec3 &a, const Vec3 &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3 &a, const Vec3 &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec3 &a) { return std::sqrt(dot(a, a)); }
inline double distance(const Vec3 &a, const Vec3 &b) { return length(a - b); }

/// a / |a|, or zero if a is zero.
inline Vec3 unit(const Vec3 &a) {
  const double l = length(a);
  return l > 0 ? a * (1 / l) : Vec3{};
}

inline bool is_finite(const Vec3 &a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

} // namespace vbm::impl
