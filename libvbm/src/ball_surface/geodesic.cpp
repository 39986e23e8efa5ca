// SPDX-License-Identifier: GPL-3.0-or-later
// Fuller's geodesic spheres of class I.
#include "ball_surface/geodesic.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vbm::impl {
namespace {

/// Radians from the middle of an icosahedron's face to its corners, and along its edges; finer
/// spheres have them divided, and at worst a bit more, by the pieces.
constexpr double kFaceAngle = 0.6524, kEdgeAngle = 1.1072, kUneven = 1.18;

Geodesic icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  Geodesic s;
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 0; k < 4; ++k) {
      Vec3 p;
      p[axis] = k & 1 ? 1 : -1;
      p[(axis + 1) % 3] = k & 2 ? g : -g;
      s.points.push_back(unit(p));
    }
  // Faces are the triples of points that are nearest to each other.
  const double near = 2 * std::sin(kEdgeAngle / 2) * 1.01;
  for (int32_t i = 0; i < 12; ++i)
    for (int32_t j = i + 1; j < 12; ++j)
      for (int32_t k = j + 1; k < 12; ++k) {
        const Vec3 &a = s.points[i], &b = s.points[j], &c = s.points[k];
        if (distance(a, b) > near || distance(b, c) > near || distance(c, a) > near) continue;
        if (dot(a, cross(b, c)) > 0)
          s.triangles.push_back({i, j, k});
        else
          s.triangles.push_back({i, k, j});
      }
  return s;
}

} // namespace

Geodesic geodesic_sphere(double bulge) {
  const double reach = std::acos(std::max(-1.0, 1 - bulge));
  const int f = reach >= kFaceAngle ? 1 : int(std::ceil(kUneven * kFaceAngle / reach));
  const Geodesic coarse = icosahedron();
  Geodesic fine;
  std::map<std::array<int32_t, 6>, int32_t> number; // of a point, by its weights at the corners
  const auto point = [&](const std::array<int32_t, 3> &t, int i, int j) {
    const int weight[3] = {f - i - j, i, j};
    std::array<int32_t, 6> key{-1, -1, -1, 0, 0, 0};
    int order[3] = {0, 1, 2}, at = 0;
    std::sort(order, order + 3, [&](int a, int b) { return t[a] < t[b]; });
    Vec3 p;
    for (int k : order) {
      if (!weight[k]) continue;
      key[at] = t[k];
      key[3 + at++] = weight[k];
      p += coarse.points[t[k]] * double(weight[k]);
    }
    const auto [found, fresh] = number.emplace(key, int32_t(fine.points.size()));
    if (fresh) fine.points.push_back(unit(p));
    return found->second;
  };
  for (const auto &t : coarse.triangles)
    for (int i = 0; i < f; ++i)
      for (int j = 0; i + j < f; ++j) {
        fine.triangles.push_back({point(t, i, j), point(t, i + 1, j), point(t, i, j + 1)});
        if (i + j + 1 < f)
          fine.triangles.push_back(
              {point(t, i + 1, j), point(t, i + 1, j + 1), point(t, i, j + 1)});
      }
  fine.spacing = kEdgeAngle / f;
  return fine;
}

} // namespace vbm::impl
