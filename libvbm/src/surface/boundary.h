// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary between inside and outside tetrahedra as a closed manifold of triangles.
#pragma once

#include "core/cells.h"
#include "core/progress.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

/// Every facet between an inside and an outside tetrahedron is a triangle. At each of its edges it
/// is joined to the next facet met when turning about the edge through inside tetrahedra; corners
/// joined so are one vertex. So it bounds the solid's open interior: tetrahedra that touch only
/// along an edge or at a vertex are not joined there, and each vertex has one closed fan.
struct Boundary {
  std::vector<int32_t> cell;                    // per triangle, the inside tetrahedron behind it
  std::vector<std::array<int32_t, 3>> triangle; // vertex numbers, counter-clockwise from outside
  std::vector<std::array<int32_t, 3>> mate; // the triangle across the edge from corner e to e + 1
  std::vector<int32_t> sample;              // per vertex
  uint64_t split = 0;                       // vertices at a sample that has one already

  int64_t euler() const { return int64_t(sample.size()) - int64_t(triangle.size()) / 2; }
  uint64_t components(Progress &progress) const;
};

/// `inside` is per cell.
Boundary find_boundary(const Cells &cells, const std::vector<uint8_t> &inside, Progress &progress);

} // namespace vbm::impl
