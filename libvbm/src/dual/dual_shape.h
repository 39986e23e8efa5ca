// SPDX-License-Identifier: GPL-3.0-or-later
// The dual shape of a union of balls.
#pragma once

#include "core/large_list.h"
#include "core/model.h"
#include "surface/power_diagram.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// The simplices of the regular triangulation whose balls and power cells have a point in common:
/// the alpha complex at 0. It has the homotopy type of the union.
struct DualShape {
  /// Seen from side 1, its balls are counter-clockwise.
  struct Triangle {
    std::array<int32_t, 3> ball;
    int32_t code;                // 4 * cell + facet: that cell is on side 0
    std::array<uint8_t, 2> open; // whether the tetrahedron on side 0, side 1 is not in the shape
  };
  /// A triangle met when turning about an edge.
  struct Turn {
    uint32_t code; // 4 * triangle + 2 * side + outside
    int32_t triangle() const { return int32_t(code >> 2); }
    /// Of the triangle, on which what is behind it is.
    int side() const { return int(code >> 1 & 1); }
    /// Whether what is behind, up to the next turn, is not in the shape.
    bool outside() const { return code & 1; }
  };
  /// Its turns are turns[begin] to turns[end - 1], counter-clockwise seen along the edge backwards
  /// (by the right hand about a to b).
  struct Edge {
    int32_t a, b;
    int32_t cell; // one of its tetrahedra
    uint32_t begin, end;
  };

  std::vector<Site> site;      // the balls as the diagram sees them, unit frame
  std::vector<uint8_t> vertex; // per ball: 1 if it is in the shape
  std::array<Vec3, 4> corner;  // of the far tetrahedron: number vertex.size() and on
  LargeList<PowerDiagram::Cell> cells;
  std::vector<uint8_t> cell_in;  // per cell of the diagram: 1 if it is in the shape
  std::vector<uint8_t> facet_in; // per cell, bit i: facet i is in the shape
  LargeList<Triangle> triangles;
  LargeList<Edge> edges;
  LargeList<Turn> turns;

  /// The one of a turn's triangle that is not the edge's.
  int32_t ball_of(const Edge &e, uint32_t turn) const {
    const std::array<int32_t, 3> &b = triangles[turns[turn].triangle()].ball;
    return b[0] ^ b[1] ^ b[2] ^ e.a ^ e.b;
  }
  /// The tetrahedron behind it.
  int32_t cell_of(uint32_t turn) const {
    const int32_t code = triangles[turns[turn].triangle()].code;
    return turns[turn].side() ? cells[code >> 2].neighbor[code & 3] >> 2 : code >> 2;
  }

  bool real(int32_t ball) const { return std::size_t(ball) < vertex.size(); } // no far corner
  Vec3 position(int32_t ball) const {
    return real(ball) ? Vec3{site[ball].x, site[ball].y, site[ball].z}
                      : corner[ball - vertex.size()];
  }
};

/// Of balls in a frame in which they reach no farther than about 1 from the origin. Their radii are
/// taken a little larger: by kTouch of themselves, `touch` in unit lengths, and kPowerChange.
DualShape dual_shape(const std::vector<Ball> &balls, double touch, Progress &progress);

/// For turning about an edge of a positively oriented tetrahedron: [i][j] is the k for which (i, j,
/// k, l) is an even permutation of (0, 1, 2, 3). Turning about the edge from i to j, a tetrahedron
/// is entered by the facet opposite l and left by the one opposite k.
inline constexpr int kTurn[4][4] = {{-1, 2, 3, 1}, {3, -1, 0, 2}, {1, 3, -1, 0}, {2, 0, 1, -1}};

inline int index_of(const PowerDiagram::Cell &c, int32_t ball) {
  return (c.ball[1] == ball) + 2 * (c.ball[2] == ball) + 3 * (c.ball[3] == ball);
}

} // namespace vbm::impl
