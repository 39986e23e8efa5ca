// SPDX-License-Identifier: GPL-3.0-or-later
// Sorting by a number most of all: a counting sort, and then many small ones.
#pragma once

#include "core/progress.h"
#include "match/sort_in_pieces.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vbm::impl {

/// By bucket_of(element), which is from 0 to buckets - 1, and elements of one bucket by `less`.
template <class T, class Bucket, class Less>
void sort_in_buckets(std::vector<T> &list, std::size_t buckets, Bucket bucket_of, Less less,
                     Progress &progress) {
  constexpr std::ptrdiff_t kFew = 1 << 15;   // at once, without a look at the progress
  std::vector<uint32_t> end(buckets + 1, 0); // of each bucket, when it is filled
  for (const T &t : list) {
    progress.tick(0, 1);
    ++end[std::size_t(bucket_of(t)) + 1];
  }
  for (std::size_t b = 0; b < buckets; ++b) end[b + 1] += end[b];
  progress.tick_slow(0, 1);
  std::vector<T> sorted(list.size());
  for (const T &t : list) {
    progress.tick(0, 1);
    sorted[end[std::size_t(bucket_of(t))]++] = t;
  }
  for (std::size_t b = 0, begin = 0; b < buckets; begin = end[b], ++b) {
    progress.tick(0, 1);
    const auto first = sorted.begin() + std::ptrdiff_t(begin),
               last = sorted.begin() + std::ptrdiff_t(end[b]);
    if (last - first <= kFew) {
      std::sort(first, last, less);
      continue;
    }
    std::vector<T> many(first, last);
    sort_in_pieces(many, less, progress);
    std::copy(many.begin(), many.end(), first);
  }
  list.swap(sorted);
}

} // namespace vbm::impl
