// SPDX-License-Identifier: GPL-3.0-or-later
// Directions spread evenly over the sphere.
#pragma once

#include "core/vec3.h"

#include <vector>

namespace vbm::impl {

struct Directions {
  std::vector<Vec3> list;
  double angle = 0; // radians: every direction is within this of one in the list
};

/// The vertices of an icosahedron whose triangles were cut in four `cuts` times: 12, 42, 162, 642 ...
Directions icosahedral_directions(int cuts);

} // namespace vbm::impl
