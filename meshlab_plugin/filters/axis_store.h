// SPDX-License-Identifier: GPL-3.0-or-later
// The axes behind the layers that hold them. A host's layer has room for triangles and radii, but
// not for the cells and samples that removing a part of the axis takes: so the axis is kept, and
// found again by the layer's own vertices and faces. Copies of a layer, and files it was saved to,
// find it too.
#pragma once

#include "layer.h"

#include <vbm/vbm.hpp>

#include <deque>
#include <memory>
#include <vector>

namespace vbm_filters {

struct KeptAxis {
  vbm::Axis axis;
  std::vector<Color> input_colors; // of the vertices of the layer it was made from, or empty
};

class AxisStore {
public:
  // The axes kept longest make room when there are more than kMost, or when they have more than
  // kMostVertices together, which stand for about a gigabyte; the newest two stay whatever their
  // size.
  static constexpr std::size_t kMost = 16, kMostVertices = 4000000;

  void keep(std::shared_ptr<const KeptAxis> axis);
  // The axis whose vertices and faces, rounded as hosts do, are the layer's; null if there is none.
  std::shared_ptr<const KeptAxis> find(const Layer &layer) const;

private:
  std::deque<std::shared_ptr<const KeptAxis>> kept_; // the newest first
};

} // namespace vbm_filters
