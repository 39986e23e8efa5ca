// SPDX-License-Identifier: GPL-3.0-or-later
// The shape that a pruned axis stands for (thesis 7.6).
#pragma once

#include "medial/axis.h"

namespace vbm::impl {

Surface axis_surface(const Axis &axis, const vbm_axis_surface_options &options, Progress &progress);

} // namespace vbm::impl
