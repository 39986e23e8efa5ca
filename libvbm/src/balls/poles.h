// SPDX-License-Identifier: GPL-3.0-or-later
// Which balls make the model: the poles of every sample, or all inside Voronoi balls.
#pragma once

#include "balls/merge.h"
#include "core/model.h"
#include "core/progress.h"

namespace vbm::impl {

/// Fill model.balls, inner, ball_samples, ball_of_cell and the poles of every sample from its
/// labelled cells. Inner balls come first, each group in the order of the cells.
void collect_balls(Model &model, const BallSet &balls, vbm_balls which, Progress &progress);

/// Fill model.ball_neighbors: balls of the same side whose tetrahedra share a facet, or one of
/// which is the polar ball of a sample the other touches. Linear in the cells, unlike "touch a
/// common sample".
void find_neighbors(Model &model, Progress &progress);

} // namespace vbm::impl
