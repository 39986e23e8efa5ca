// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a union of balls as a map: patches of spheres, arcs between two, singular points
// between three. What there is and how it hangs together; where arcs run is left to
// patch_complex.h, for those that are not merged away.
#pragma once

#include "core/large_list.h"
#include "dual/dual_shape.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// Share of the radius: what is narrow is no wider than that, nor than the bulge.
inline constexpr double kMostNarrow = 0.15;

/// A closed surface whatever the balls are: every arc has two sides, every singular point three
/// arcs.
struct BoundaryMap {
  /// An arc, or a whole circle that two spheres have in common.
  struct Span {
    uint32_t edge;
    uint32_t turn;       // of the edge, after which it begins; edge.end for whole circles
    double begin, angle; // from the direction of the turn's ball, or from its first end
    bool by_end;         // which of these
  };
  /// Sides of an arc are numbered 2 * span, of ball a's patch and against the arc, and
  /// 2 * span + 1, of ball b's and along it; the patch is on their left, seen from outside.
  struct Patch {
    int32_t ball;
    int32_t loops; // of sides round it: 1 for a disk, 0 for a whole sphere
    bool wraps;    // it is more than half of the sphere, whatever its loop looks like
  };

  std::vector<Vec3> position; // of singular points, unit frame
  std::vector<double> blur;   // how far the balls' changed radii may have moved them
  std::vector<int32_t> code;  // of singular points: 2 * triangle + side
  LargeList<Span> spans;
  std::vector<int32_t> from;     // by side: the singular point it begins at, -1 of whole circles
  std::vector<int32_t> next;     // by side: the one after it, round the patch
  std::vector<int32_t> patch_of; // by side
  std::vector<Patch> patches;
  std::vector<double> bare; // of every ball: the solid angle of its patches
  double finer = 0;         // wide balls are finer than `bulge`: see find_fineness()
  static constexpr double kMostFiner = 4;
  std::size_t offset_points = 0; // where three balls do not meet (8.3.5)

  /// Whether a ball is bare by so much that a polygon, or a few, would not be like it.
  bool wide(int32_t ball) const { return bare[ball] > kWide; }
  static constexpr double kWide = 0.5; // steradians

  int32_t ball_of(const DualShape &shape, int32_t side) const {
    const DualShape::Edge &edge = shape.edges[spans[side / 2].edge];
    return side & 1 ? edge.b : edge.a;
  }
};

/// The map of a dual shape. `balls` are those whose spheres points lie on: the shape's own, or
/// smaller ones (`bridged`).
BoundaryMap boundary_map(const DualShape &shape, const std::vector<Ball> &balls, bool bridged,
                         Progress &progress);

/// Puts in what boundary_map() takes from here: sides in loops, loops of patches.
void find_patches(BoundaryMap &map, const DualShape &shape, Progress &progress);

/// The bulge of wide balls, `finer` being the map's.
inline double fine_bulge(double bulge, double finer) {
  return bulge / (1 + finer * std::min(1.0, bulge / kMostNarrow));
}

} // namespace vbm::impl
