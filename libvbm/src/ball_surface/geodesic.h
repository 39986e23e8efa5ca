// SPDX-License-Identifier: GPL-3.0-or-later
// Points spread evenly over a sphere, and the triangles between them.
#pragma once

#include "core/vec3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

struct Geodesic {
  std::vector<Vec3> points;                      // unit vectors: 10 f^2 + 2
  std::vector<std::array<int32_t, 3>> triangles; // counter-clockwise seen from outside
  double spacing = 0;                            // radians: about the length of an edge
};

/// An icosahedron whose edges are cut into so many pieces that no triangle's middle is farther
/// below the sphere than `bulge`, in radii.
Geodesic geodesic_sphere(double bulge);

} // namespace vbm::impl
