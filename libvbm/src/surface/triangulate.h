// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons of a closed mesh cut into triangles.
#pragma once

#include "core/model.h"

#include <array>
#include <vector>

namespace vbm::impl {

class Progress;

struct Triangles {
  std::vector<std::array<int32_t, 3>> corners;
  std::vector<int32_t> polygon; // of each triangle
  std::vector<int32_t> cut;     // polygons that need a vertex in their middle, ascending
};

/// Cuts polygons (nearly planar, nearly convex, each edge run through once in each direction) so
/// that the smallest angles are as large as they can be, and so that no edge comes to lie in four
/// triangles. Polygons in `cut` are triangles between each edge and one new vertex: position.size()
/// for the first of them, and so on. Triangles come polygon by polygon.
Triangles triangulate(const std::vector<Vec3> &position, const Incidence &polygons,
                      Progress &progress);

} // namespace vbm::impl
