// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 7.5.3: contact curves are polylines shared by touching parts, and those that are connected
// are one node, so that a ring of parts about a common point makes no cycle.
#include "medial/topology_graph.h"

#include "core/disjoint_sets.h"

#include <algorithm>

namespace vbm::impl {

TopologyGraph topology_graph(const AxisCells &cells, const AxisState &state,
                             const AxisParts &parts) {
  const auto is_contact = [&](int32_t v) { return parts.of_vertex[v] == AxisParts::kContact; };
  std::vector<int32_t> triangles_at(cells.edge.size(), 0);
  for (std::size_t t = 0; t < cells.triangle.size(); ++t)
    if (state.triangle[t])
      for (int32_t e : cells.triangle_edges[t]) ++triangles_at[e];
  DisjointSets sets(cells.ball.size());
  for (std::size_t e = 0; e < cells.edge.size(); ++e)
    if (state.edge[e] && (triangles_at[e] > 2 || cells.seam[e]) && is_contact(cells.edge[e][0]) &&
        is_contact(cells.edge[e][1]))
      sets.unite(cells.edge[e][0], cells.edge[e][1]);

  TopologyGraph graph;
  std::vector<int32_t> number(cells.ball.size(), -1);
  std::vector<int32_t> members;
  for (int32_t v = 0; v < int32_t(cells.ball.size()); ++v) {
    if (!is_contact(v)) continue;
    const int32_t root = sets.find(v);
    if (number[root] < 0) {
      number[root] = int32_t(graph.node.size());
      graph.node.push_back({});
      members.push_back(0);
    }
    number[v] = number[root];
    graph.node[number[v]] += cells.ball[v].center;
    ++members[number[v]];
  }
  for (std::size_t n = 0; n < graph.node.size(); ++n)
    graph.node[n] = graph.node[n] * (1.0 / members[n]);

  std::vector<std::pair<int32_t, int32_t>> touch; // part, node
  const auto visit = [&](int32_t v, int32_t part) {
    if (number[v] >= 0 && is_contact(v)) touch.push_back({part, number[v]});
  };
  for (std::size_t t = 0; t < cells.triangle.size(); ++t)
    if (state.triangle[t])
      for (int32_t v : cells.triangle[t]) visit(v, parts.of_triangle[t]);
  for (std::size_t e = 0; e < cells.edge.size(); ++e)
    if (parts.of_edge[e] >= 0)
      for (int32_t v : cells.edge[e]) visit(v, parts.of_edge[e]);
  std::sort(touch.begin(), touch.end());
  touch.erase(std::unique(touch.begin(), touch.end()), touch.end());
  std::size_t next = 0;
  for (std::size_t p = 0; p < parts.list.size(); ++p) {
    for (; next < touch.size() && touch[next].first == int32_t(p); ++next)
      graph.part_nodes.index.push_back(touch[next].second);
    graph.part_nodes.offset.push_back(graph.part_nodes.index.size());
  }
  return graph;
}

} // namespace vbm::impl
