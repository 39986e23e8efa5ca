// SPDX-License-Identifier: GPL-3.0-or-later
// How far apart samples should be from place to place.
#pragma once

#include "core/vec3.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vbm::impl {

/// A place that needs samples at most `spacing` apart, as does all within `reach` of it.
struct SpacingSite {
  Vec3 at;
  double spacing, reach;
};

/// A spacing that is nowhere more than `most`, and from the sites on grows by kSpacingGrowth of the
/// distance. Unit frame lengths. Queries are const and use no state.
class SpacingField {
public:
  explicit SpacingField(double most, std::vector<SpacingSite> sites = {});

  double at(const Vec3 &p) const;
  bool constant() const { return site_.empty(); }
  double most() const { return most_; }
  double least() const { return least_; }

private:
  struct Node {
    Vec3 low, high;
    double spacing, reach; // the least and the largest of its sites
    std::size_t begin, end;
    int32_t right; // the left child follows its parent; -1: a leaf
  };
  int32_t add_node(std::size_t begin, std::size_t end);

  double most_, least_;
  std::vector<SpacingSite> site_;
  std::vector<Node> node_;
};

} // namespace vbm::impl
