// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis's construction of the medial axis (7.3.1, 7.4), from the power shape.
#pragma once

#include "medial/axis_cells.h"

#include <string>

namespace vbm::impl {

/// The axis of the union of the model's inner balls, with the topology of the model's solid. What
/// it is made of, and where it could not be made as the thesis does, is added to the notes.
AxisCells power_shape_axis(const Model &model, const AxisOptions &options, std::string &notes,
                           Progress &progress);

} // namespace vbm::impl
