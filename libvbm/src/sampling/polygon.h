// SPDX-License-Identifier: GPL-3.0-or-later
// Cutting a polygon into triangles.
#pragma once

#include "sampling/triangle_mesh.h"

namespace vbm::impl {

/// Append the triangles of a polygon of four or more corners, in its direction, to `out`: always
/// corners - 2 of them, whose common border is the polygon. Flat simple polygons, concave ones too,
/// are covered once; a quadrangle is cut by its shorter diagonal where that lies inside. Polygons
/// that are bent, cross themselves or have no area are cut, too, only not as nicely.
void triangulate_polygon(const std::vector<int32_t> &corners, const std::vector<Vec3> &position,
                         std::vector<Triangle> &out, Progress &progress);

} // namespace vbm::impl
