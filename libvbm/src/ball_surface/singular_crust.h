// SPDX-License-Identifier: GPL-3.0-or-later
// The power crust of a union's singular points (thesis 8.5).
#pragma once

#include "ball_surface/union_input.h"

#include <vbm/vbm.h>

namespace vbm::impl {

/// Throws Error(VBM_ERROR_NO_INTERIOR) if there is no ball.
Surface singular_crust(const UnionInput &set, const vbm_ball_surface_options &options,
                       Progress &progress);

} // namespace vbm::impl
