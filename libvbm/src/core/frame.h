// SPDX-License-Identifier: GPL-3.0-or-later
// The frame all computing is done in: the input moved and scaled into a box of about unit size.
#pragma once

#include "core/vec3.h"

#include <cstddef>

namespace vbm::impl {

/// unit = ldexp(input, -exponent) - center. Scaling by a power of two is exact and comes first, so
/// that neither 1e300 nor 1e-300 overflows or loses digits on the way; `center` is in scaled units.
struct Frame {
  int exponent = 0;
  Vec3 center;

  Vec3 to_unit(const Vec3 &p) const {
    return Vec3{std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent),
                std::ldexp(p.z, -exponent)} -
           center;
  }
  Vec3 to_input(const Vec3 &u) const {
    const Vec3 p = u + center;
    return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
  }
  double length_to_input(double l) const { return std::ldexp(l, exponent); }
  double length_to_unit(double l) const { return std::ldexp(l, -exponent); }
};

/// The frame in which finite points (count x 3 doubles; others are ignored) have a largest box side
/// in [0.5, 1] around 0. Points that are all the same give a frame of exponent that keeps them near
/// 0.
Frame frame_of(const double *points, std::size_t count);

} // namespace vbm::impl
