// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary is a disk at a sample if and only if both the inside and the outside tetrahedra
// round it hang together across the facets they share there: on the sphere of directions, two
// connected sets that fill it meet in one closed curve. The curve is looked at first, since it has
// far fewer edges than there are tetrahedra; counting the groups is for samples where it is not in
// order.
#include "balls/stars.h"

#include <algorithm>
#include <numeric>

namespace vbm::impl {

namespace {

/// An edge of the curve in which the boundary meets the directions from a sample: the other two
/// corners of a boundary facet.
struct Edge {
  int32_t from, to;
};

template <class Visit>
void for_each_edge(const Cells &cells, const std::vector<uint8_t> &inside, Progress &progress,
                   Visit visit) {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    progress.tick(c, cells.size());
    if (!inside[c]) continue;
    for (int i = 0; i < 4; ++i)
      if (const int32_t n = cells.neighbor[c][i]; n < 0 || !inside[n])
        for (int k = 0; k < 3; ++k) {
          const auto corner = [&](int j) { return cells.vertex[c][kFacet[i][(k + j) % 3]]; };
          if (corner(0) < cells.samples) visit(corner(0), Edge{corner(1), corner(2)});
        }
  }
}

constexpr std::ptrdiff_t kFew = 32; // edges that are looked through one by one; more are sorted

/// Whether the edges make one closed line that passes no point twice.
bool one_loop(Edge *begin, Edge *end) {
  const auto by_start = [](const Edge &a, const Edge &b) { return a.from < b.from; };
  const bool sorted = end - begin > kFew;
  if (sorted) std::sort(begin, end, by_start);
  std::ptrdiff_t steps = 0;
  const Edge *at = begin;
  do { // if two edges start at one point, the second is never taken
    const int32_t to = at->to;
    at = sorted ? std::lower_bound(begin, end, Edge{to, 0}, by_start)
                : std::find_if(begin, end, [&](const Edge &e) { return e.from == to; });
    ++steps;
  } while (at != begin && at != end && steps <= end - begin);
  return at == begin && steps == end - begin;
}

int32_t find(std::vector<int32_t> &parent, int32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

} // namespace

std::vector<Sheets> find_sheets(const Cells &cells, const std::vector<uint8_t> &inside,
                                Progress &progress) {
  std::vector<uint32_t> first(std::size_t(cells.samples) + 1, 0);
  for_each_edge(cells, inside, progress, [&](int32_t s, Edge) { ++first[s + 1]; });
  for (int32_t s = 0; s < cells.samples; ++s) first[s + 1] += first[s];
  std::vector<Edge> edges(first.back());
  std::vector<uint32_t> next(first.begin(), first.end() - 1);
  for_each_edge(cells, inside, progress, [&](int32_t s, Edge edge) { edges[next[s]++] = edge; });
  std::vector<Sheets> out(cells.samples, Sheets::none);
  for (int32_t s = 0; s < cells.samples; ++s) {
    progress.tick(s, cells.samples);
    if (first[s] == first[s + 1]) continue;
    const bool disk = one_loop(edges.data() + first[s], edges.data() + first[s + 1]);
    out[s] = disk ? Sheets::disk : Sheets::several;
  }
  return out;
}

Star::Star(const Cells &cells)
    : cells_(cells), any_cell_(cells.samples, -1), local_(cells.size(), 0) {
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (int32_t v : cells.vertex[c])
      if (v < cells.samples) any_cell_[v] = int32_t(c);
}

void Star::go_to(int32_t sample) {
  star_.clear();
  touching_.clear();
  const auto add = [&](int32_t c) {
    local_[c] = int32_t(star_.size());
    star_.push_back(c);
  };
  if (any_cell_[sample] >= 0) add(any_cell_[sample]);
  for (std::size_t i = 0; i < star_.size(); ++i)
    for (int k = 0; k < 4; ++k) {
      const int32_t c = star_[i], n = cells_.neighbor[c][k];
      if (cells_.vertex[c][k] == sample || n < 0) continue; // the facet opposite the sample
      // local_ may be from another star: only an entry that points back counts.
      if (std::size_t(local_[n]) >= star_.size() || star_[local_[n]] != n) add(n);
      if (local_[n] > int32_t(i)) touching_.push_back({int32_t(i), local_[n]});
    }
}

int Star::surplus(const std::vector<uint8_t> &inside) {
  const bool mixed = std::any_of(star_.begin(), star_.end(),
                                 [&](int32_t c) { return inside[c] != inside[star_[0]]; });
  if (!mixed) return 0;
  int groups = int(star_.size());
  parent_.resize(star_.size());
  std::iota(parent_.begin(), parent_.end(), 0);
  for (const auto &[i, j] : touching_) {
    if (inside[star_[i]] != inside[star_[j]]) continue;
    const int32_t a = find(parent_, i), b = find(parent_, j);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b), --groups;
  }
  return groups - 2;
}

} // namespace vbm::impl
