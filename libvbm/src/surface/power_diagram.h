// SPDX-License-Identifier: GPL-3.0-or-later
// The power diagram of balls, as its dual: the regular triangulation of their centres.
#pragma once

#include "core/large_list.h"
#include "core/model.h"
#include "surface/power_predicates.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// Tetrahedra of balls, positively oriented. Ball b is balls[b] for b < balls.size(); beyond stand
/// the four corners of a tetrahedron far around all balls, so that every ball's cell is bounded and
/// no tetrahedron is infinite.
struct PowerDiagram {
  struct alignas(32) Cell {      // two to a cache line, none across two
    std::array<int32_t, 4> ball; // ball[0] < 0: no cell
    std::array<int32_t, 4>
        neighbor; // opposite ball i: its index * 4 + the facet there; < 0 outside
  };
  LargeList<Cell> cells;
  std::array<Vec3, 4> corner;  // of the far tetrahedron: weight 0
  std::vector<int32_t> hidden; // balls without a cell, ascending
};

/// Ball number b as the diagram sees it: on kSiteGrid, and with another radius (kPowerChange).
Site changed_site(const Ball &ball, int32_t b, bool inner);

/// The first `inner` balls are inner ones: where inner and outer balls only touch, the outer ones
/// have the space between them. Ticks each ball. Throws Error(VBM_ERROR_LIMIT) beyond half a
/// billion tetrahedra.
PowerDiagram power_diagram(const std::vector<Ball> &balls, std::size_t inner, Progress &progress);

} // namespace vbm::impl
