// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearest.h"

#include <algorithm>
#include <limits>

namespace vbm_filters {

struct Nearest::Search {
  const double *place;
  std::int32_t found = -1;
  double distance2 = std::numeric_limits<double>::infinity();
};

Nearest::Nearest(const double *points, std::vector<std::int32_t> numbers)
    : points_(points), numbers_(std::move(numbers)) {
  order(0, numbers_.size(), 0);
}

void Nearest::order(std::size_t begin, std::size_t end, int axis) {
  if (end - begin < 2) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto first = numbers_.begin();
  std::nth_element(first + static_cast<std::ptrdiff_t>(begin),
                   first + static_cast<std::ptrdiff_t>(middle),
                   first + static_cast<std::ptrdiff_t>(end), [&](std::int32_t a, std::int32_t b) {
                     return points_[3 * std::size_t(a) + axis] < points_[3 * std::size_t(b) + axis];
                   });
  order(begin, middle, (axis + 1) % 3);
  order(middle + 1, end, (axis + 1) % 3);
}

std::int32_t Nearest::find(const double *place) const {
  Search search{place};
  visit(0, numbers_.size(), 0, search);
  return search.found;
}

void Nearest::visit(std::size_t begin, std::size_t end, int axis, Search &search) const {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const std::int32_t number = numbers_[middle];
  const double *point = points_ + 3 * std::size_t(number);
  double distance2 = 0;
  for (int k = 0; k < 3; ++k)
    distance2 += (point[k] - search.place[k]) * (point[k] - search.place[k]);
  if (distance2 < search.distance2 || (distance2 == search.distance2 && number < search.found)) {
    search.distance2 = distance2;
    search.found = number;
  }
  const double beyond = search.place[axis] - point[axis];
  const int next = (axis + 1) % 3;
  const auto near = [&] {
    beyond < 0 ? visit(begin, middle, next, search) : visit(middle + 1, end, next, search);
  };
  const auto far = [&] {
    beyond < 0 ? visit(middle + 1, end, next, search) : visit(begin, middle, next, search);
  };
  near();
  if (beyond * beyond <= search.distance2) far();
}

} // namespace vbm_filters
