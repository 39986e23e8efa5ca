// SPDX-License-Identifier: GPL-3.0-or-later
// A power diagram's cells in the order of their lowest balls.
#pragma once

#include "surface/power_diagram.h"

#include <vector>

namespace vbm::impl {

class Progress;

/// Without those that are none. Balls that were made in some order are near each other in space if
/// their numbers are, and so are these cells: whoever goes through them finds their neighbours in
/// the cache. `balls` is how many there are, without far corners.
LargeList<PowerDiagram::Cell> arranged(const LargeList<PowerDiagram::Cell> &cells,
                                       std::size_t balls, Progress &progress);

} // namespace vbm::impl
