// SPDX-License-Identifier: GPL-3.0-or-later
// From input points to distinct samples in the unit frame.
#pragma once

#include "core/samples.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// Fill frame, position, input, input_position, input_sample, input_points, dropped and merged of
/// `samples` from count x 3 numbers. Points within kNearDuplicate of a sample (so 0 and -0, too)
/// become that one, others a new one; samples keep the points' order. Points with 0 in `keep` (one
/// byte a point, or empty: all) are left out and may be anything. Appends a note where merging or
/// the distance from the origin costs precision. Linear time; no result depends on hash order.
void merge_points(const double *points, std::size_t count, const std::vector<uint8_t> &keep,
                  Samples &samples, Progress &progress);

/// Turn count directions (zero: unknown) into the samples' unit normals: those of merged points are
/// added up. Opposite ones give zero. `direction` may be of any length.
void merge_normals(const std::vector<Vec3> &direction, Samples &samples);

/// a / |a| without overflow or underflow on the way, or zero if a is zero or not finite.
Vec3 safe_unit(const Vec3 &a);

} // namespace vbm::impl
