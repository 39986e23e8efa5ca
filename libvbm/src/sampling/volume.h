// SPDX-License-Identifier: GPL-3.0-or-later
// A volume of voxels as boundary samples (thesis 3.1.2 and Theorem 3.2).
#pragma once

#include "core/samples.h"

namespace vbm::impl {

class Progress;

/// Samples on the grid edges between an inside voxel (value >= level) and an outside one, where
/// linear interpolation puts the level; all around the grid is outside, and what touches its border
/// closes half a voxel beyond it. Normals come from the values' gradient. samples.inside looks
/// voxels up, unless the options ask for other labels. Arguments as for vbm_build_volume(). Ticks,
/// but sets no stage.
Samples sample_volume(const void *values, vbm_scalar type, std::size_t nx, std::size_t ny,
                      std::size_t nz, const double *voxel_size, const double *origin, double level,
                      const vbm_build_options &options, Progress &progress);

} // namespace vbm::impl
