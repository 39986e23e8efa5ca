// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons whose triangles fold over each other, cut otherwise.
#pragma once

#include "ball_surface/patch_mesh.h"
#include "dual/dual_shape.h"
#include "surface/triangulate.h"

#include <cstddef>
#include <vector>

namespace vbm::impl {

class Progress;

/// Triangulates those polygons anew that have a triangle which is not seen from outside, from their
/// ball's centre: without folds where seen from there the polygon is simple, and where no edge
/// would be that of four triangles. The others stay.
void turn_outwards(const PatchMesh &mesh, const DualShape &shape, Triangles &triangles,
                   Progress &progress);

/// The triangles that are not seen from outside from their ball's centre.
std::vector<std::size_t> folded_triangles(const PatchMesh &mesh, const Triangles &triangles,
                                          const std::vector<Ball> &balls, Progress &progress);

} // namespace vbm::impl
