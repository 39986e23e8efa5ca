// SPDX-License-Identifier: GPL-3.0-or-later
// The skin surface (Edelsbrunner 1999): a smooth closed surface round any balls.
#pragma once

#include "ball_surface/union_input.h"

#include <vbm/vbm.h>

namespace vbm::impl {

/// Throws Error(VBM_ERROR_NO_INTERIOR) if there is no ball.
Surface skin_surface(const UnionInput &set, const vbm_ball_surface_options &options,
                     Progress &progress);

} // namespace vbm::impl
