// SPDX-License-Identifier: GPL-3.0-or-later
// The Voronoi diagram of singular points inside the shape, as far as a dual complex needs it.
#pragma once

#include "balls/merge.h"
#include "core/model.h"
#include "medial/power_shape.h"

#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// Sites are the model's samples, numbered as there, and then the singular points that are none.
struct SingularVoronoi {
  /// The Delaunay tetrahedra of the sites and which are inside; samples.position are the sites,
  /// ball_of_cell names inner balls of the ball model.
  Model solid;
  BallSet balls;                    // of the tetrahedra: one for all whose sites are on one ball
  std::vector<int32_t> near_sample; // per site: itself, or as of its singular point
  std::vector<int32_t> next_sample; // per site: -1, or as of its singular point
};

/// `take` tells for each of the shape's points whether it becomes a site. Throws
/// Error(VBM_ERROR_LIMIT) where the sites have far more tetrahedra than usual.
SingularVoronoi singular_voronoi(const Model &model, const PowerShape &shape,
                                 const std::vector<uint8_t> &take, Progress &progress);

} // namespace vbm::impl
