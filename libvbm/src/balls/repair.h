// SPDX-License-Identifier: GPL-3.0-or-later
// Small corrections of the labels that make the inside tetrahedra bound a manifold.
#pragma once

#include "core/cells.h"
#include "core/progress.h"

#include <cstdint>
#include <vector>

namespace vbm::impl {

/// Turn over tetrahedra (`inside`, per cell), least certain first, where that lets fewer sheets of
/// the boundary touch at a sample. `confidence` per cell, 0 to 1; cells at 1 are never turned. What
/// cannot be mended this way stays and is split when the surface is made. Returns the number of
/// cells turned.
std::size_t repair_labels(const Cells &cells, const std::vector<float> &confidence,
                          std::vector<uint8_t> &inside, Progress &progress);

} // namespace vbm::impl
