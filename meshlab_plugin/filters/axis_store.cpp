// SPDX-License-Identifier: GPL-3.0-or-later
#include "axis_store.h"

#include <algorithm>

namespace vbm_filters {
namespace {

bool same(const vbm::Axis &axis, const Layer &layer) {
  const auto vertices = axis.vertices();
  const auto triangles = axis.triangles();
  if (3 * vertices.size != layer.points.size() || 3 * triangles.size != layer.triangles.size())
    return false;
  for (std::size_t t = 0; t < triangles.size; ++t) {
    const std::int32_t *own = triangles[t], *shown = &layer.triangles[3 * t];
    // Some are turned over in layers.
    const bool turned = own[1] == shown[2] && own[2] == shown[1];
    if (own[0] != shown[0] || !(turned || (own[1] == shown[1] && own[2] == shown[2]))) return false;
  }
  return std::equal(vertices.begin(), vertices.end(), layer.points.begin(), [](double a, double b) {
    return static_cast<float>(a) == static_cast<float>(b);
  });
}

} // namespace

void AxisStore::keep(std::shared_ptr<const KeptAxis> axis) {
  kept_.push_front(std::move(axis));
  std::size_t count = 0, vertices = 0;
  for (const auto &each : kept_) {
    vertices += each->axis.radii().size;
    if (count >= kMost || (count >= 2 && vertices > kMostVertices)) break;
    ++count;
  }
  kept_.resize(count);
}

std::shared_ptr<const KeptAxis> AxisStore::find(const Layer &layer) const {
  for (const auto &each : kept_)
    if (same(each->axis, layer)) return each;
  return nullptr;
}

} // namespace vbm_filters
