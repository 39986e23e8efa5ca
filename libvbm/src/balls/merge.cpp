// SPDX-License-Identifier: GPL-3.0-or-later
// Every ball is grown from its best conditioned tetrahedron, over facets, as far as the vertices
// lie on that one sphere. Comparing neighbours alone would not do: a sliver of four cocircular
// samples lies on the spheres of both sides of the surface, and would join an inside ball to an
// outside one.
#include "balls/merge.h"

#include "core/tolerances.h"

#include <algorithm>

namespace vbm::impl {

BallSet merge_cospherical(const Cells &cells, const std::vector<Vec3> &samples,
                          Circumballs circumballs, Progress &progress,
                          const std::vector<uint8_t> *only) {
  const std::vector<float> &condition = circumballs.condition;
  const auto admitted = [&](int32_t c) { return !only || (*only)[c]; };
  const auto better = [&](int32_t a, int32_t b) {
    return condition[a] < condition[b] || (condition[a] == condition[b] && a < b);
  };
  // Whether the vertex that the neighbour across facet i of cell c has, and c has not, is on the
  // sphere of `ball`.
  const auto on_sphere = [&](int32_t c, int i, int32_t ball) {
    // Index sums over the three vertices they share.
    int64_t far = -int64_t(cells.vertex[c][0]) - cells.vertex[c][1] - cells.vertex[c][2] -
                  cells.vertex[c][3] + cells.vertex[c][i];
    for (int32_t v : cells.vertex[cells.neighbor[c][i]]) far += v;
    if (far >= cells.samples) return false;
    const Ball &b = circumballs.ball[ball];
    const double off = std::fabs(distance(samples[far], b.center) - b.radius);
    if (!(off < kCospherical)) return false;
    for (int32_t v : cells.vertex[c])
      if (v < cells.samples && off > kCosphericalShare * distance(samples[far], samples[v]))
        return false;
    return true;
  };

  const int32_t count = int32_t(cells.size());
  std::vector<int32_t> seeds; // cells with a neighbour on their sphere
  for (int32_t c = 0; c < count; ++c) {
    progress.tick(c, cells.size());
    if (!admitted(c)) continue;
    for (int i = 0; i < 4; ++i) {
      const int32_t n = cells.neighbor[c][i];
      if (n < 0 || !admitted(n) || !better(c, n) || !on_sphere(c, i, c)) continue;
      seeds.push_back(c);
      break;
    }
  }
  std::sort(seeds.begin(), seeds.end(), [&](int32_t a, int32_t b) {
    progress.tick(1, 1);
    return better(a, b);
  });

  progress.tick_slow(1, 1);
  std::vector<int32_t> root(cells.size(), -1), todo;
  progress.tick_slow(1, 1);
  for (int32_t seed : seeds) {
    if (root[seed] >= 0) continue;
    root[seed] = seed;
    todo.push_back(seed);
    while (!todo.empty()) {
      progress.tick(0, 1);
      const int32_t c = todo.back();
      todo.pop_back();
      for (int i = 0; i < 4; ++i) {
        const int32_t n = cells.neighbor[c][i];
        if (n < 0 || root[n] >= 0 || !admitted(n) || !on_sphere(c, i, seed)) continue;
        root[n] = seed;
        todo.push_back(n);
      }
    }
  }

  BallSet out;
  out.of_cell.assign(cells.size(), -1);
  int32_t balls = 0;
  for (int32_t c = 0; c < count; ++c) {
    progress.tick(1, 1);
    const int32_t r = root[c] < 0 ? c : root[c];
    if (out.of_cell[r] < 0) {
      circumballs.ball[balls] = circumballs.ball[r]; // in place: balls <= c <= r
      out.of_cell[r] = balls++;
    }
    out.of_cell[c] = out.of_cell[r];
  }
  circumballs.ball.resize(balls);
  out.ball = std::move(circumballs.ball);
  return out;
}

} // namespace vbm::impl
