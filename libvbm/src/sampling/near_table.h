// SPDX-License-Identifier: GPL-3.0-or-later
// Which sample is at a place, or too near to it to be told apart.
#pragma once

#include "core/vec3.h"
#include "sampling/point_table.h"
#include "sampling/tolerances.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace vbm::impl {

/// A grid of cubes of four times kNearDuplicate, hashed with open addressing; the samples of a cube
/// form a list. All samples are farther than kNearDuplicate from each other, so lists are short.
class NearTable {
public:
  /// For at most `count` samples.
  explicit NearTable(std::size_t count) {
    std::size_t size = 16;
    while (size < 2 * count) size *= 2;
    first_.assign(size, -1);
    next_.reserve(count);
  }

  /// The sample nearest to p within kNearDuplicate (the earliest of equally near ones), or -1.
  int32_t find(const std::vector<Vec3> &position, const Vec3 &p) const {
    int64_t low[3], high[3];
    for (int a = 0; a < 3; ++a) {
      low[a] = cube(p[a] - kNearDuplicate);
      high[a] = cube(p[a] + kNearDuplicate);
    }
    int32_t best = -1;
    double nearest = kNearDuplicate;
    for (int64_t x = low[0]; x <= high[0]; ++x)
      for (int64_t y = low[1]; y <= high[1]; ++y)
        for (int64_t z = low[2]; z <= high[2]; ++z)
          for (int32_t s = first_[slot(position, x, y, z)]; s >= 0; s = next_[s]) {
            const double d = distance(position[s], p);
            if (d > nearest || (d == nearest && best >= 0 && best < s)) continue;
            best = s;
            nearest = d;
          }
    return best;
  }

  /// Enter the sample that was just appended to `position`.
  void add(const std::vector<Vec3> &position) {
    const int32_t s = int32_t(position.size()) - 1;
    const Vec3 &p = position[s];
    int32_t &first = first_[slot(position, cube(p.x), cube(p.y), cube(p.z))];
    next_.push_back(first);
    first = s;
  }

private:
  static int64_t cube(double x) { return int64_t(std::floor(x / (4 * kNearDuplicate))); }

  /// Where the list of that cube is, or could be put.
  std::size_t slot(const std::vector<Vec3> &position, int64_t x, int64_t y, int64_t z) const {
    const std::size_t mask = first_.size() - 1;
    std::size_t at = mix_bits(uint64_t(x) + mix_bits(uint64_t(y) + mix_bits(uint64_t(z)))) & mask;
    for (; first_[at] >= 0; at = (at + 1) & mask) {
      const Vec3 &p = position[first_[at]];
      if (cube(p.x) == x && cube(p.y) == y && cube(p.z) == z) break;
    }
    return at;
  }

  std::vector<int32_t> first_, next_;
};

} // namespace vbm::impl
