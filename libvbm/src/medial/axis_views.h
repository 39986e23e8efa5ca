// SPDX-License-Identifier: GPL-3.0-or-later
// From an axis's state to the arrays its handle shows.
#pragma once

#include "medial/axis.h"

namespace vbm::impl {

/// Fill everything of `axis` after `parts`, and the parts' positions.
void fill_views(Axis &axis, Progress &progress);

} // namespace vbm::impl
