// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "layer.h"

#include <vector>

namespace vbm_filters {

// Colours for the vertices of a rebuilt surface: a vertex that is an input vertex has its colour;
// the others, from those outwards, take the mean of their coloured neighbours.
std::vector<Color> transfer_colors(const std::vector<Color> &input_colors,
                                   const std::vector<std::int32_t> &vertex_input,
                                   const std::vector<std::int32_t> &triangles);

} // namespace vbm_filters
