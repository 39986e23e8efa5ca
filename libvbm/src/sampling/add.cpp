// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/add.h"

#include "core/grid.h"

namespace vbm::impl {

void add_new_sample(Samples &samples, PointTable &table, const Vec3 &place, const Vec3 &normal) {
  const Vec3 position = on_grid(place, kSampleGrid);
  const int32_t next = static_cast<int32_t>(samples.position.size());
  if (table.find_or_add(samples.position, position, next) == next)
    add_sample(samples, position, normal);
}

void reserve_more(Samples &samples, std::size_t count) {
  const std::size_t size = samples.position.size() + count;
  samples.position.reserve(size);
  samples.input.reserve(size);
  samples.input_position.reserve(size);
  if (!samples.normal.empty()) samples.normal.reserve(size);
}

void add_sample(Samples &samples, const Vec3 &position, const Vec3 &normal) {
  const bool with_normals = !samples.normal.empty();
  if (samples.input_is_samples)
    samples.input_sample.push_back(static_cast<int32_t>(samples.position.size()));
  samples.position.push_back(position);
  samples.input.push_back(-1);
  samples.input_position.push_back(samples.frame.to_input(position));
  if (with_normals) samples.normal.push_back(normal);
  ++samples.added;
}

} // namespace vbm::impl
