// SPDX-License-Identifier: GPL-3.0-or-later
// Sorting by a number most of all: a counting sort, and then many small ones.
#pragma once

#include "core/progress.h"
#include "match/sort_in_pieces.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

namespace vbm::impl {

/// A list's elements by bucket_of(element), which is from 0 to buckets - 1, and those of one bucket
/// by `less`.
template <class List, class Bucket, class Less, class T = typename List::value_type>
std::unique_ptr<T[]> sorted_in_buckets(const List &list, std::size_t buckets, Bucket bucket_of,
                                       Less less, Progress &progress) {
  static_assert(std::is_trivially_default_constructible_v<T>); // else all are written before
  constexpr std::ptrdiff_t kFew = 1 << 15;   // at once, without a look at the progress
  std::vector<uint32_t> end(buckets + 1, 0); // of each bucket, when it is filled
  for (const T &t : list) {
    progress.tick(0, 1);
    ++end[std::size_t(bucket_of(t)) + 1];
  }
  for (std::size_t b = 0; b < buckets; ++b) end[b + 1] += end[b];
  std::unique_ptr<T[]> sorted(new T[list.size()]);
  for (const T &t : list) {
    progress.tick(0, 1);
    sorted[end[std::size_t(bucket_of(t))]++] = t;
  }
  for (std::size_t b = 0, begin = 0; b < buckets; begin = end[b], ++b) {
    progress.tick(0, 1);
    T *const first = sorted.get() + begin, *const last = sorted.get() + end[b];
    if (last - first <= kFew) {
      std::sort(first, last, less);
      continue;
    }
    std::vector<T> many(first, last);
    sort_in_pieces(many, less, progress);
    std::copy(many.begin(), many.end(), first);
  }
  return sorted;
}

} // namespace vbm::impl
