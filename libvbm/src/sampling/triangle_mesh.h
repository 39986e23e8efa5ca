// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles over samples, and the edges between them.
#pragma once

#include "core/vec3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

using Triangle = std::array<int32_t, 3>;

/// An edge, a < b, and its sides: entries begin to end of TriangleMesh::side. The balance is the
/// number of sides that run from a to b less those from b to a: 0 where the surface goes on.
struct Edge {
  int32_t a, b, begin, end, balance;
  int32_t faces() const { return end - begin; }
};

/// Triangles and their edges. A side is 3 * triangle + corner: the side of that triangle from this
/// corner to the next. Edges ascend by (a, b), the sides of an edge by number.
struct TriangleMesh {
  std::vector<Triangle> triangle;
  std::vector<Edge> edge;
  std::vector<int32_t> side;
  std::vector<int32_t> edge_of_side;

  int32_t start(int32_t side_) const { return triangle[side_ / 3][side_ % 3]; }
  /// +1 if the side runs from its edge's a to b, else -1.
  int direction(int32_t side_) const {
    return start(side_) == edge[edge_of_side[side_]].a ? 1 : -1;
  }
  /// The triangle beyond an edge of two sides.
  int32_t other(const Edge &e, int32_t t) const {
    return side[e.begin] / 3 == t ? side[e.begin + 1] / 3 : side[e.begin] / 3;
  }
  /// Turn a triangle's front to the back; edges and sides stay right.
  void turn(int32_t t);
};

/// What remove_double_faces() found.
struct DoubleFaces {
  std::size_t repeated = 0;  // removed, because the same triangle was there already
  std::size_t cancelled = 0; // removed with a triangle of opposite direction
  bool sheet = false;        // all cancelled, and one of each pair was kept
};

/// Keep one of every set of triangles that are the same up to rotation. Triangles that are each
/// other's reverse cancel, for there is no volume between them; if that would leave nothing, one of
/// each pair stays. The order of the others is kept.
DoubleFaces remove_double_faces(std::vector<Triangle> &triangles, std::size_t vertices);

/// Find edge, side and edge_of_side from triangle. Linear but for sorting the edges of one vertex.
/// Returns whether two triangles may have the same three corners.
bool find_edges(TriangleMesh &mesh, std::size_t vertices, Progress &progress);

} // namespace vbm::impl
