// SPDX-License-Identifier: GPL-3.0-or-later
// Singular points at one place made one, the surface unchanged.
#pragma once

#include "ball_surface/patch_complex.h"
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
};

/// Contracts arcs of no length, and takes out patches that are left with one or two arcs.
/// Afterwards no two arcs have the same ends, none ends where it begins, and all patches have three
/// darts or more, or none. `sample` receives the sample that each vertex is, or -1. Returns how
/// many singular points went.
std::size_t merge_points(PatchComplex &complex, const DualShape &shape, const PatchOptions &options,
                         const TouchedSamples &touched, std::vector<int32_t> &sample,
                         Progress &progress);

} // namespace vbm::impl
