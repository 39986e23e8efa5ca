// SPDX-License-Identifier: GPL-3.0-or-later
// Points, with or without normals, as boundary samples.
#pragma once

#include "core/samples.h"

namespace vbm::impl {

class Progress;

/// Samples from count x 3 numbers and, unless NULL, as many outward normals of any length (zero:
/// unknown). Labels come from the normals where any is known, else from propagation. Whether the
/// points span three dimensions is the Delaunay stage's question. Ticks, but sets no stage.
Samples sample_points(const double *points, size_t count, const double *normals,
                      const vbm_build_options &options, Progress &progress);

} // namespace vbm::impl
