// SPDX-License-Identifier: GPL-3.0-or-later
// The grids that coordinates lie on, for the sake of exact arithmetic (core/exact.h). Their steps
// are below the rounding of all but the smallest coordinates.
#pragma once

#include "core/vec3.h"

#include <cmath>

namespace vbm::impl {

/// Samples in the unit frame and the closing box: multiples of this, differences below 16.
inline constexpr double kSampleGrid = 0x1p-60;
/// Balls and corners of a power diagram: multiples of this, differences below 1024.
inline constexpr double kSiteGrid = 0x1p-54;

/// The multiple of a power of two nearest to x; x itself where doubles are coarser than that.
inline double on_grid(double x, double grid) {
  const double shift = std::copysign(grid * 0x1p52, x); // numbers up to twice this have that step
  return std::fabs(x) < grid * 0x1p52 ? (x + shift) - shift : x;
}

/// The same of each coordinate.
inline Vec3 on_grid(const Vec3 &p, double grid) {
  return {on_grid(p.x, grid), on_grid(p.y, grid), on_grid(p.z, grid)};
}

} // namespace vbm::impl
