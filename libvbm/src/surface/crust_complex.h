// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary between inner and outer cells of a power diagram, as a complex of its own.
#pragma once

#include "core/model.h"
#include "surface/power_diagram.h"

#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// The power crust before any merging. Its vertices are the tetrahedra of the regular triangulation
/// that have inner and outer balls, its edges their facets that have both, its faces their edges
/// that have both. In each tetrahedron the crust is one triangle or quadrilateral about its inner
/// balls, and these fit together, so that it is a closed 2-manifold whatever the balls are.
struct CrustComplex {
  /// Facets that lie on one side have neighbor -1; codes count vertices of this complex. Neighbours
  /// are near each other in memory.
  LargeList<PowerDiagram::Cell> vertices;
  uint64_t components = 0;
  int32_t inner = 0;          // balls below this are inner
  std::size_t balls = 0;      // balls of the diagram; beyond are the far corners
  std::array<Vec3, 4> corner; // the far corners

  /// Faces: the vertices around each, counter-clockwise seen from its outer ball.
  Incidence rings;
  std::vector<int32_t> ring_inner, ring_outer;
  std::vector<std::array<int32_t, 4>> rings_at; // of each vertex; three or four, then -1

  int64_t euler() const;
  bool is_inner(int32_t ball) const { return ball < inner; }
};

/// Takes the diagram apart.
CrustComplex crust_complex(PowerDiagram diagram, std::size_t balls, std::size_t inner,
                           Progress &progress);

} // namespace vbm::impl
