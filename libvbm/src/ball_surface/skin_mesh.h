// SPDX-License-Identifier: GPL-3.0-or-later
// The skin surface as triangles: pieces of the mixed complex cut, and finer where it bends.
#pragma once

#include "ball_surface/mixed_complex.h"

#include <array>
#include <cmath>
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

/// By ball, in unit lengths.
struct SkinDetail {
  std::vector<double> least;    // how far the middles of its edges may be from the skin
  std::vector<double> shortest; // edges that are shorter may go
};

/// How far the middle of an edge is from the skin, about: an arc's height over its chord, by the
/// skin's normals at its ends.
inline double bend(const SkinMesh &mesh, int32_t u, int32_t v) {
  return std::fabs(dot(mesh.normal[u] - mesh.normal[v], mesh.position[u] - mesh.position[v])) / 8;
}

/// Halves edges whose middle is too far from the skin.
void refine(SkinMesh &mesh, const MixedComplex &mixed, const SkinDetail &detail,
            Progress &progress);

/// Contracts short edges where the surface stays a manifold of the same topology, no triangle turns
/// away from the skin and no edge gets too far from it. Vertices keep their places.
void contract(SkinMesh &mesh, const SkinDetail &detail, Progress &progress);

/// Gives slivers other diagonals, where no edge gets too far from the skin. Returns how many edges
/// it turned.
std::size_t flip_slivers(SkinMesh &mesh, const SkinDetail &detail, Progress &progress);

/// Of each half-edge 3 * triangle + side, the one that runs the other way.
std::vector<int32_t> twins_of(const SkinMesh &mesh, Progress &progress);

} // namespace vbm::impl
