// SPDX-License-Identifier: GPL-3.0-or-later
// The cells dual to the inside Delaunay tetrahedra: all of the Voronoi diagram that lies inside.
#pragma once

#include "balls/merge.h"
#include "core/model.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// Vertices are inside tetrahedra (those on one sphere are one vertex), edges the facets between
/// two of them, faces the Delaunay edges all round which is inside, solids the samples all round
/// which is inside. It has the homotopy type of the solid that the interpolating surface bounds:
/// its open interior, with the samples at which the surface passes in several sheets filled in.
struct DualComplex {
  std::vector<Ball> ball;                           // per vertex, unit frame
  std::vector<int32_t> vertex_of_cell;              // -1 outside
  std::vector<std::array<int32_t, 2>> edge;         // its vertices
  std::vector<std::array<int32_t, 3>> edge_samples; // of the facet
  Incidence face_vertices, face_edges;              // in order round the face: edge i joins
                                                    // vertices i and i + 1
  std::vector<std::array<int32_t, 2>>
      face_samples;           // of the Delaunay edge; both the same at a filled-in sample
  std::vector<uint8_t> solid; // per sample

  std::size_t faces() const { return face_samples.size(); }
};

/// `balls` are the balls of the tetrahedra and which of these share one; NULL: found by rounding.
DualComplex dual_complex(const Model &model, Progress &progress, const BallSet *balls = nullptr);

} // namespace vbm::impl
