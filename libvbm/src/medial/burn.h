// SPDX-License-Identifier: GPL-3.0-or-later
// The sheets of an axis burnt down to curves.
#pragma once

#include "medial/axis_parts.h"

#include <vector>

namespace vbm::impl {

class Progress;

/// What fire leaves of an axis that is lit all along its border. Only triangles with a free edge
/// burn, each together with that edge, so the homotopy type stays.
struct Burnt {
  AxisState left;
  std::vector<double>
      time; // per vertex: when fire reaches it last; the ball's radius if it does not
};

Burnt burn(const AxisCells &cells, const AxisState &state, Progress &progress);

} // namespace vbm::impl
