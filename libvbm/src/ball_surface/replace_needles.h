// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons with needles among their triangles, made anew.
#pragma once

#include "ball_surface/patch_mesh.h"
#include "surface/triangulate.h"

#include <vector>

namespace vbm::impl {

class Progress;

/// Flips needles (flip_needles.h); polygons that lose a triangle by that become triangles, and
/// those pairs where they are flat.
void replace_needles(PatchMesh &mesh, Triangles &triangles, const std::vector<Ball> &balls,
                     const std::vector<uint8_t> &wide, Progress &progress);

} // namespace vbm::impl
