// SPDX-License-Identifier: GPL-3.0-or-later
// The frame all computing is done in: the input moved and scaled into a box of about unit size.
#pragma once

#include "core/vec3.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace vbm::impl {

/// std::ldexp, quicker: the power of two is a double for all but absurd exponents, and multiplying
/// by it rounds as ldexp does.
inline double scaled(double x, int exponent) {
  if (exponent < -1022 || exponent > 1023) return std::ldexp(x, exponent);
  const uint64_t bits = uint64_t(exponent + 1023) << 52;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return x * power;
}

/// unit = ldexp(input, -exponent) - center. Scaling by a power of two is exact and comes first, so
/// that neither 1e300 nor 1e-300 overflows or loses digits on the way; `center` is in scaled units.
struct Frame {
  int exponent = 0;
  Vec3 center;

  Vec3 to_unit(const Vec3 &p) const {
    return Vec3{scaled(p.x, -exponent), scaled(p.y, -exponent), scaled(p.z, -exponent)} - center;
  }
  Vec3 to_input(const Vec3 &u) const {
    const Vec3 p = u + center;
    return {scaled(p.x, exponent), scaled(p.y, exponent), scaled(p.z, exponent)};
  }
  double length_to_input(double l) const { return scaled(l, exponent); }
  double length_to_unit(double l) const { return scaled(l, -exponent); }
};

/// The frame in which finite points (count x 3 doubles; others are ignored) have a largest box side
/// in [0.5, 1] around 0. Points that are all the same give a frame of exponent that keeps them near
/// 0.
Frame frame_of(const double *points, std::size_t count);

} // namespace vbm::impl
