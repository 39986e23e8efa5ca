// SPDX-License-Identifier: GPL-3.0-or-later
// Where the vertices of a power crust are.
#pragma once

#include "core/model.h"
#include "surface/crust_complex.h"
#include "surface/crust_selection.h"

#include <vector>

namespace vbm::impl {

class Progress;

struct CrustVertices {
  std::vector<Vec3> position;  // unit frame
  std::vector<int32_t> sample; // that all four balls touch, so that the vertex is there; -1: none
  std::vector<int32_t> near;   // the nearest of the samples that the four balls touch; -1: none
  std::vector<float> pull;     // distance to it, by the distance to the second nearest of them
  uint64_t clamped = 0;        // vertices moved back to within kCrustReach of an inner ball
};

CrustVertices crust_vertices(const CrustComplex &crust, const Model &model,
                             const Selection &selected, Progress &progress);

} // namespace vbm::impl
