// SPDX-License-Identifier: GPL-3.0-or-later
// A simplicial complex whose vertices are balls, as plain arrays.
#pragma once

#include "medial/axis_parts.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

struct BallComplex {
  std::vector<Ball> ball;                       // unit frame
  std::vector<std::array<int32_t, 3>> triangle; // ball indices
  std::vector<std::array<int32_t, 2>> edge;     // of no triangle

  std::size_t primitives() const { return triangle.size() + edge.size(); }
};

/// What is left of an axis. `number`, if not null, receives the ball of every vertex of the axis,
/// or -1.
BallComplex complex_of(const AxisCells &cells, const AxisState &state,
                       std::vector<int32_t> *number = nullptr);

/// All edges, those of triangles too: ends ascending, no edge twice, sorted.
std::vector<std::array<int32_t, 2>> all_edges(const BallComplex &complex);

} // namespace vbm::impl
