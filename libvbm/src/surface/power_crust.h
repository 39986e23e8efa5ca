// SPDX-License-Identifier: GPL-3.0-or-later
// The power crust (thesis 8.2): a closed surface from a ball model or a part of it.
#pragma once

#include "core/model.h"
#include "core/progress.h"

namespace vbm::impl {

/// `keep` is null or one byte per inner ball, `keep_outer` the same for outer balls: those with 0
/// leave the diagram. Throws Error(VBM_ERROR_NO_INTERIOR) if no inner ball is left.
Surface power_crust(const Model &model, const uint8_t *keep, const uint8_t *keep_outer,
                    Progress &progress);

} // namespace vbm::impl
