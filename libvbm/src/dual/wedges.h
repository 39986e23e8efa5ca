// SPDX-License-Identifier: GPL-3.0-or-later
// Angles about an edge of a dual shape.
#pragma once

#include "dual/dual_shape.h"

namespace vbm::impl {

/// An edge as an axis from a's centre to b's, and the circle its balls' spheres have in common.
struct Axis3 {
  Vec3 direction; // unit
  double length;
  double height_a, height_b; // of the circle's plane over a's and b's centre, signed
  double radius;             // of the circle; 0 where there is none
  Vec3 center;               // of the circle

  Axis3(const Site &a, const Site &b);
  Vec3 perpendicular(const Vec3 &v) const { return v - direction * dot(direction, v); }
};

/// From the axis of an edge towards the ball of one of its turns; unit.
inline Vec3 turn_direction(const DualShape &shape, const DualShape::Edge &edge, const Axis3 &axis,
                           uint32_t turn) {
  return unit(
      axis.perpendicular(shape.position(shape.ball_of(edge, turn)) - shape.position(edge.a)));
}

/// Angle between a tetrahedron's facets at an edge, 0 to pi: never negative, as tetrahedra of the
/// diagram have a volume. `from` and `to` are the facets' directions from the edge,
/// counter-clockwise.
double facet_angle(const Axis3 &axis, const Vec3 &from, const Vec3 &to);

/// The angle from turn number `turn` of an edge to its next turn, through tetrahedra outside the
/// shape; 2 pi if it is the only one.
double outside_angle(const DualShape &shape, const DualShape::Edge &edge, const Axis3 &axis,
                     uint32_t turn);

/// The turn after number `turn` of its edge.
inline uint32_t next_turn(const DualShape::Edge &edge, uint32_t turn) {
  return turn + 1 == edge.end ? edge.begin : turn + 1;
}

} // namespace vbm::impl
