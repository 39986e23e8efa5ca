// SPDX-License-Identifier: GPL-3.0-or-later
// Samples on the edges and faces of a mesh, so that no gap is wider than a given spacing.
#pragma once

#include "core/samples.h"
#include "sampling/buried.h"
#include "sampling/triangle_mesh.h"
#include "sampling/triangle_tree.h"

namespace vbm::impl {

/// Add samples to a mesh whose vertices are the samples so far, as options.spacing says. "No gap is
/// wider than h" means: along every edge that is not within a plane, samples are at most h apart,
/// in equal parts; and every point of a face is at most h from a sample on the surface. Vertices
/// count, so a mesh with no edge longer than h gets nothing. Sets samples.spacing and
/// samples.added. Throws VBM_ERROR_LIMIT, before allocating, if a spacing asked for needs more
/// samples than allowed. A spacing of the library's own choice is less where the mesh is thin, told
/// by `tree` and `buried` (may be null).
void fill_gaps(const TriangleMesh &mesh, const std::vector<Vec3> &face_normal,
               const TriangleTree &tree, const BuriedTest *buried, const vbm_build_options &options,
               Samples &samples, Progress &progress);

} // namespace vbm::impl
