// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of an axis, carried over to the balls of the model and the points it was built from.
#pragma once

#include <vbm/vbm.hpp>

#include <cstdint>
#include <vector>

namespace vbm_filters {

constexpr std::int32_t kNoPart = -1;

// For every inner ball its part: a ball whose part was pruned, or that stands where parts meet,
// takes the part that most of its neighbours have, from those that have one outwards. kNoPart where
// no part can be reached.
std::vector<std::int32_t> ball_parts(const vbm::Model &model, const vbm::Axis &axis);

// For every input point the part of the largest inner ball that touches it, or kNoPart.
std::vector<std::int32_t> input_parts(const vbm::Model &model,
                                      const std::vector<std::int32_t> &ball_part);

} // namespace vbm_filters
