// SPDX-License-Identifier: GPL-3.0-or-later
// Where the sampling is too thin to trust the surface (thesis 7.9).
#pragma once

#include "core/model.h"
#include "core/progress.h"

namespace vbm::impl {

/// Fill model.undersampled: samples beside a surface triangle whose circumradius, the distance from
/// its middle to the nearest samples, exceeds `ratio` times the smaller of the sample's medial
/// radii; and samples that are not on the surface at all, counted in report.unused_samples.
void find_undersampled(Model &model, double ratio, Progress &progress);

} // namespace vbm::impl
