// SPDX-License-Identifier: GPL-3.0-or-later
// The skin surface as triangles: pieces of the mixed complex cut, and finer where it bends.
#pragma once

#include "ball_surface/mixed_complex.h"

#include <algorithm>
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

/// Cosine between the normal of a triangle and those of the skin at its corners, 0 of one without
/// an area to speak of.
inline double upright(const SkinMesh &mesh, const std::array<int32_t, 3> &v) {
  const Vec3 &p = mesh.position[v[0]];
  const Vec3 e = mesh.position[v[1]] - p, f = mesh.position[v[2]] - p, n = cross(e, f);
  const Vec3 skin = mesh.normal[v[0]] + mesh.normal[v[1]] + mesh.normal[v[2]];
  const double size = length(n), straight = length(skin);
  const bool is_flat = !(size > 1e-9 * std::max(dot(e, e), dot(f, f))) || !(straight > 0);
  return is_flat ? 0 : dot(n, skin) / (size * straight);
}
/// Below this a triangle is folded over.
inline constexpr double kFolded = 0.5;

/// Halves edges whose middle is too far from the skin.
void refine(SkinMesh &mesh, const MixedComplex &mixed, const SkinDetail &detail,
            Progress &progress);

/// Contracts short edges where the surface stays a manifold of the same topology, no triangle turns
/// away from the skin and no edge gets too far from it. Vertices keep their places.
void contract(SkinMesh &mesh, const SkinDetail &detail, Progress &progress);

/// Contracts edges of folded triangles, of any length, where that leaves less folded ones. Returns
/// how many.
std::size_t unfold(SkinMesh &mesh, const SkinDetail &detail, Progress &progress);

/// Gives slivers other diagonals, where no edge gets too far from the skin, and folded triangles
/// where they are less folded then. Returns how many edges it turned.
std::size_t flip_slivers(SkinMesh &mesh, const SkinDetail &detail, Progress &progress);

/// Of each half-edge 3 * triangle + side, the one that runs the other way.
std::vector<int32_t> twins_of(const SkinMesh &mesh, Progress &progress);

} // namespace vbm::impl
