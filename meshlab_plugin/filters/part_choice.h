// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of an axis chosen by their cells, and taken off it as far as they go.
#pragma once

#include "layer.h"

#include <vbm/vbm.hpp>

#include <cstdint>
#include <vector>

namespace vbm_filters {

// The parts, ascending, with a selected triangle, or with a curve edge both of whose ends are
// selected. The layer is the axis's.
std::vector<std::int32_t> chosen_parts(const vbm::Axis &axis, const Layer &layer);

struct PartsRemoved {
  vbm::Axis axis;                 // null if nothing could go
  std::vector<std::int32_t> gone; // of the parts chosen
  std::vector<std::int32_t> left; // the others
  std::vector<std::int32_t> why;  // for each of those, the vbm_lock it has now
};

// Takes off those of the parts that can go.
PartsRemoved remove_parts(vbm::Context &context, const vbm::Axis &axis,
                          const std::vector<std::int32_t> &parts);

} // namespace vbm_filters
