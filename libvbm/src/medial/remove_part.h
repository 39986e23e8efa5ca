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

/// Removes parts from a state, one after another. Numbers of triangles and edges at each cell are
/// kept up to date, so that a part costs as much as its cells.
class Remover {
public:
  /// `parts` are the state's when this is made; both must outlive it.
  Remover(const AxisCells &cells, const AxisParts &parts, AxisState &state);

  /// Remove a part by elementary collapses; if there is no way to, nothing is changed and the
  /// reason is returned.
  vbm_lock remove(int32_t part, Removal &removal);
  /// Whether remove() would; nothing is changed.
  vbm_lock test(int32_t part);

private:
  vbm_lock collapse(int32_t part);
  void collapse_triangles(int32_t part);
  void collapse_edges();
  void drop_triangle(int32_t t);
  void drop_edge(int32_t e);
  void undo();
  bool has_cycle() const;
  bool ends_meet() const;

  const AxisCells &cells_;
  const AxisParts &parts_;
  AxisState &state_;
  Incidence part_triangles_, part_edges_;
  std::vector<int32_t> triangles_at_, edges_at_; // per edge, per vertex: those left
  std::vector<int32_t> own_; // edges of the part looked at that have no triangle any more
  Removal removal_;
};

} // namespace vbm::impl
