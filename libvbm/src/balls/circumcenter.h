// SPDX-License-Identifier: GPL-3.0-or-later
// Circumscribed balls of the Delaunay tetrahedra (thesis 3.1, second step), right even for slivers.
#pragma once

#include "core/cells.h"
#include "core/model.h"
#include "core/progress.h"

#include <vector>

namespace vbm::impl {

struct Circumballs {
  std::vector<Ball> ball;       // per cell
  std::vector<float> condition; // per cell: |a||b||c| / |det(a, b, c)|, at least 1
  uint64_t exact = 0;           // how many needed exact arithmetic
};

/// The circumscribed ball of one cell, and its condition (see Circumballs).
Ball circumball(const Cells &cells, const std::vector<Vec3> &samples, std::size_t cell,
                double *condition);

/// The circumscribed ball of every cell; centres are correct to a few units in the last place of
/// the tetrahedron's circumradius. Cells with 0 in `only` (per cell; NULL: none) are passed over:
/// they get a ball of no size and an infinite condition.
Circumballs circumscribe(const Cells &cells, const std::vector<Vec3> &samples, Progress &progress,
                         const std::vector<uint8_t> *only = nullptr);

} // namespace vbm::impl
