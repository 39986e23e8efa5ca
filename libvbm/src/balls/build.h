// SPDX-License-Identifier: GPL-3.0-or-later
// From boundary samples to a ball model (thesis 3.1).
#pragma once

#include "core/model.h"
#include "core/progress.h"

namespace vbm::impl {

/// The pipeline of every input kind once it is sampled. Throws Error with DEGENERATE, LIMIT,
/// NO_INTERIOR or CANCELLED.
Model build_model(Samples samples, const vbm_build_options &options, Progress &progress);

} // namespace vbm::impl
