// SPDX-License-Identifier: GPL-3.0-or-later
// Edges in the order of their ends: a counting sort by the lower one, and then small sorts, as few
// edges have one end in common.
#pragma once

#include "core/progress.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vbm::impl {

/// By `high`; those with the same stay in their order.
template <class Iterator> void sort_by_high(Iterator first, Iterator last) {
  constexpr std::ptrdiff_t kFew = 32;
  if (last - first > kFew) {
    std::stable_sort(first, last, [](const auto &a, const auto &b) { return a.high < b.high; });
    return;
  }
  for (Iterator i = first; i < last; ++i) {
    const auto edge = *i;
    Iterator at = i;
    for (; at != first && edge.high < (at - 1)->high; --at) *at = *(at - 1);
    *at = edge;
  }
}

/// By `low`, then `high`, which are less than `vertices`; those with the same ends stay in their
/// order.
template <class Edge>
void sort_edges(std::vector<Edge> &edges, std::size_t vertices, Progress &progress) {
  std::vector<uint32_t> end(vertices + 1, 0); // of each vertex's, when it is filled
  for (const Edge &e : edges) ++end[std::size_t(e.low) + 1];
  for (std::size_t v = 0; v < vertices; ++v) end[v + 1] += end[v];
  progress.tick_slow(0, 1);
  std::vector<Edge> sorted(edges.size());
  for (const Edge &e : edges) {
    progress.tick(0, 1);
    sorted[end[e.low]++] = e;
  }
  for (std::size_t v = 0, begin = 0; v < vertices; begin = end[v], ++v) {
    progress.tick(0, 1);
    sort_by_high(sorted.begin() + std::ptrdiff_t(begin), sorted.begin() + std::ptrdiff_t(end[v]));
  }
  edges.swap(sorted);
}

} // namespace vbm::impl
