// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a union of balls as a complex: patches of spheres, and the pieces of the arcs
// round them.
#pragma once

#include "ball_surface/boundary_map.h"
#include "ball_surface/merged_points.h"
#include "core/large_list.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

struct PatchOptions {
  double bulge = 0.15;  // see vbm_ball_surface_options
  double narrow = 0.37; // see vbm_ball_surface_options
  bool bridged = false; // the dual shape is that of larger balls than `balls`
};

/// A closed surface whatever the balls are: every arc has two sides. Long arcs and whole circles
/// are cut into pieces.
struct PatchComplex {
  /// One side of a piece of an arc; the patch is on its left, seen from outside.
  struct Dart {
    int32_t from; // vertex
    int32_t next, previous, twin;
    int32_t patch;
    int32_t arc : 31;
    uint32_t forward : 1; // the way the arc runs
  };
  /// What two spheres have in common: center + u cos + (axis x u) sin of an angle,
  /// counter-clockwise about the edge a to b.
  struct Circle {
    uint32_t edge;
    Vec3 center, u, axis;
  };
  /// A piece of it: from angle `from` to `to`, and where it ends, by place: singular points of the
  /// map come first, then those in `position`.
  struct Arc {
    int32_t circle;
    int32_t begin, end;
    double from, to;
  };
  struct Patch {
    int32_t ball;
    int32_t loops; // of darts round it: 1 for a disk, 0 for a whole sphere
    int32_t darts; // in all its loops
    bool wraps;    // see BoundaryMap
  };

  std::vector<Vec3> position; // of vertices, unit frame; until it is finished, within arcs only
  LargeList<Dart> darts;
  LargeList<Circle> circles;
  LargeList<Arc> arcs;
  std::vector<Patch> patches;
  std::vector<double> bare; // see BoundaryMap
  double finer = 0;

  bool wide(int32_t ball) const { return bare[ball] > BoundaryMap::kWide; }
  int32_t to(const Dart &d) const { return darts[d.twin].from; }
  const Circle &circle(const Dart &d) const { return circles[arcs[d.arc].circle]; }
  static Vec3 point(const Circle &c, double angle) {
    return c.center + c.u * std::cos(angle) + cross(c.axis, c.u) * std::sin(angle);
  }
};

/// How far from their ball faces may be, in radii.
inline double bulge_of(const PatchComplex &complex, const PatchOptions &options, int32_t ball) {
  return complex.wide(ball) ? fine_bulge(options.bulge, complex.finer) : options.bulge;
}

/// The complex of a map without the arcs that were contracted, which are given by span; no loop of
/// its may be all gone. Vertices are `points`, and those within arcs, which are added
/// there.
PatchComplex patch_complex(const BoundaryMap &map, const DualShape &shape,
                           const std::vector<uint8_t> &contracted, const PatchOptions &options,
                           MergedPoints &points, Progress &progress);

} // namespace vbm::impl
