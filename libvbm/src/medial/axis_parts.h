// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a medial axis: its sheets, level by level from the border (thesis 7.5.1).
#pragma once

#include "medial/axis_cells.h"

#include <vbm/vbm.h>

#include <cstdint>
#include <vector>

namespace vbm::impl {

/// What is left of an axis, one byte a cell. A border of every cell left is left too.
struct AxisState {
  std::vector<uint8_t> triangle, edge, vertex;
};

/// Everything.
AxisState whole_axis(const AxisCells &cells);

/// A sheet's triangles hang together across edges that exactly two triangles left share; a curve's
/// edges have no triangle and hang together at vertices that have no other edge.
struct AxisParts {
  std::vector<int32_t> of_triangle, of_edge; // -1: not left; of_edge is -1 for edges of triangles
  std::vector<int32_t> of_vertex;            // the only part at a vertex, or kContact, or kNothing
  std::vector<vbm_part> list;                // `locked` is not decided yet
  static constexpr int32_t kNothing = -1, kContact = -2;
};

AxisParts find_axis_parts(const AxisCells &cells, const AxisState &state, Progress &progress);

} // namespace vbm::impl
