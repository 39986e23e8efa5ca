// SPDX-License-Identifier: GPL-3.0-or-later
// A surface of the library, as a layer.
#pragma once

#include "layer.h"

#include <vbm/vbm.hpp>

#include <string>
#include <vector>

namespace vbm_filters {

// Radius and quality are those of the inner balls it touches. `input_colors` are the colours of the
// vertices it was made from, or empty. `polygons` keeps the surface's polygons.
NewLayer surface_layer(const vbm::Surface &surface, std::string name,
                       const std::vector<Color> &input_colors, bool polygons = false);

// What it is, and what the library has to say about it, a sentence each.
void describe(const vbm::Surface &surface, std::vector<std::string> &log);

} // namespace vbm_filters
