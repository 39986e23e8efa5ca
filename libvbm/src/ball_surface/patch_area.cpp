// SPDX-License-Identifier: GPL-3.0-or-later
// The theorem of Gauss and Bonnet: a part of a sphere is as large as its border turns less than a
// plane one's would.
#include "ball_surface/patch_area.h"

#include "dual/orthospheres.h"
#include "dual/wedges.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

constexpr double kPi = 3.14159265358979323846;

} // namespace

double loop_angle(const BoundaryMap &map, const DualShape &shape, int32_t first) {
  const Site &ball = shape.site[map.ball_of(shape, first)];
  const Vec3 middle = center_of(ball);
  const auto axis_of = [&](int32_t side) {
    const DualShape::Edge &edge = shape.edges[map.spans[side / 2].edge];
    return Axis3(shape.site[edge.a], shape.site[edge.b]);
  };
  const auto height = [&](const Axis3 &axis, int32_t side) {
    return (side & 1 ? axis.height_b : axis.height_a) / ball.r;
  };
  double sum = 2 * kPi;
  int32_t at = first;
  do {
    const int32_t next = map.next[at];
    const Axis3 axis = axis_of(at), after = axis_of(next);
    const double up = height(axis, at), uq = height(after, next);
    sum += up * map.spans[at / 2].angle;
    const Vec3 u = (map.position[map.from[next]] - middle) * (1 / ball.r);
    // The angle between the planes through the corner's direction and those to the other balls.
    const Vec3 &p = axis.direction, &q = after.direction;
    const double same = (at & 1) == (next & 1) ? 1 : -1;
    sum -= std::atan2(std::fabs(dot(u, cross(p, q))), same * dot(p, q) - up * uq);
    at = next;
  } while (at != first);
  return sum;
}

std::vector<double> spacings(const BoundaryMap &map, const DualShape &shape) {
  const std::size_t balls = shape.vertex.size();
  std::vector<double> area(balls, 0), sum(balls, 0);
  std::vector<int32_t> count(balls, 1);
  for (std::size_t b = 0; b < balls; ++b)
    sum[b] = area[b] = std::max(0.0, map.bare[b]) * shape.site[b].r * shape.site[b].r;
  for (const DualShape::Edge &e : shape.edges) {
    sum[e.a] += area[e.b];
    sum[e.b] += area[e.a];
    ++count[e.a];
    ++count[e.b];
  }
  for (std::size_t b = 0; b < balls; ++b) sum[b] = std::sqrt(sum[b] / count[b]);
  return sum;
}

} // namespace vbm::impl
