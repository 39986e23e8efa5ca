// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 7.5.3: contact curves are polylines shared by touching parts, and those that are connected
// are one node, so that a ring of parts about a common point makes no cycle.
#include "medial/topology_graph.h"

#include "core/disjoint_sets.h"

#include <algorithm>

namespace vbm::impl {

TopologyGraph topology_graph(const AxisCells &cells, const AxisParts &parts) {
  constexpr int32_t kContact = AxisParts::kContact;
  std::vector<int32_t> contact, number(cells.ball.size(), -1); // vertices of contact curves
  for (int32_t v = 0; v < int32_t(cells.ball.size()); ++v)
    if (parts.of_vertex[v] == kContact) {
      number[v] = int32_t(contact.size());
      contact.push_back(v);
    }
  TopologyGraph graph;
  DisjointSets sets(contact.size());
  std::vector<std::pair<int32_t, int32_t>> touch; // part, contact vertex
  for (std::size_t e = 0; e < cells.edge.size(); ++e) {
    if (parts.of_edge[e] == AxisParts::kNothing) continue;
    const int32_t a = number[cells.edge[e][0]], b = number[cells.edge[e][1]];
    if (parts.of_edge[e] >= 0) {
      if (a >= 0) touch.push_back({parts.of_edge[e], a});
      if (b >= 0) touch.push_back({parts.of_edge[e], b});
      continue;
    }
    sets.unite(a, b);
    graph.contact_edge.push_back(int32_t(e));
    graph.contact_node.push_back(a);
    for (uint64_t k = cells.edge_triangles.offset[e]; k < cells.edge_triangles.offset[e + 1]; ++k)
      if (const int32_t p = parts.of_triangle[cells.edge_triangles.index[k]]; p >= 0)
        touch.push_back({p, a});
  }

  std::size_t count = 0;
  const std::vector<int32_t> node = sets.numbers(count);
  graph.node.resize(count);
  std::vector<int32_t> members(count, 0);
  for (std::size_t i = 0; i < contact.size(); ++i) {
    graph.node[node[i]] += cells.ball[contact[i]].center;
    ++members[node[i]];
  }
  for (std::size_t n = 0; n < count; ++n) graph.node[n] = graph.node[n] * (1.0 / members[n]);

  for (int32_t &at : graph.contact_node) at = node[at];
  for (auto &[part, at] : touch) at = node[at];
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
