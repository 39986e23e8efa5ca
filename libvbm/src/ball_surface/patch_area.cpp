// SPDX-License-Identifier: GPL-3.0-or-later
// The theorem of Gauss and Bonnet: a part of a sphere is as large as its border turns less than a
// plane one's would.
#include "ball_surface/patch_area.h"

#include "dual/orthospheres.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

constexpr double kPi = 3.14159265358979323846;

} // namespace

double loop_angle(const PatchComplex &c, const DualShape &shape, int32_t first) {
  const Site &ball = shape.site[c.patches[c.darts[first].patch].ball];
  const Vec3 middle = center_of(ball);
  double sum = 2 * kPi;
  int32_t at = first;
  do {
    const PatchComplex::Dart &d = c.darts[at], &next = c.darts[d.next];
    const PatchComplex::Arc &arc = c.arcs[d.arc];
    const PatchComplex::Circle &circle = c.circle(d);
    sum += (d.forward ? circle.height_b : circle.height_a) / ball.r * (arc.to - arc.from);
    if (circle.edge != c.circle(next).edge || d.next == at) {
      const PatchComplex::Circle &after = c.circle(next);
      const Vec3 u = (c.position[next.from] - middle) * (1 / ball.r);
      // The angle between the planes through the corner's direction and those to the other balls.
      const Vec3 &p = circle.axis, &q = after.axis;
      const double up = (d.forward ? circle.height_b : circle.height_a) / ball.r,
                   uq = (next.forward ? after.height_b : after.height_a) / ball.r;
      const double same = d.forward == next.forward ? 1 : -1;
      sum -= std::atan2(std::fabs(dot(u, cross(p, q))), same * dot(p, q) - up * uq);
    }
    at = d.next;
  } while (at != first);
  return sum;
}

std::vector<double> spacings(const PatchComplex &c, const DualShape &shape) {
  const std::size_t balls = shape.vertex.size();
  std::vector<double> area(balls, 0), sum(balls, 0);
  std::vector<int32_t> count(balls, 1);
  for (std::size_t b = 0; b < balls; ++b)
    sum[b] = area[b] = std::max(0.0, c.bare[b]) * shape.site[b].r * shape.site[b].r;
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
