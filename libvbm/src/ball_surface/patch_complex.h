// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a union of balls as a complex: patches of spheres, arcs between two, singular
// points between three.
#pragma once

#include "dual/dual_shape.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// Share of the radius: what is narrow is no wider than that, nor than the bulge.
inline constexpr double kMostNarrow = 0.15;

struct PatchOptions {
  double bulge = 0.15;  // see vbm_ball_surface_options
  double narrow = 0.37; // see vbm_ball_surface_options
  bool bridged = false; // the dual shape is that of larger balls than `balls`
};

/// A closed surface whatever the balls are: every arc has two sides, every singular point three
/// arcs. Long arcs and whole circles are cut into pieces.
struct PatchComplex {
  /// One side of a piece of an arc; the patch is on its left, seen from outside.
  struct Dart {
    int32_t from; // vertex
    int32_t next, previous, twin;
    int32_t patch;
    int32_t arc;
    bool forward; // the way the arc runs
  };
  /// What two spheres have in common: center + u cos + v sin of an angle, counter-clockwise about
  /// the edge a to b.
  struct Circle {
    uint32_t edge;
    uint32_t turn; // angle 0 is in the direction of its ball; edge.end for whole circles
    Vec3 center, u, v, axis;
    double height_a, height_b; // of its plane over a's and b's centres, along a to b and b to a
  };
  /// A piece of it: from angle `from` to `to`, and where it ends.
  struct Arc {
    int32_t circle;
    double from, to;
    Vec3 begin, end;
  };
  struct Patch {
    int32_t ball;
    int32_t loops; // of darts round it: 1 for a disk, 0 for a whole sphere
    int32_t darts; // in all its loops
    bool wraps;    // its solid angle is more than kWraps, whatever its loop looks like
  };

  std::vector<Vec3> position; // of vertices, unit frame
  std::vector<double> blur;   // how far the balls' changed radii may have moved it
  std::vector<int32_t> code;  // of singular points: 2 * triangle + side
  std::vector<Dart> darts;
  std::vector<Circle> circles;
  std::vector<Arc> arcs;
  std::vector<Patch> patches;
  std::vector<double> bare; // of every ball: the solid angle of its patches
  double finer = 0;         // wide balls are finer than `bulge`: see find_fineness()
  static constexpr double kMostFiner = 4;
  std::size_t offset_points = 0;   // where three balls do not meet (8.3.5)
  std::size_t singular_points = 0; // vertices 0 .. singular_points - 1; others are within arcs

  /// Whether a ball is bare by so much that a polygon, or a few, would not be like it.
  bool wide(int32_t ball) const { return bare[ball] > kWide; }
  static constexpr double kWide = 0.5; // steradians

  int32_t to(const Dart &d) const { return darts[d.twin].from; }
  const Circle &circle(const Dart &d) const { return circles[arcs[d.arc].circle]; }
  static Vec3 point(const Circle &c, double angle) {
    return c.center + c.u * std::cos(angle) + c.v * std::sin(angle);
  }
};

/// How far from their ball faces may be, in radii.
inline double bulge_of(const PatchComplex &complex, const PatchOptions &options, int32_t ball) {
  if (!complex.wide(ball)) return options.bulge;
  return options.bulge / (1 + complex.finer * std::min(1.0, options.bulge / kMostNarrow));
}

/// The complex of a dual shape. `balls` are those whose spheres vertices lie on: the shape's own,
/// or smaller ones.
PatchComplex patch_complex(const DualShape &shape, const std::vector<Ball> &balls,
                           const PatchOptions &options, Progress &progress);

/// Steradians.
inline constexpr double kWraps = 3.14;

} // namespace vbm::impl
