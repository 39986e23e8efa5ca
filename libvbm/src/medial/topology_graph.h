// SPDX-License-Identifier: GPL-3.0-or-later
// The topology graph of a medial axis (thesis 7.5.3, Figures 7.8, 7.9, 7.11).
#pragma once

#include "medial/axis_parts.h"

namespace vbm::impl {

/// Nodes are connected pieces of contact, where parts meet; every part is an edge, or a star,
/// between the nodes it touches.
struct TopologyGraph {
  std::vector<Vec3> node; // the middle of its contact vertices, unit frame
  Incidence part_nodes;   // per part, ascending
  // Edges of contact, ascending, and the node of each. Curves touch others at vertices only.
  std::vector<int32_t> contact_edge, contact_node;
};

TopologyGraph topology_graph(const AxisCells &cells, const AxisParts &parts);

} // namespace vbm::impl
