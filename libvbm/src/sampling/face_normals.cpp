// SPDX-License-Identifier: GPL-3.0-or-later
// Baerentzen and Aanaes, "Signed distance computation using the angle weighted pseudonormal"
// (2005): with these weights the sign of the dot product with the direction to a point near the
// surface says on which side of a closed mesh it is, whatever the triangulation.
#include "sampling/face_normals.h"

#include "core/progress.h"
#include "sampling/tolerances.h"

#include <cmath>

namespace vbm::impl {
namespace {

/// atan2(s, c) for s >= 0 to 1e-5 (Abramowitz and Stegun, 4.4.47): as weights need no more, and the
/// C library's is slower and not the same on every host.
double angle_of(double s, double c) {
  const double x = std::fabs(c), low = std::fmin(s, x), high = std::fmax(s, x);
  if (!(high > 0)) return 0;
  const double z = low / high, q = z * z;
  double a =
      z * (0.9998660 + q * (-0.3302995 + q * (0.1801410 + q * (-0.0851330 + q * 0.0208351))));
  if (s > x) a = kPi / 2 - a;
  return c < 0 ? kPi - a : a;
}

} // namespace

std::vector<Vec3> face_normals(const std::vector<Triangle> &triangles,
                               const std::vector<Vec3> &position, Progress &progress) {
  std::vector<Vec3> normals(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if ((t & 1023) == 0) progress.tick(0, 1);
    const Vec3 a = position[triangles[t][0]];
    normals[t] = unit(cross(position[triangles[t][1]] - a, position[triangles[t][2]] - a));
  }
  return normals;
}

double corner_angle(const Triangle &triangle, int c, const std::vector<Vec3> &position) {
  const Vec3 p = position[triangle[c]], u = position[triangle[(c + 1) % 3]] - p,
             v = position[triangle[(c + 2) % 3]] - p;
  return angle_of(length(cross(u, v)), dot(u, v));
}

std::vector<Vec3> vertex_normals(const std::vector<Triangle> &triangles,
                                 const std::vector<Vec3> &position,
                                 const std::vector<Vec3> &face_normal, Progress &progress) {
  std::vector<Vec3> normals(position.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if ((t & 1023) == 0) progress.tick(0, 1);
    for (int c = 0; c < 3; ++c)
      normals[triangles[t][c]] += face_normal[t] * corner_angle(triangles[t], c, position);
  }
  for (Vec3 &n : normals) n = length(n) > kOppositeNormals ? unit(n) : Vec3{};
  return normals;
}

Vec3 edge_normal(const TriangleMesh &mesh, const Edge &edge, const std::vector<Vec3> &face_normal) {
  Vec3 sum;
  for (int32_t s = edge.begin; s < edge.end; ++s) sum += face_normal[mesh.side[s] / 3];
  return length(sum) > kOppositeNormals ? unit(sum) : Vec3{};
}

} // namespace vbm::impl
