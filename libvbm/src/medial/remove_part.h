// SPDX-License-Identifier: GPL-3.0-or-later
// Taking parts off a medial axis where that cannot change its topology (thesis 7.5.3).
#pragma once

#include "medial/axis_parts.h"

#include <cstdint>
#include <vector>

namespace vbm::impl {

/// The cells that went with one part.
struct Removal {
  std::vector<int32_t> triangles, edges, vertices;
};

/// Removes parts from a state, one after another; each costs as much as its cells.
class Remover {
public:
  /// `parts` are the state's when this is made; all must outlive it.
  Remover(const AxisCells &cells, const AxisParts &parts, AxisState &state);

  /// Remove a part if its cells collapse onto the rest (see locks.cpp); if not, nothing is changed.
  /// Returns whether it went.
  bool remove(int32_t part, Removal &removal);

private:
  void visit_edge(int32_t e, int32_t part);
  void visit_vertex(int32_t v);

  const AxisCells &cells_;
  const AxisParts &parts_;
  AxisState &state_;
  int32_t attempt_ = 0;
  std::vector<int32_t> own_edge_,
      seen_vertex_;      // the last attempt it was the part's own, or looked at
  Removal own_;          // cells that only the part looked at has
  bool border_ = false;  // it has a free edge or end
  bool touches_ = false; // it has cells that others have too
};

} // namespace vbm::impl
