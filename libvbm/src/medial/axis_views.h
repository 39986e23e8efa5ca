// SPDX-License-Identifier: GPL-3.0-or-later
// From an axis's state to the arrays its handle shows.
#pragma once

#include "medial/axis.h"
#include "medial/topology_graph.h"

namespace vbm::impl {

/// Fill everything of `axis` after `parts`, and the parts' positions. `pieces` of the axis have a
/// part.
void fill_views(Axis &axis, const TopologyGraph &graph, std::size_t pieces, Progress &progress);

} // namespace vbm::impl
