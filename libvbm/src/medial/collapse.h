// SPDX-License-Identifier: GPL-3.0-or-later
// The medial axis out of the inside Voronoi diagram: what stays when all cells that tell nothing
// about the shape are collapsed.
#pragma once

#include "medial/dual_complex.h"

namespace vbm::impl {

/// What makes a face of the complex part of the axis.
struct AxisOptions {
  double angle = 45; // degrees: its two samples, seen from its largest ball, are this far apart ...
  double ratio = 8;  // ... or are this many times farther apart than samples are next to them
  const std::vector<double> *spacing = nullptr; // how far apart samples are at each; NULL: measured
};

/// Ratio of a face's width to the distance of samples next to its own, below which what it tells is
/// as likely noise: at the tips of corners sheets are cut off before they get tangled.
inline constexpr double kResolved = 2;

/// What is left of a complex (one byte a cell), and where what went has gone.
struct Collapsed {
  std::vector<uint8_t> face, edge, vertex;
  std::vector<uint8_t> seam;   // per edge: its three samples are on three sides of the shape
  std::vector<int32_t> root;   // per vertex: the vertex it was drawn into, itself if that is left
  std::vector<int32_t> parent; // per vertex: the next one on its way there
  std::vector<int32_t> gone;   // vertices in the order they went, each before its parent
};

/// How far apart samples are at each: the longest side of the surface's triangles there.
std::vector<double> sample_spacing(const Model &model, Progress &progress);

Collapsed collapse(const DualComplex &complex, const Model &model, const AxisOptions &options,
                   Progress &progress);

} // namespace vbm::impl
