// SPDX-License-Identifier: GPL-3.0-or-later
// From "which vertices has this edge" to "which edges has this vertex", and the like.
#pragma once

#include "core/model.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vbm::impl {

/// For each of `count` elements the ascending numbers of those that visit(i, call) names it for.
template <class Visit>
Incidence lists_of(std::size_t count, std::size_t owners, const Visit &visit) {
  Incidence out;
  out.offset.assign(count + 1, 0);
  for (std::size_t i = 0; i < owners; ++i)
    visit(i, [&](int32_t element) { ++out.offset[std::size_t(element) + 1]; });
  for (std::size_t e = 0; e < count; ++e) out.offset[e + 1] += out.offset[e];
  out.index.resize(out.offset[count]);
  std::vector<uint64_t> next(out.offset.begin(), out.offset.end() - 1);
  for (std::size_t i = 0; i < owners; ++i)
    visit(i, [&](int32_t element) { out.index[next[std::size_t(element)]++] = int32_t(i); });
  return out;
}

inline Incidence lists_of(std::size_t count, const Incidence &lists) {
  return lists_of(count, lists.offset.size() - 1, [&](std::size_t i, auto &&call) {
    for (uint64_t k = lists.offset[i]; k < lists.offset[i + 1]; ++k) call(lists.index[k]);
  });
}

template <std::size_t N>
Incidence lists_of(std::size_t count, const std::vector<std::array<int32_t, N>> &rows) {
  return lists_of(count, rows.size(), [&](std::size_t i, auto &&call) {
    for (int32_t element : rows[i]) call(element);
  });
}

/// Sort rows in which first(row) is less than `count`: by that in one pass, then the few that share
/// it.
template <class Row, class First>
void sort_rows(std::vector<Row> &rows, std::size_t count, const First &first) {
  std::vector<std::size_t> next(count + 1, 0);
  for (const Row &row : rows) ++next[std::size_t(first(row)) + 1];
  for (std::size_t i = 0; i < count; ++i) next[i + 1] += next[i];
  std::vector<Row> out(rows.size());
  for (const Row &row : rows) out[next[std::size_t(first(row))]++] = row;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::sort(out.begin() + std::ptrdiff_t(begin), out.begin() + std::ptrdiff_t(next[i]));
    begin = next[i];
  }
  rows.swap(out);
}

} // namespace vbm::impl
