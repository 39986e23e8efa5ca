// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles for a part of a sphere that no single polygon can stand for.
#pragma once

#include "ball_surface/geodesic.h"
#include "core/vec3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// A part of the unit sphere, on the left of its loops seen from outside. Loops are unit vectors;
/// corners are numbered through all loops.
struct SpherePatch {
  std::vector<std::vector<Vec3>> loops;
  /// What the part lies outside of: circles about `axis`, as its cosine.
  struct Cap {
    Vec3 axis;
    double cosine;
  };
  std::vector<Cap> caps;
};

struct PatchTriangles {
  std::vector<Vec3> points;                      // within the patch: unit vectors
  std::vector<std::array<int32_t, 3>> triangles; // corners, then points
};

/// Constrained Delaunay triangles between the loops and the `grid`'s points within the patch, all
/// facing outwards. Corners may be in one direction, where the patch touches itself. False if the
/// loops' chords (great circles) cross: that is checked, not assumed.
bool triangulate_patch(const SpherePatch &patch, const Geodesic &grid, PatchTriangles &out,
                       Progress &progress);

/// Of all triangles, in steradians.
double solid_angle(const SpherePatch &patch, const PatchTriangles &built);

/// Always possible: a ring of points inside the loops, which are joined by cuts from the first
/// one's first corner, and one in the middle of all. Points are `middle` and between it and the
/// corners.
void ring_patch(const SpherePatch &patch, const Vec3 &middle, PatchTriangles &out);

/// The direction of the patch's points that is farthest from what it lies outside of.
Vec3 patch_middle(const SpherePatch &patch, const Geodesic &grid);

} // namespace vbm::impl
