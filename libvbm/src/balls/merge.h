// SPDX-License-Identifier: GPL-3.0-or-later
// Tetrahedra with one circumscribed ball between them made into one ball.
#pragma once

#include "balls/circumcenter.h"

#include <cstdint>
#include <vector>

namespace vbm::impl {

/// Every cell's ball. Cells that share a facet and a circumscribed sphere (within kCospherical)
/// share a ball: cospherical samples, the normal case on real meshes, are one maximal ball, not
/// many copies.
struct BallSet {
  std::vector<int32_t> of_cell;
  std::vector<Ball> ball;
};

/// Cells with 0 in `only` (per cell; NULL: none) stay alone.
BallSet merge_cospherical(const Cells &cells, const std::vector<Vec3> &samples,
                          Circumballs circumballs, Progress &progress,
                          const std::vector<uint8_t> *only = nullptr);

} // namespace vbm::impl
