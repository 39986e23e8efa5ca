// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace vbm_filters {

// Turns triangles (3 vertex indices each) over, so that those of one sheet, which hang together
// across edges of exactly two triangles, face the same way: a host's lights show them as one
// surface then. On the whole they face along z, from where MeshLab first looks. A sheet that has
// only one side is left with a seam.
void orient_sheets(std::vector<std::int32_t> &triangles, const std::vector<double> &points);

} // namespace vbm_filters
