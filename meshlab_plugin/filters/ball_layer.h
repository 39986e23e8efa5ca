// SPDX-License-Identifier: GPL-3.0-or-later
// Layers whose vertices are balls: their radius is that of the ball.
#pragma once

#include "layer.h"

#include <vbm/vbm.hpp>

#include <string>
#include <vector>

namespace vbm_filters {

struct Balls {
  vbm::View<double, 3> centers;
  vbm::View<double> radii;
};

// The layer's balls; throws Failure, with a sentence that says where balls come from, if it has
// none. Valid as long as the layer.
Balls balls_of(const Layer &layer);

// Quality is the radius, and so are the colours, from red (small) to blue (large).
NewLayer ball_layer(vbm::View<double, 3> centers, vbm::View<double> radii, std::string name);

// "New layer: 3 balls, radius from 1 to 2."
std::string describe_balls(const NewLayer &layer);

} // namespace vbm_filters
