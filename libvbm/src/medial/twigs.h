// SPDX-License-Identifier: GPL-3.0-or-later
// What was collapsed onto a medial axis: the balls of bumps and corners too small to have an axis.
#pragma once

#include "medial/collapse.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vbm::impl {

/// The collapsed part of the Voronoi diagram is a forest that grows from the axis. A twig is an
/// inner ball of it with all that hangs on it. Its measures are those of a part, and never less
/// than those of the twigs on it.
struct Twig {
  int32_t below = -1; // the ball that it hangs on; -1: the axis itself
  uint32_t cells = 0; // inside tetrahedra, which stand for triangles; 0: the ball is on the axis
  double volume = 0;  // their share of the solid's
  float width = 0;    // largest distance of two samples of a tetrahedron, unit frame
  float angle = 0;    // degrees: the largest angle under which such samples are seen
  bool thin = false;  // one of the tetrahedra lies across a wall that the samples do not resolve
};

/// What an axis lacks, where samples are no nearer to each other than the shape is thin.
struct ThinShare {
  double volume = 0;       // share of the solid's in tetrahedra across such walls, off the axis
  std::size_t samples = 0; // of these tetrahedra
  /// Whether that is more than corners and noise have.
  bool counts() const;
};

/// Per inner ball of the model. `thin` is where to put what the axis lacks.
std::vector<Twig> find_twigs(const DualComplex &complex, const Collapsed &left, const Model &model,
                             ThinShare &thin, Progress &progress);

/// A line that says so, or "".
std::string thin_text(const ThinShare &thin);

/// Per ball: what all balls of its twig have together.
std::vector<double> sum_over_twigs(const std::vector<Twig> &twigs, std::vector<double> per_ball);

} // namespace vbm::impl
