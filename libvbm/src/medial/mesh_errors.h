// SPDX-License-Identifier: GPL-3.0-or-later
// How far the envelope of a medial mesh is from the shape it was made of.
#pragma once

#include "medial/ball_complex.h"
#include "sampling/triangle_tree.h"

namespace vbm::impl {

class Progress;

/// The shape a model stands for: its interpolating surface.
struct Shape {
  std::vector<int32_t> sample;    // on the surface, ascending
  std::vector<Triangle> triangle; // samples
  double area = 0;
  TriangleTree tree;
};

Shape shape_of(const Model &model, Progress &progress);

/// Unit lengths.
struct MeshErrors {
  double sample_max = 0, sample_mean = 0;     // samples to the envelope
  double envelope_max = 0, envelope_mean = 0; // envelope to the surface
};

MeshErrors mesh_errors(const BallComplex &complex, const Shape &shape, const Model &model,
                       Progress &progress);

} // namespace vbm::impl
