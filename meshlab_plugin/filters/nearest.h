// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest of many points: a k-d tree (Bentley 1975) that is an order of the points, no more.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vbm_filters {

class Nearest {
public:
  // Of the points (3 numbers each) with these numbers; both must be finite, and the points must
  // outlive the tree. O(n log n).
  Nearest(const double *points, std::vector<std::int32_t> numbers);

  // The number of the point nearest to this place, the smallest of several; -1 if there are none.
  std::int32_t find(const double *place) const;

private:
  struct Search;
  void order(std::size_t begin, std::size_t end, int axis);
  void visit(std::size_t begin, std::size_t end, int axis, Search &search) const;

  const double *points_;
  std::vector<std::int32_t> numbers_; // the middle of every range parts it along its axis
};

} // namespace vbm_filters
