// SPDX-License-Identifier: GPL-3.0-or-later
// The singular-point surface (thesis 8.3): a closed surface from any balls.
#pragma once

#include "ball_surface/union_input.h"

#include <vbm/vbm.h>

namespace vbm::impl {

class Progress;

/// Throws Error(VBM_ERROR_NO_INTERIOR) if there is no ball.
Surface singular_point_surface(const UnionInput &set, const vbm_ball_surface_options &options,
                               Progress &progress);

} // namespace vbm::impl
