// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of an axis made smooth and thin.
#pragma once

#include "medial/ball_complex.h"
#include "medial/burn.h"

namespace vbm::impl {

/// What is left as a complex. Triangles stay as they are; each curve between two nodes (vertices
/// where it does not simply go on) becomes a smooth one whose vertices are about `spacing` times
/// the burn time apart. Radii of its vertices are mixtures of the old ones.
BallComplex thin_curves(const AxisCells &cells, const Burnt &burnt, double spacing,
                        Progress &progress);

} // namespace vbm::impl
