// SPDX-License-Identifier: GPL-3.0-or-later
// Balls to make a surface of, and what is known about them.
#pragma once

#include "core/frame.h"
#include "core/model.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vbm::impl {

class Progress;

struct UnionInput {
  Frame frame;
  std::vector<Ball> balls;      // unit frame
  std::vector<int32_t> number;  // the caller's of each
  std::size_t points = 0;       // left out, as they have no radius
  double touch = 0;             // see dual_shape()
  const Model *model = nullptr; // the balls are inner ones of this
};

/// Throws Error(VBM_ERROR_NO_INTERIOR) if there is no ball.
void check_any(const UnionInput &set);

/// "3 balls have no radius ...", with its newline, or nothing.
std::string note_on_points(const UnionInput &set);

/// Fills report.gap_max and gap_mean: how far the middles of the triangles are from the spheres
/// they stand for. polygon_ball counts set.balls.
void fill_gaps(Surface &surface, const UnionInput &set, Progress &progress);

} // namespace vbm::impl
