// SPDX-License-Identifier: GPL-3.0-or-later
// The ball model: what vbm_model holds. Immutable once built.
#pragma once

#include "core/cells.h"
#include "core/samples.h"
#include "core/vec3.h"

#include <vbm/vbm.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vbm::impl {

struct Ball {
  Vec3 center; // unit frame
  double radius = 0;
};

/// Lists of indices, one list per element: list e is index[offset[e]] .. index[offset[e + 1] - 1].
struct Incidence {
  std::vector<uint64_t> offset{0};
  std::vector<int32_t> index;
};

struct Model {
  Samples samples;
  Cells cells;                       // Delaunay of the samples
  std::vector<uint8_t> inside;       // per cell: 1 inside
  std::vector<int32_t> ball_of_cell; // per cell: its ball in `balls`, -1 if it is not in the model
  std::vector<Ball> balls;           // unit frame; inner first
  std::size_t inner = 0;             // number of inner balls
  Incidence ball_samples;            // samples each ball touches, ascending, box corners left out
  Incidence ball_neighbors;
  std::vector<int32_t> inner_pole, outer_pole; // per sample: ball index, -1: none
  std::vector<int32_t> undersampled;           // samples, ascending

  bool wrong_topology = false; // built from a mesh that bounds a solid of another topology

  // What the views show, in input units.
  std::vector<double> centers, radii, sample_positions, inner_radius, outer_radius;
  std::vector<uint8_t> ball_inside;
  std::string notes;
  vbm_model_report report{};
};

/// A closed polygon mesh: what vbm_surface holds, in input units.
struct Surface {
  std::vector<Vec3> vertices;
  std::vector<std::array<int32_t, 3>> triangles;
  Incidence polygons;
  std::vector<int32_t> triangle_polygon, polygon_ball, vertex_sample, vertex_input;
  std::vector<double> vertex_radius;
  std::string notes;
  vbm_surface_report report{};
};

} // namespace vbm::impl
