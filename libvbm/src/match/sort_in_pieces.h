// SPDX-License-Identifier: GPL-3.0-or-later
// Sorting that can be cancelled.
#pragma once

#include "core/progress.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vbm::impl {

/// std::sort, with a look at the progress every few milliseconds: pieces sorted and merged.
template <class T, class Less>
void sort_in_pieces(std::vector<T> &list, Less less, Progress &progress) {
  constexpr std::size_t kPiece = 1 << 15;
  const std::size_t size = list.size();
  for (std::size_t begin = 0; begin < size; begin += kPiece) {
    if (begin) progress.tick_slow(0, 1);
    std::sort(list.begin() + std::ptrdiff_t(begin),
              list.begin() + std::ptrdiff_t(std::min(begin + kPiece, size)), less);
  }
  if (size <= kPiece) return;
  std::vector<T> merged(size);
  for (std::size_t width = kPiece; width < size; width *= 2) {
    for (std::size_t begin = 0; begin < size; begin += 2 * width) {
      progress.tick_slow(0, 1);
      const auto at = [&](std::size_t i) {
        return list.begin() + std::ptrdiff_t(std::min(i, size));
      };
      std::merge(at(begin), at(begin + width), at(begin + width), at(begin + 2 * width),
                 merged.begin() + std::ptrdiff_t(begin), less);
    }
    list.swap(merged);
  }
}

} // namespace vbm::impl
