// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles as quadrilaterals.
#pragma once

#include "core/vec3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// For each of a closed mesh's triangles with a 1 in `free`, another such one that makes a convex,
/// nearly plane quadrilateral with it, or -1; the flattest pairs first.
std::vector<int32_t> pair_triangles(const std::vector<Vec3> &position,
                                    const std::vector<std::array<int32_t, 3>> &triangles,
                                    const std::vector<uint8_t> &free, Progress &progress);

} // namespace vbm::impl
