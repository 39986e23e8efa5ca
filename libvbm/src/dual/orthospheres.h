// SPDX-License-Identifier: GPL-3.0-or-later
// The signs a dual shape is made of, and the points where balls are equally far in power distance.
//
// Edelsbrunner, Muecke, "Three-dimensional alpha shapes" (1994), at alpha 0 with weights: a simplex
// of balls is in the shape if the smallest sphere orthogonal to them has no positive square of its
// radius, so that the balls have a point in common, and no other ball is nearer to its centre. As
// in power_predicates.h, doubles decide with a bound on their error, and pairs of doubles where
// they cannot; and the lifted coordinate is written with radii. What even those cannot tell from
// zero counts as meeting: the balls' changed radii (kPowerChange) make that as good as impossible.
#pragma once

#include "core/vec3.h"
#include "surface/power_predicates.h"

namespace vbm::impl {

/// Whether the balls have a point in common where they are equally far: on the segment, in the
/// triangle's plane, at the power centre.
bool edge_meets(const Site &a, const Site &b);
bool triangle_meets(const Site &a, const Site &b, const Site &c);
bool tetrahedron_meets(const Site &a, const Site &b, const Site &c, const Site &d);

/// Whether ball p is nearer to that point than they are.
bool hides_vertex(const Site &a, const Site &p);
bool hides_edge(const Site &a, const Site &b, const Site &p);
bool hides_triangle(const Site &a, const Site &b, const Site &c, const Site &p);

/// Whether a triangle's balls meet and neither p nor q, null for none, hides it.
bool triangle_alone_meets(const Site &a, const Site &b, const Site &c, const Site *p,
                          const Site *q);

/// Those points, relative to ball a's centre. Pairs of doubles are used where doubles may err by
/// more than kOrthocenterError; of flat simplices no digit may be left.
Vec3 edge_center(const Site &a, const Site &b);
Vec3 triangle_center(const Site &a, const Site &b, const Site &c);
Vec3 tetrahedron_center(const Site &a, const Site &b, const Site &c, const Site &d);

inline Vec3 center_of(const Site &s) { return {s.x, s.y, s.z}; }

} // namespace vbm::impl
