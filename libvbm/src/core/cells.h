// SPDX-License-Identifier: GPL-3.0-or-later
// A tetrahedralisation as plain arrays.
#pragma once

#include "core/vec3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

/// The Delaunay tetrahedra of the samples and of the eight corners of a box far around them. Vertex
/// v is sample v for v < samples, and box corner v - samples beyond. All tetrahedra are positively
/// oriented: orientation(v0, v1, v2, v3) > 0, so that facet i, seen from vertex i, is clockwise.
struct Cells {
  int32_t samples = 0;
  std::array<Vec3, 8> corner; // box corners, unit frame
  std::vector<std::array<int32_t, 4>> vertex;
  std::vector<std::array<int32_t, 4>> neighbor; // opposite vertex i; -1 beyond the box

  std::size_t size() const { return vertex.size(); }
  bool has_corner(std::size_t c) const {
    for (int32_t v : vertex[c])
      if (v >= samples) return true;
    return false;
  }
};

/// Vertex indices (0..3) of facet i, counter-clockwise seen from outside the tetrahedron.
inline constexpr int kFacet[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

} // namespace vbm::impl
