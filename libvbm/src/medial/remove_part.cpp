// SPDX-License-Identifier: GPL-3.0-or-later
// What goes with a part are the cells it has to itself at that time: others may have gone before,
// and left it what they shared. Whether it may go is counted as in locks.cpp.
#include "medial/remove_part.h"

#include "medial/locks.h"

#include <utility>

namespace vbm::impl {

Remover::Remover(const AxisCells &cells, const AxisParts &parts, AxisState &state)
    : cells_(cells), parts_(parts), state_(state), own_edge_(cells.edge.size(), 0),
      seen_vertex_(cells.ball.size(), 0) {}

void Remover::visit_edge(int32_t e, int32_t part) {
  if (own_edge_[e] == attempt_) return;
  int triangles = 0;
  for (uint64_t k = cells_.edge_triangles.offset[e]; k < cells_.edge_triangles.offset[e + 1]; ++k) {
    const int32_t t = cells_.edge_triangles.index[k];
    if (!state_.triangle[t]) continue;
    ++triangles;
    if (parts_.of_triangle[t] == part) continue;
    touches_ = true;
    return;
  }
  border_ |= triangles == 1;
  own_edge_[e] = attempt_;
  own_.edges.push_back(e);
}

void Remover::visit_vertex(int32_t v) {
  if (seen_vertex_[v] == attempt_) return;
  seen_vertex_[v] = attempt_;
  int edges = 0;
  for (uint64_t k = cells_.vertex_edges.offset[v]; k < cells_.vertex_edges.offset[v + 1]; ++k) {
    const int32_t e = cells_.vertex_edges.index[k];
    if (!state_.edge[e]) continue;
    ++edges;
    if (own_edge_[e] == attempt_) continue;
    touches_ = true;
    return;
  }
  border_ |= edges == 1;
  own_.vertices.push_back(v);
}

bool Remover::remove(int32_t part, Removal &removal) {
  ++attempt_;
  own_ = Removal();
  border_ = touches_ = false;
  const auto own = [&](const Incidence &lists) {
    return std::pair(lists.index.begin() + int64_t(lists.offset[part]),
                     lists.index.begin() + int64_t(lists.offset[part + 1]));
  };
  const auto [triangle, triangles_end] = own(parts_.triangles);
  if (triangle != triangles_end && !state_.triangle[*triangle]) return false; // gone
  own_.triangles.assign(triangle, triangles_end);
  for (int32_t t : own_.triangles)
    for (int32_t e : cells_.triangle_edges[t]) visit_edge(e, part);
  const auto [edge, edges_end] = own(parts_.curve_edges);
  for (auto e = edge; e != edges_end; ++e) {
    if (!state_.edge[*e]) return false; // gone
    own_edge_[*e] = attempt_;
    own_.edges.push_back(*e);
  }
  for (int32_t e : own_.edges)
    for (int32_t v : cells_.edge[e]) visit_vertex(v);
  const auto euler = int32_t(own_.vertices.size() + own_.triangles.size() - own_.edges.size());
  if (!border_ || !may_go(euler, touches_)) return false;
  for (int32_t t : own_.triangles) state_.triangle[t] = 0;
  for (int32_t e : own_.edges) state_.edge[e] = 0;
  for (int32_t v : own_.vertices) state_.vertex[v] = 0;
  std::swap(removal, own_);
  return true;
}

} // namespace vbm::impl
