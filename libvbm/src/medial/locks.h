// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts of a medial axis may go, and why others may not (thesis 7.5.3).
#pragma once

#include "medial/topology_graph.h"

namespace vbm::impl {

/// Whether a part that has a border may go: Euler's number of the cells no other part has, and
/// whether it has others as well.
inline bool may_go(int32_t own_euler, bool touches_others) { return touches_others && !own_euler; }

/// Fill in the locks of parts.list.
/// Returns the number of connected pieces that have a part.
std::size_t find_locks(const TopologyGraph &graph, AxisParts &parts);

} // namespace vbm::impl
