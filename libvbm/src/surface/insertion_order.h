// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which an incremental triangulation takes its points.
#pragma once

#include "core/vec3.h"

#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// A permutation of the points: rounds of about doubling size, chosen by a fixed hash, each along a
/// Hilbert curve. Any input order then costs about the same, and each point is near the one before
/// it.
std::vector<int32_t> insertion_order(const std::vector<Vec3> &points, Progress &progress);

} // namespace vbm::impl
