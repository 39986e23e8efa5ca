// SPDX-License-Identifier: GPL-3.0-or-later
// How far a surface and the boundary of the union of balls it was made of are from each other.
#pragma once

#include "ball_surface/union_input.h"

namespace vbm::impl {

/// Fills report.surface_error_max ... union_error_mean, at points of both: of the surface the
/// vertices, the middles of its triangles and points spread evenly; of the boundary where rays from
/// the balls' centres leave the union, some for each ball.
void measure_errors(Surface &surface, const UnionInput &set, Progress &progress);

} // namespace vbm::impl
