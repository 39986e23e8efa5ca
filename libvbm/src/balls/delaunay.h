// SPDX-License-Identifier: GPL-3.0-or-later
// The Delaunay triangulation of the samples, closed by a box (thesis 3.1.1 and 3.1.2, step 1).
#pragma once

#include "core/cells.h"
#include "core/progress.h"
#include "core/vec3.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vbm::impl {

/// Throws Error(VBM_ERROR_DEGENERATE), naming the count and the dimension, if the points do not
/// span three dimensions; `given` is how many points the caller had before merging.
void check_three_dimensional(const std::vector<Vec3> &points, uint64_t given);

/// The points' indices in the order of a space-filling curve (Hilbert's).
std::vector<int32_t> spatial_order(const std::vector<Vec3> &points, Progress &progress);

/// An incremental Delaunay triangulation of points of the unit frame and the closing box's corners.
/// Exact predicates; the order of insertion depends on the points alone.
class Delaunay {
public:
  Delaunay();
  ~Delaunay();
  Delaunay(const Delaunay &) = delete;
  Delaunay &operator=(const Delaunay &) = delete;

  /// Insert points, numbered from 0, once. No two may be the same; along a space-filling curve they
  /// are inserted fastest. Throws Error(VBM_ERROR_LIMIT) if the tetrahedra exceed `cell_limit`
  /// (counting those outside the box).
  void insert(const std::vector<Vec3> &points, uint64_t cell_limit, Progress &progress);

  /// Insert one more point with the next number, unless a vertex is nearer to it than `apart`.
  /// Returns whether it was inserted.
  bool insert_apart(const Vec3 &point, double apart);

  /// The tetrahedra as arrays; those outside the box are left out. Numbered in the
  /// order of their least vertices.
  Cells cells(Progress &progress);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace vbm::impl
