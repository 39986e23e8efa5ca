// SPDX-License-Identifier: GPL-3.0-or-later
// Other diagonals where triangles are needles.
#pragma once

#include "core/model.h"
#include "surface/triangulate.h"

#include <vector>

namespace vbm::impl {

class Progress;

/// Flips edges of a closed mesh of triangles that are needles, so that the surface stays a manifold
/// and its vertices where they are: the new edge is shorter than the old one, the smallest angle
/// larger, and the middle of the edge nearer to the balls' spheres. Edges between a wide ball
/// and another stay. `ball` is that of each triangle; triangles keep theirs. Returns for each
/// triangle whether it is no longer a part of the polygon it was in.
std::vector<uint8_t> flip_needles(const std::vector<Vec3> &position, const std::vector<Ball> &balls,
                                  const std::vector<uint8_t> &wide,
                                  std::vector<std::array<int32_t, 3>> &triangles,
                                  const std::vector<int32_t> &ball, Progress &progress);

} // namespace vbm::impl
