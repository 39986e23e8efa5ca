// SPDX-License-Identifier: GPL-3.0-or-later
// Range scans, points with the places they were seen from, as boundary samples (thesis 3.1.2).
#pragma once

#include "core/samples.h"

namespace vbm::impl {

class Progress;

/// Samples from count x 3 numbers; a sample's normal is the direction to its scanner, of which only
/// the side of the surface it shows is meaningful. Directions of merged points are added up.
/// Arguments as for vbm_build_range_scan(). Ticks, but sets no stage.
Samples sample_range_scan(const double *points, std::size_t count, const double *scanners,
                          std::size_t scanner_count, const int32_t *scanner_of_point,
                          const vbm_build_options &options, Progress &progress);

} // namespace vbm::impl
