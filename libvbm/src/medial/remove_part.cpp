// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis looks for loops in a graph of parts. Here a part goes if and only if its cells
// collapse onto the rest: free edges take their triangles along until none is left, then ends of
// dangling edges take those. A part is a surface, so no order of collapses gets farther than
// another, and what cannot be collapsed shows what would be lost.
#include "medial/remove_part.h"

#include "core/disjoint_sets.h"
#include "medial/cell_lists.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace vbm::impl {

Remover::Remover(const AxisCells &cells, const AxisParts &parts, AxisState &state)
    : cells_(cells), parts_(parts), state_(state), triangles_at_(cells.edge.size(), 0),
      edges_at_(cells.ball.size(), 0) {
  const auto by_part = [&](const std::vector<int32_t> &part_of) {
    return lists_of(parts.list.size(), part_of.size(), [&](std::size_t i, auto &&call) {
      if (part_of[i] >= 0) call(part_of[i]);
    });
  };
  part_triangles_ = by_part(parts.of_triangle);
  part_edges_ = by_part(parts.of_edge);
  for (std::size_t t = 0; t < cells.triangle.size(); ++t)
    if (state.triangle[t])
      for (int32_t e : cells.triangle_edges[t]) ++triangles_at_[e];
  for (std::size_t e = 0; e < cells.edge.size(); ++e)
    if (state.edge[e])
      for (int32_t v : cells.edge[e]) ++edges_at_[v];
}

vbm_lock Remover::remove(int32_t part, Removal &removal) {
  const vbm_lock lock = collapse(part);
  if (lock != VBM_LOCK_NONE)
    undo();
  else
    std::swap(removal, removal_);
  removal_ = Removal();
  return lock;
}

vbm_lock Remover::test(int32_t part) {
  const vbm_lock lock = collapse(part);
  undo();
  removal_ = Removal();
  return lock;
}

vbm_lock Remover::collapse(int32_t part) {
  if (parts_.list[part].level != 1) return VBM_LOCK_INNER;
  own_.clear();
  collapse_triangles(part);
  for (uint64_t k = part_triangles_.offset[part]; k < part_triangles_.offset[part + 1]; ++k)
    if (state_.triangle[part_triangles_.index[k]]) return VBM_LOCK_INNER;
  for (uint64_t k = part_edges_.offset[part]; k < part_edges_.offset[part + 1]; ++k)
    if (state_.edge[part_edges_.index[k]]) own_.push_back(part_edges_.index[k]);
  collapse_edges();
  const auto gone = [&](int32_t e) { return !state_.edge[e]; };
  own_.erase(std::remove_if(own_.begin(), own_.end(), gone), own_.end());
  if (own_.empty()) {
    // A vertex without any edge is what is left of the piece of the axis this was.
    for (int32_t e : removal_.edges)
      for (int32_t v : cells_.edge[e])
        if (state_.vertex[v] && edges_at_[v] == 0) return VBM_LOCK_LAST;
    return VBM_LOCK_NONE;
  }
  return has_cycle() || ends_meet() ? VBM_LOCK_TUNNEL : VBM_LOCK_BRIDGE;
}

void Remover::drop_triangle(int32_t t) {
  state_.triangle[t] = 0;
  removal_.triangles.push_back(t);
  for (int32_t e : cells_.triangle_edges[t]) --triangles_at_[e];
}

void Remover::drop_edge(int32_t e) {
  state_.edge[e] = 0;
  removal_.edges.push_back(e);
  for (int32_t v : cells_.edge[e]) --edges_at_[v];
}

void Remover::collapse_triangles(int32_t part) {
  std::vector<int32_t> free;
  const auto offer = [&](int32_t e) {
    if (state_.edge[e] && triangles_at_[e] == 1) free.push_back(e);
  };
  for (uint64_t k = part_triangles_.offset[part]; k < part_triangles_.offset[part + 1]; ++k)
    if (state_.triangle[part_triangles_.index[k]])
      for (int32_t e : cells_.triangle_edges[part_triangles_.index[k]]) offer(e);
  while (!free.empty()) {
    const int32_t e = free.back();
    free.pop_back();
    if (!state_.edge[e] || triangles_at_[e] != 1) continue;
    int32_t t = -1;
    for (uint64_t k = cells_.edge_triangles.offset[e]; k < cells_.edge_triangles.offset[e + 1]; ++k)
      if (state_.triangle[cells_.edge_triangles.index[k]]) t = cells_.edge_triangles.index[k];
    if (parts_.of_triangle[t] != part) continue;
    drop_triangle(t);
    drop_edge(e);
    for (int32_t other : cells_.triangle_edges[t]) {
      if (!state_.edge[other]) continue;
      offer(other);
      if (triangles_at_[other] == 0) own_.push_back(other);
    }
  }
}

void Remover::collapse_edges() {
  std::vector<int32_t> ends;
  const auto offer = [&](int32_t v) {
    if (state_.vertex[v] && edges_at_[v] == 1) ends.push_back(v);
  };
  const std::unordered_set<int32_t> own(own_.begin(), own_.end());
  for (int32_t e : own_)
    for (int32_t v : cells_.edge[e]) offer(v);
  while (!ends.empty()) {
    const int32_t v = ends.back();
    ends.pop_back();
    if (!state_.vertex[v] || edges_at_[v] != 1) continue;
    for (uint64_t k = cells_.vertex_edges.offset[v]; k < cells_.vertex_edges.offset[v + 1]; ++k) {
      const int32_t e = cells_.vertex_edges.index[k];
      if (!state_.edge[e]) continue;
      if (!own.count(e) || triangles_at_[e] != 0) break;
      state_.vertex[v] = 0;
      removal_.vertices.push_back(v);
      drop_edge(e);
      for (int32_t w : cells_.edge[e]) offer(w);
      break;
    }
  }
}

void Remover::undo() {
  for (int32_t v : removal_.vertices) state_.vertex[v] = 1;
  for (int32_t e : removal_.edges) {
    state_.edge[e] = 1;
    for (int32_t v : cells_.edge[e]) ++edges_at_[v];
  }
  for (int32_t t : removal_.triangles) {
    state_.triangle[t] = 1;
    for (int32_t e : cells_.triangle_edges[t]) ++triangles_at_[e];
  }
}

/// Whether the edges that are left of the part hold a ring.
bool Remover::has_cycle() const {
  std::unordered_map<int32_t, int32_t> number;
  for (int32_t e : own_)
    for (int32_t v : cells_.edge[e]) number.emplace(v, int32_t(number.size()));
  DisjointSets sets(number.size());
  for (int32_t e : own_)
    if (!sets.unite(number.at(cells_.edge[e][0]), number.at(cells_.edge[e][1]))) return true;
  return false;
}

/// Whether the rest of the axis joins two places that the edges left of the part join: searched
/// from each such place until it meets another's.
bool Remover::ends_meet() const {
  const std::unordered_set<int32_t> own(own_.begin(), own_.end());
  DisjointSets joined(cells_.ball.size());
  for (std::size_t e = 0; e < cells_.edge.size(); ++e)
    if (state_.edge[e] && !own.count(int32_t(e)))
      joined.unite(cells_.edge[e][0], cells_.edge[e][1]);
  for (int32_t e : own_)
    if (!joined.unite(cells_.edge[e][0], cells_.edge[e][1])) return true;
  return false;
}

} // namespace vbm::impl
