// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/triangle_mesh.h"

#include "core/progress.h"

#include <algorithm>

namespace vbm::impl {
namespace {

/// Counting sort: the items 0..count-1 in buckets, `bucket(item)` < buckets; items of one bucket
/// stay ascending. Returns the items; begin[b]..begin[b + 1] are those of bucket b.
template <class Bucket>
std::vector<int32_t> sort_into(std::size_t count, std::size_t buckets, Bucket bucket,
                               std::vector<int32_t> &begin) {
  begin.assign(buckets + 2, 0);
  for (std::size_t i = 0; i < count; ++i) ++begin[bucket(i) + 2];
  for (std::size_t b = 2; b < begin.size(); ++b) begin[b] += begin[b - 1];
  std::vector<int32_t> items(count);
  for (std::size_t i = 0; i < count; ++i) items[begin[bucket(i) + 1]++] = static_cast<int32_t>(i);
  begin.pop_back();
  return items;
}

/// The triangle's corners ascending, and whether that took an odd number of swaps.
struct Sorted {
  Triangle corner;
  bool odd = false;
  explicit Sorted(const Triangle &t) : corner(t) {
    const auto order = [this](int i, int j) {
      if (corner[i] <= corner[j]) return;
      std::swap(corner[i], corner[j]);
      odd = !odd;
    };
    order(0, 1), order(1, 2), order(0, 1);
  }
};

/// Decide about one set of triangles with the same corners, ascending.
template <class Odd>
void decide(const int32_t *first, const int32_t *last, Odd odd, std::vector<uint8_t> &keep,
            DoubleFaces &found) {
  int64_t net = 0;
  for (const int32_t *i = first; i < last; ++i) net += odd(*i) ? -1 : 1;
  const int32_t *kept = last;
  if (net != 0) kept = std::find_if(first, last, [&](int32_t t) { return odd(t) == (net < 0); });
  for (const int32_t *i = first; i < last; ++i) keep[*i] = i == kept;
  const std::size_t removed = static_cast<std::size_t>(last - first) - (net != 0);
  const std::size_t paired = static_cast<std::size_t>((last - first) - (net < 0 ? -net : net));
  found.cancelled += net == 0 ? paired : 0;
  found.repeated += net == 0 ? 0 : removed;
}

} // namespace

void TriangleMesh::turn(int32_t t) {
  const int32_t first = 3 * t, last = 3 * t + 2; // exchange edges; the side in the middle stays
  for (int32_t s = first; s <= last; ++s) {
    Edge &e = edge[edge_of_side[s]];
    e.balance += 2 * (triangle[t][s - first] == e.a ? -1 : 1); // still as it was
  }
  std::swap(triangle[t][1], triangle[t][2]);
  const Edge &e = edge[edge_of_side[first]], &f = edge[edge_of_side[last]];
  int32_t *const in_e = std::find(side.data() + e.begin, side.data() + e.end, first);
  int32_t *const in_f = std::find(side.data() + f.begin, side.data() + f.end, last);
  *in_e = last;
  *in_f = first;
  std::swap(edge_of_side[first], edge_of_side[last]);
}

DoubleFaces remove_double_faces(std::vector<Triangle> &triangles, std::size_t vertices) {
  DoubleFaces found;
  std::vector<int32_t> begin;
  std::vector<int32_t> order = sort_into(
      triangles.size(), vertices, [&](std::size_t t) { return Sorted(triangles[t]).corner[0]; },
      begin);
  std::vector<uint8_t> keep;
  const auto less = [&](int32_t s, int32_t t) {
    const Triangle a = Sorted(triangles[s]).corner, b = Sorted(triangles[t]).corner;
    return a != b ? a < b : s < t;
  };
  const auto same = [&](int32_t s, int32_t t) {
    return Sorted(triangles[s]).corner == Sorted(triangles[t]).corner;
  };
  const auto odd = [&](int32_t t) { return Sorted(triangles[t]).odd; };
  for (std::size_t v = 0; v < vertices; ++v) {
    if (begin[v + 1] - begin[v] < 2) continue;
    int32_t *const first = order.data() + begin[v], *const last = order.data() + begin[v + 1];
    std::sort(first, last, less);
    for (int32_t *i = first; i < last;) {
      int32_t *j = i + 1;
      while (j < last && same(*i, *j)) ++j;
      if (j - i > 1) {
        if (keep.empty()) keep.assign(triangles.size(), 1);
        decide(i, j, odd, keep, found);
      }
      i = j;
    }
  }
  if (keep.empty()) return found;
  if (std::find(keep.begin(), keep.end(), 1) == keep.end()) { // a sheet seen from both sides
    found.sheet = true;
    for (std::size_t i = 0; i < order.size(); ++i)
      if (i == 0 || !same(order[i - 1], order[i])) keep[order[i]] = 1;
  }
  std::size_t to = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (keep[t]) triangles[to++] = triangles[t];
  triangles.resize(to);
  return found;
}

bool find_edges(TriangleMesh &mesh, std::size_t vertices, Progress &progress) {
  const std::size_t sides = 3 * mesh.triangle.size();
  const auto lower_end = [&](std::size_t s) {
    const Triangle &t = mesh.triangle[s / 3];
    return std::min(t[s % 3], t[(s % 3 + 1) % 3]);
  };
  std::vector<int32_t> begin;
  progress.tick_slow(0, 1);
  mesh.side = sort_into(sides, vertices, lower_end, begin);
  progress.tick_slow(0, 1);
  mesh.edge_of_side.resize(sides);
  mesh.edge.clear();
  mesh.edge.reserve(sides / 2 + 16);
  struct Spoke {
    int32_t end, side, third; // the corner of its triangle that is not on it
    bool operator<(const Spoke &o) const { return end != o.end ? end < o.end : side < o.side; }
  };
  std::vector<Spoke> fan;
  bool doubled = false;
  for (std::size_t v = 0; v < vertices; ++v) {
    if ((v & 255) == 0) progress.tick(0, 1);
    fan.clear();
    for (int32_t i = begin[v]; i < begin[v + 1]; ++i) {
      const int32_t s = mesh.side[i];
      const Triangle &t = mesh.triangle[s / 3];
      const int32_t p = t[s % 3], q = t[(s % 3 + 1) % 3];
      fan.push_back({std::max(p, q), s, t[(s % 3 + 2) % 3]});
    }
    std::sort(fan.begin(), fan.end());
    for (std::size_t k = 0; k < fan.size(); ++k) {
      const int32_t at = begin[v] + static_cast<int32_t>(k), s = fan[k].side;
      if (k == 0 || fan[k].end != fan[k - 1].end)
        mesh.edge.push_back({static_cast<int32_t>(v), fan[k].end, at, at, 0});
      Edge &e = mesh.edge.back();
      const std::size_t before = at - e.begin; // sides of this edge
      if (before > 8) doubled = true;          // too many to compare each with each
      for (std::size_t j = k - before; j < k && !doubled; ++j)
        doubled = fan[j].third == fan[k].third;
      e.end = at + 1;
      mesh.side[at] = s;
      mesh.edge_of_side[s] = static_cast<int32_t>(mesh.edge.size() - 1);
      e.balance += mesh.direction(s);
    }
  }
  return doubled;
}

} // namespace vbm::impl
