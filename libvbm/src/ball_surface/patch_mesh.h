// SPDX-License-Identifier: GPL-3.0-or-later
// A boundary complex as polygons: one for each patch, or triangles where one would not do.
#pragma once

#include "ball_surface/patch_complex.h"
#include "core/model.h"

#include <vector>

namespace vbm::impl {

class Progress;

/// Simple polygons: each has three vertices or more and none of them twice, every edge runs once in
/// each direction.
struct PatchMesh {
  std::vector<Vec3> position;
  std::vector<int32_t> sample;
  Incidence polygons;
  std::vector<int32_t> ball; // per polygon
};

/// A merged complex (merge_points) and the sample of each of its vertices.
PatchMesh patch_mesh(const PatchComplex &complex, const DualShape &shape,
                     std::vector<int32_t> sample, const PatchOptions &options, Progress &progress);

} // namespace vbm::impl
