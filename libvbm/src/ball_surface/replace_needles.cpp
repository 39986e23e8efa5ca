// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball_surface/replace_needles.h"

#include "ball_surface/flip_needles.h"
#include "ball_surface/pair_triangles.h"

#include <algorithm>

namespace vbm::impl {
namespace {

/// The corners of two triangles with an edge in common, in order.
std::array<int32_t, 4> around(const std::array<int32_t, 3> &a, const std::array<int32_t, 3> &b) {
  for (int k = 0; k < 3; ++k) {
    if (std::find(b.begin(), b.end(), a[k]) != b.end()) continue;
    // a[k] is not in b; a's other two are, and b's third lies across.
    for (int32_t v : b)
      if (std::find(a.begin(), a.end(), v) == a.end())
        return {a[k], a[(k + 1) % 3], v, a[(k + 2) % 3]};
  }
  return {a[0], a[1], a[2], a[2]};
}

} // namespace

void replace_needles(PatchMesh &mesh, Triangles &triangles, const std::vector<Ball> &balls,
                     const std::vector<uint8_t> &wide, Progress &progress) {
  std::vector<int32_t> ball;
  ball.reserve(triangles.polygon.size());
  for (int32_t p : triangles.polygon) ball.push_back(mesh.ball[p]);
  const std::vector<uint8_t> moved =
      flip_needles(mesh.position, balls, wide, triangles.corners, ball, progress);
  std::vector<uint8_t> broken(mesh.ball.size(), 0), free(moved.size(), 0);
  for (std::size_t t = 0; t < moved.size(); ++t)
    if (moved[t]) broken[triangles.polygon[t]] = 1;
  for (std::size_t t = 0; t < moved.size(); ++t) free[t] = broken[triangles.polygon[t]];
  const std::vector<int32_t> partner =
      pair_triangles(mesh.position, triangles.corners, free, progress);

  PatchMesh made;
  Triangles sorted;
  made.polygons.index.reserve(mesh.polygons.index.size());
  made.polygons.offset.reserve(mesh.polygons.offset.size());
  made.ball.reserve(mesh.ball.size());
  sorted.corners.reserve(triangles.corners.size());
  sorted.polygon.reserve(triangles.polygon.size());
  const auto add_triangle = [&](std::size_t t) {
    sorted.corners.push_back(triangles.corners[t]);
    sorted.polygon.push_back(int32_t(made.ball.size()));
  };
  const auto add_polygon = [&](const int32_t *begin, const int32_t *end, int32_t b) {
    made.polygons.index.insert(made.polygons.index.end(), begin, end);
    made.polygons.offset.push_back(made.polygons.index.size());
    made.ball.push_back(b);
  };
  std::size_t t = 0;
  for (std::size_t p = 0; p < mesh.ball.size(); ++p) {
    for (; t < moved.size() && triangles.polygon[t] == int32_t(p); ++t) {
      if (!free[t]) {
        add_triangle(t);
        continue;
      }
      const int32_t other = partner[t];
      if (other >= 0 && other < int32_t(t)) continue; // was the first of its pair's
      add_triangle(t);
      if (other < 0) {
        add_polygon(triangles.corners[t].data(), triangles.corners[t].data() + 3, ball[t]);
        continue;
      }
      add_triangle(std::size_t(other));
      const auto quad = around(triangles.corners[t], triangles.corners[other]);
      add_polygon(quad.data(), quad.data() + 4, ball[t]);
    }
    if (!broken[p])
      add_polygon(mesh.polygons.index.data() + mesh.polygons.offset[p],
                  mesh.polygons.index.data() + mesh.polygons.offset[p + 1], mesh.ball[p]);
  }
  mesh.polygons = std::move(made.polygons);
  mesh.ball = std::move(made.ball);
  triangles.corners = std::move(sorted.corners);
  triangles.polygon = std::move(sorted.polygon);
}

} // namespace vbm::impl
