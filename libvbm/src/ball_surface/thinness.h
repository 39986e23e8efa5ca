// SPDX-License-Identifier: GPL-3.0-or-later
// How near a triangle is to having no area.
#pragma once

#include "core/vec3.h"

#include <algorithm>

namespace vbm::impl {

/// Squared sine of the smallest angle, 0 of a triangle without an area.
inline double thinness(const Vec3 &a, const Vec3 &b, const Vec3 &c) {
  const Vec3 n = cross(b - a, c - a);
  const double p = dot(b - a, b - a), q = dot(c - b, c - b), r = dot(a - c, a - c);
  const double more = std::max(p, q), less = std::min(p, q);
  const double product = std::max(more, r) * std::max(less, std::min(more, r)); // the longer two
  return product > 0 ? dot(n, n) / product : 0;
}

} // namespace vbm::impl
