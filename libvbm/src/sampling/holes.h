// SPDX-License-Identifier: GPL-3.0-or-later
// The loops along which an open mesh ends.
#pragma once

#include "sampling/triangle_mesh.h"

namespace vbm::impl {

struct Holes {
  std::size_t loops = 0;
  std::vector<int32_t> side;   // sides of edges with one face, ascending by edge
  std::vector<int32_t> loop;   // per entry of `side` the loop it is in
  std::vector<uint8_t> closes; // per loop: it runs round without meeting an edge of three or more
                               // sides, and in one direction
};

/// Follow the border round each of its vertices over the faces there, so that loops that only touch
/// at a vertex count apart. Linear.
Holes find_holes(const TriangleMesh &mesh);

/// The triangles that would close loop after loop: a fan round the middle of its vertices, which is
/// appended to `position`. `loop_of_cap` says whose each is; loops that do not close get none.
std::vector<Triangle> cap_holes(const TriangleMesh &mesh, const Holes &holes,
                                std::vector<Vec3> &position, std::vector<int32_t> &loop_of_cap);

} // namespace vbm::impl
