// SPDX-License-Identifier: GPL-3.0-or-later
// Singular points at one place made one, the surface unchanged.
#pragma once

#include "ball_surface/complex_editor.h"
#include "core/model.h"

#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// The samples that balls touch, where they are known.
struct TouchedSamples {
  const Incidence *lists = nullptr;           // of the model's balls, ascending
  const std::vector<int32_t> *ball = nullptr; // the model's number of each ball
  const std::vector<Vec3> *position = nullptr;

  /// The first of three balls' common samples on a side of their centres' plane, -1 if there is
  /// none.
  int32_t common(const DualShape &shape, int32_t code) const;
  /// That of each of a complex's vertices.
  std::vector<int32_t> of(const PatchComplex &complex, const DualShape &shape,
                          Progress &progress) const;
};

/// Contracts arcs of no length, and closes patches that are left with one or two arcs. Returns how
/// many singular points went. `sample` is that of each vertex as it was at first.
std::size_t merge_points(ComplexEditor &editor, const std::vector<int32_t> &sample,
                         const PatchOptions &options, Progress &progress);

} // namespace vbm::impl
