// SPDX-License-Identifier: GPL-3.0-or-later
// A fixed hash of indices: pseudo-random choices that are the same in every run.
#pragma once

#include <cstdint>

namespace vbm::impl {

/// 64 well-mixed bits of an index: the finaliser of Steele, Lea, Flood, "Fast splittable
/// pseudorandom number generators" (2014).
inline uint64_t hash_index(uint64_t index) {
  uint64_t h = index + 0x9e3779b97f4a7c15u;
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
  return h ^ (h >> 31);
}

} // namespace vbm::impl
