// SPDX-License-Identifier: GPL-3.0-or-later
// A medial axis, as a layer.
#pragma once

#include "layer.h"

#include <vbm/vbm.hpp>

#include <string>
#include <vector>

namespace vbm_filters {

// Vertices are balls, with their radii as radius and quality; faces have the colour of their part,
// and its number as quality. Hosts have no edges: of curves
// only the vertices show.
NewLayer axis_layer(const vbm::Axis &axis, std::string name);

// What it is, and which parts cannot go, a sentence each.
void describe(const vbm::Axis &axis, std::vector<std::string> &log);

// The name of the layer that an axis layer was made from.
std::string without_axis(const std::string &name);

} // namespace vbm_filters
