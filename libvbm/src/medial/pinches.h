// SPDX-License-Identifier: GPL-3.0-or-later
// Samples at which the outside touches itself through the solid.
#pragma once

#include "core/model.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// The inside tetrahedra at such a sample form a ring (or several) about it. The surface passes the
/// sample in several sheets, between which the solid goes on; its open interior does not, as the
/// sample itself is missing.
struct Pinch {
  int32_t sample;
  std::vector<std::array<int32_t, 2>> facets; // cell and place of those that make the rings
};

/// Only where sampling is too thin are there any.
std::vector<Pinch> find_pinches(const Model &model, Progress &progress);

} // namespace vbm::impl
