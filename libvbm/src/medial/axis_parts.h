// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a medial axis: its sheets, level by level from the border (thesis 7.5.1).
#pragma once

#include "medial/axis_cells.h"

#include <vbm/vbm.h>

#include <cstdint>
#include <vector>

namespace vbm::impl {

/// What is left of an axis, one byte a cell, and one an inner ball of the model for
/// its twig. A border of every cell left is left too.
struct AxisState {
  std::vector<uint8_t> triangle, edge, vertex, twig;
};

/// Per inner ball of the model whether it is left: its vertex and its twig.
std::vector<uint8_t> kept_balls(const AxisCells &cells, const AxisState &state);

/// Everything.
AxisState whole_axis(const AxisCells &cells);

/// A sheet's triangles hang together across edges that exactly two triangles left share; a curve's
/// edges have no triangle and hang together at vertices that have no other edge.
struct AxisParts {
  static constexpr int32_t kNothing = -1, kContact = -2;
  std::vector<int32_t> of_triangle; // kNothing: not left
  std::vector<int32_t> of_edge;     // the only part at an edge, or kContact, or kNothing
  std::vector<int32_t> of_vertex;   // the same
  std::vector<vbm_part> list;       // without locks and positions
  Incidence triangles, curve_edges; // per part
  std::vector<int32_t> euler;       // per part: its vertices - edges + triangles that no other has
  std::vector<Vec3> middle;         // per part: of its triangles by area, of its edges by length

  bool is_curve(int32_t edge) const {
    return of_edge[edge] >= 0 && list[of_edge[edge]].triangles == 0;
  }
};

AxisParts find_axis_parts(const AxisCells &cells, const AxisState &state, Progress &progress);

} // namespace vbm::impl
