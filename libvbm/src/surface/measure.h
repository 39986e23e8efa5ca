// SPDX-License-Identifier: GPL-3.0-or-later
// Counts and sizes of a finished surface, and the proof that it is a closed manifold.
#pragma once

#include "core/model.h"
#include "core/progress.h"

namespace vbm::impl {

/// Fill surface.report from its vertices, triangles and polygons (split_vertices is left as it is, and
/// noted).
/// Throws Error(VBM_ERROR_INTERNAL) unless every edge of the triangles lies in exactly two of them,
/// run through in opposite directions, and every vertex has one closed fan of triangles.
void measure(Surface &surface, Progress &progress);

} // namespace vbm::impl
