// SPDX-License-Identifier: GPL-3.0-or-later
// The power shape of a ball model, and the singular points of its balls.
#pragma once

#include "core/model.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// A place on the boundary of the union of the inner balls where three of them meet.
struct SingularPoint {
  std::array<int32_t, 3> balls;     // ascending
  int32_t sample;                   // that all three touch, so that the point is there; -1: none
  int32_t near_sample, next_sample; // the nearest two of the samples that any of them touches
  Vec3 position;                    // unit frame
  Vec3 outward;                     // unit vector, square to the balls' triangle
};

/// The simplices of the regular triangulation of inner and outer balls whose vertices are all
/// inner: how many there are, and what comes of its boundary.
struct PowerShape {
  uint64_t tetrahedra = 0;
  uint64_t regular = 0;  // triangles of one tetrahedron
  uint64_t singular = 0; // of none
  uint64_t apart =
      0; // sides of triangles whose three balls have no point on the boundary in common
  std::vector<SingularPoint> points; // one for a regular triangle, two for a singular one
};

PowerShape power_shape(const Model &model, Progress &progress);

} // namespace vbm::impl
