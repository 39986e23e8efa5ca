// SPDX-License-Identifier: GPL-3.0-or-later
// Fewer vertices for a power crust, the same surface.
#pragma once

#include "core/model.h"
#include "surface/crust_complex.h"
#include "surface/crust_vertices.h"

#include <vector>

namespace vbm::impl {

class Progress;

/// A power crust as polygons, each with at least three vertices and none of them twice; every edge
/// runs once in each direction.
struct CrustMesh {
  std::vector<Vec3> position;  // unit frame
  std::vector<int32_t> sample; // the vertex is exactly there; -1: none
  Incidence polygons;
  std::vector<int32_t> inner, outer; // per polygon: the diagram's balls
};

/// Merge vertices that are one sample, and those near a sample or each other (kCrustPull,
/// kCrustMerge).
CrustMesh merge_crust(const CrustComplex &crust, const CrustVertices &vertices,
                      const std::vector<Ball> &balls, const Model &model, Progress &progress);

} // namespace vbm::impl
