// SPDX-License-Identifier: GPL-3.0-or-later
// Which sample is at a place.
#pragma once

#include "core/vec3.h"

#include <cstdint>
#include <cstring>
#include <vector>

namespace vbm::impl {

/// The finisher of splitmix64.
inline uint64_t mix_bits(uint64_t h) {
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
  return h ^ (h >> 31);
}

/// A hash table with open addressing, slot -> sample + 1, 0 for none. The answer is always the
/// sample at that place, so the order of the slots never shows.
class PointTable {
public:
  /// For at most `count` samples.
  explicit PointTable(std::size_t count) {
    std::size_t size = 16;
    while (size < 2 * count) size *= 2;
    slot_.assign(size, 0);
  }

  /// The sample at p, or `next` if p is new, which it then names; the caller appends it to
  /// `position`.
  int32_t find_or_add(const std::vector<Vec3> &position, const Vec3 &p, int32_t next) {
    const std::size_t mask = slot_.size() - 1;
    for (std::size_t s = hash(p) & mask;; s = (s + 1) & mask) {
      if (slot_[s] == 0) {
        slot_[s] = next + 1;
        return next;
      }
      if (position[slot_[s] - 1] == p) return slot_[s] - 1;
    }
  }

private:
  static uint64_t bits_of(double value) {
    value += 0.0; // -0 becomes 0
    uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
  }
  static uint64_t hash(const Vec3 &p) {
    return mix_bits(bits_of(p.x) +
                    mix_bits(bits_of(p.y) + mix_bits(bits_of(p.z) + 0x9e3779b97f4a7c15u)));
  }

  std::vector<int32_t> slot_;
};

} // namespace vbm::impl
