// SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/wedges.h"

#include "dual/orthospheres.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {

constexpr double kPi = 3.14159265358979323846;

Axis3::Axis3(const Site &a, const Site &b) {
  const Vec3 e = center_of(b) - center_of(a);
  length = impl::length(e);
  direction = unit(e);
  const double step = (a.r - b.r) * (a.r + b.r) / length;
  height_a = (length + step) / 2;
  height_b = (length - step) / 2;
  center = center_of(a) + direction * height_a;
  // From the smaller ball, whose radius has the smaller rounding.
  const double r = std::min(a.r, b.r), h = a.r < b.r ? height_a : height_b;
  radius = std::sqrt(std::max(0.0, (r - h) * (r + h)));
}

double facet_angle(const Axis3 &axis, const Vec3 &from, const Vec3 &to) {
  const Vec3 p = axis.perpendicular(from), q = axis.perpendicular(to);
  return std::atan2(std::max(0.0, dot(axis.direction, cross(p, q))), dot(p, q));
}

double outside_angle(const DualShape &shape, const DualShape::Edge &edge, const Axis3 &axis,
                     uint32_t turn) {
  if (edge.begin + 1 == edge.end) return 2 * kPi;
  const int32_t last = shape.cell_of(next_turn(edge, turn));
  const Vec3 a = shape.position(edge.a);
  double sum = 0;
  int32_t at = shape.cell_of(turn);
  do {
    const PowerDiagram::Cell &cell = shape.cells[at];
    const int i = index_of(cell, edge.a), j = index_of(cell, edge.b), k = kTurn[i][j],
              l = 6 - i - j - k;
    sum += facet_angle(axis, shape.position(cell.ball[k]) - a, shape.position(cell.ball[l]) - a);
    at = cell.neighbor[k] >> 2;
  } while (at != last);
  return sum;
}

} // namespace vbm::impl
