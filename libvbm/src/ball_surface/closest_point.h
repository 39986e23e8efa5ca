// SPDX-License-Identifier: GPL-3.0-or-later
// The point of a segment, triangle or tetrahedron that is nearest to another point.
#pragma once

#include "core/vec3.h"

#include <algorithm>

namespace vbm::impl {

inline Vec3 closest_on_segment(const Vec3 &p, const Vec3 &a, const Vec3 &b) {
  const Vec3 ab = b - a;
  const double square = dot(ab, ab);
  return square > 0 ? a + ab * std::clamp(dot(p - a, ab) / square, 0.0, 1.0) : a;
}

inline Vec3 closest_on_triangle(const Vec3 &p, const Vec3 &a, const Vec3 &b, const Vec3 &c) {
  const Vec3 n = cross(b - a, c - a), corner[3] = {a, b, c};
  const double square = dot(n, n);
  bool within = square > 0;
  for (int i = 0; i < 3 && within; ++i) {
    const Vec3 &u = corner[i], &v = corner[(i + 1) % 3];
    within = dot(cross(v - u, p - u), n) >= 0;
  }
  if (within) return p - n * (dot(n, p - a) / square);
  Vec3 best = closest_on_segment(p, a, b);
  for (const Vec3 &q : {closest_on_segment(p, b, c), closest_on_segment(p, c, a)})
    if (dot(q - p, q - p) < dot(best - p, best - p)) best = q;
  return best;
}

/// Of a positively oriented tetrahedron.
inline Vec3 closest_on_tetrahedron(const Vec3 &p, const Vec3 (&v)[4]) {
  constexpr int kFace[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  Vec3 best = p;
  double least = -1;
  for (const int(&f)[3] : kFace) {
    const Vec3 &a = v[f[0]], &b = v[f[1]], &c = v[f[2]];
    if (dot(cross(b - a, c - a), p - a) <= 0) continue;
    const Vec3 q = closest_on_triangle(p, a, b, c);
    if (const double d = dot(q - p, q - p); least < 0 || d < least) best = q, least = d;
  }
  return best;
}

} // namespace vbm::impl
