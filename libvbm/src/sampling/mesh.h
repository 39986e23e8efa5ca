// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle or polygon mesh as boundary samples.
#pragma once

#include "core/samples.h"

namespace vbm::impl {

class Progress;

/// Samples of a mesh given as vbm_build_mesh() gets it (which documents what is done with it): the
/// vertices in use, then samples on edges, then samples on faces. Vertices at one place are one, so
/// that soups connect. Normals are pseudo-normals of the mesh, upright where that can be told.
/// samples.refiner is always set; samples.inside for closed meshes, for open ones whose holes are
/// small, and not where labels come from propagation. Ticks, but sets no stage.
Samples sample_mesh(const double *vertices, std::size_t vertex_count, const uint32_t *face_sizes,
                    const int32_t *corners, std::size_t corner_count, std::size_t face_count,
                    const vbm_build_options &options, Progress &progress);

} // namespace vbm::impl
