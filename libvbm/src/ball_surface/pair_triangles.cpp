// SPDX-License-Identifier: GPL-3.0-or-later
// A greedy matching: the flattest edge first.
#include "ball_surface/pair_triangles.h"

#include "core/progress.h"
#include "core/sort_edges.h"

#include <algorithm>

namespace vbm::impl {
namespace {

/// Cosine of the angle between the triangles of a pair, at least: 20 degrees.
constexpr double kFlatPair = 0.94;

struct Edge {
  int32_t low, high, triangle, apex; // the triangle's number among those that are free
};

} // namespace

std::vector<int32_t> pair_triangles(const std::vector<Vec3> &position,
                                    const std::vector<std::array<int32_t, 3>> &triangles,
                                    const std::vector<uint8_t> &free, Progress &progress) {
  std::vector<int32_t> partner(triangles.size(), -1);
  const std::size_t count = std::size_t(std::count(free.begin(), free.end(), uint8_t(1)));
  std::vector<Edge> edges;
  edges.reserve(3 * count);
  std::vector<int32_t> number; // of each triangle that is free
  std::vector<Vec3> normal;    // and its normal
  number.reserve(count);
  normal.reserve(count);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    progress.tick(t, triangles.size());
    if (!free[t]) continue;
    const auto &c = triangles[t];
    normal.push_back(unit(cross(position[c[1]] - position[c[0]], position[c[2]] - position[c[0]])));
    for (int k = 0; k < 3; ++k) {
      const int32_t u = c[k], v = c[(k + 1) % 3];
      edges.push_back({std::min(u, v), std::max(u, v), int32_t(number.size()), c[(k + 2) % 3]});
    }
    number.push_back(int32_t(t));
  }
  progress.tick_slow(1, 1);
  sort_edges(edges, position.size(), progress);
  struct Pair {
    double flat;
    int32_t a, b;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const Edge &e = edges[i - 1], &f = edges[i];
    if (e.low != f.low || e.high != f.high || e.apex == f.apex) continue;
    const Vec3 &n = normal[e.triangle], &m = normal[f.triangle];
    const double flat = dot(n, m);
    if (flat < kFlatPair) continue;
    // Convex where the edge ends.
    const Vec3 &p = position[e.low], &q = position[e.high], &x = position[e.apex],
               &y = position[f.apex], up = n + m;
    const double at_p = dot(cross(x - p, y - p), up), at_q = dot(cross(y - q, x - q), up);
    if (at_p * at_q <= 0) continue;
    pairs.push_back({flat, number[e.triangle], number[f.triangle]});
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair &a, const Pair &b) {
    if (a.flat != b.flat) return a.flat > b.flat;
    return a.a != b.a ? a.a < b.a : a.b < b.b;
  });
  for (const Pair &p : pairs)
    if (partner[p.a] < 0 && partner[p.b] < 0) {
      partner[p.a] = p.b;
      partner[p.b] = p.a;
    }
  return partner;
}

} // namespace vbm::impl
