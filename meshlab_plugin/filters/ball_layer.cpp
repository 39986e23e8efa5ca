// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball_layer.h"

#include "ramp.h"
#include "text.h"

namespace vbm_filters {

Balls balls_of(const Layer &layer) {
  if (!layer.vertex_count()) throw Failure("This layer has no vertices, so there are no balls.");
  if (layer.radius.empty())
    throw Failure("The vertices of this layer have no radius, so they are no balls: \"Build Ball "
                  "Model\" makes a layer of balls from a shape, and a PLY file whose vertices have "
                  "a property \"radius\" is read as one.");
  return {{layer.points.data(), layer.vertex_count()}, {layer.radius.data(), layer.radius.size()}};
}

NewLayer ball_layer(vbm::View<double, 3> centers, vbm::View<double> radii, std::string name) {
  NewLayer layer;
  layer.name = std::move(name);
  layer.points.assign(centers.begin(), centers.end());
  layer.radius.assign(radii.begin(), radii.end());
  layer.quality = layer.radius;
  layer.ramp = spread(layer.radius).ramp;
  return layer;
}

std::string describe_balls(const NewLayer &layer) {
  const Spread range = spread(layer.radius);
  return "New layer: " + count(layer.radius.size(), "ball", "balls") + ", radius from " +
         number(range.minimum) + " to " + number(range.maximum) + ".";
}

} // namespace vbm_filters
