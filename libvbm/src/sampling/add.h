// SPDX-License-Identifier: GPL-3.0-or-later
// Samples that are not input points.
#pragma once

#include "core/samples.h"
#include "sampling/point_table.h"

namespace vbm::impl {

/// Append a sample that is not an input point, at a place where no sample is yet (unit frame,
/// on kSampleGrid).
/// Keeps all per-sample arrays the same length; counts it as added. The normal (zero: unknown) is
/// ignored where the samples carry none.
void add_sample(Samples &samples, const Vec3 &position, const Vec3 &normal);

/// The same at the point of kSampleGrid nearest to a place, unless a sample is there already;
/// `table` holds all samples.
void add_new_sample(Samples &samples, PointTable &table, const Vec3 &place, const Vec3 &normal);

/// Make room for `count` samples more, once, before adding many.
void reserve_more(Samples &samples, std::size_t count);

} // namespace vbm::impl
