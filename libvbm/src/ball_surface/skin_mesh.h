// SPDX-License-Identifier: GPL-3.0-or-later
// The skin surface as triangles: pieces of the mixed complex cut, and finer where it bends.
#pragma once

#include "ball_surface/mixed_complex.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// A closed oriented manifold.
struct SkinMesh {
  struct Triangle {
    std::array<int32_t, 3> vertex; // counter-clockwise from outside
    int32_t cell;                  // that it was cut in
    int32_t ball;                  // the nearest one
  };
  std::vector<Vec3> position, normal; // of vertices
  std::vector<Triangle> triangles;
};

/// Has the skin's topology: in each piece of a mixed cell the skin is a disk or not there, which
/// the corners' sides tell.
SkinMesh march(const MixedComplex &mixed, Progress &progress);

/// Halves edges whose middle is farther from the skin than `bulge` times the ball's radius.
void refine(SkinMesh &mesh, const MixedComplex &mixed, double bulge, Progress &progress);

/// Contracts edges shorter than `share` of their balls' radii where the surface stays a manifold of
/// the same topology and no triangle turns away from the skin. Vertices keep their places.
void contract(SkinMesh &mesh, const MixedComplex &mixed, double share, Progress &progress);

} // namespace vbm::impl
