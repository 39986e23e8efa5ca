// SPDX-License-Identifier: GPL-3.0-or-later
// The mixed complex of balls, whose cells hold the pieces of their skin surface.
#pragma once

#include "core/model.h"
#include "surface/power_diagram.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// Between the regular triangulation and the power diagram: for each simplex s of the former and
/// its face of the latter, the cell (1 - shrink) s + shrink face(s). In it the skin is a quadric:
/// of a sphere for a ball, of a hyperboloid for an edge and a triangle, of a sphere seen from
/// within for a tetrahedron.
class MixedComplex {
public:
  /// `balls` are in a frame in which they reach no farther than about 1. They are grown so that the
  /// spheres of the skin are theirs.
  MixedComplex(const std::vector<Ball> &balls, double shrink, Progress &progress);

  /// A tetrahedron of balls, positively oriented, with its 15 simplices by the bits of their balls:
  /// simplex[1 << i] is ball i, simplex[15] the tetrahedron.
  struct Cell {
    std::array<int32_t, 16> simplex;
  };
  std::size_t cell_count() const { return diagram_.cells.size(); }
  Cell cell(std::size_t c) const;

  std::size_t simplex_count() const { return focus_.size(); }
  std::size_t hidden() const { return hidden_; }

  /// A corner of a mixed cell's pieces: simplices low <= high, whose points a and b it lies
  /// between.
  struct Corner {
    int32_t low, high;
  };
  /// Less than 0 inside the skin.
  double value(const Corner &corner) const;
  /// Where the skin crosses from a corner inside to one outside, of one piece; the lower simplex of
  /// one is a face of the other's. `normal` receives the outward unit normal.
  Vec3 crossing(const Corner &p, const Corner &q, Vec3 &normal) const;

  /// Moves x, in a cell or near it, onto the skin; `normal` receives the outward unit normal.
  /// False, and x as it was, if that is farther than `reach`.
  bool project(int32_t cell, double reach, Vec3 &x, Vec3 &normal) const;

  double radius(int32_t ball) const { return site_[ball].r * root_; }

private:
  void number_simplices(Progress &progress);
  void find_foci(Progress &progress);
  void find_low_points(Progress &progress);
  void find_high_points(Progress &progress);

  struct Simplex {
    std::array<int32_t, 4> ball; // -1 beyond
  };
  /// Of the balls within the skin whose centres are in a tetrahedron, the one that a point is
  /// deepest in.
  struct Inner {
    Vec3 center;
    double square; // of its radius
    double value;  // square of the distance to its centre, less that
  };
  Inner inner(int32_t cell, const Vec3 &x) const;
  int dimension(int32_t s) const {
    return s < edges_ ? 0 : s < triangles_ ? 1 : s < cells_ ? 2 : 3;
  }
  Vec3 center(int32_t ball) const { return {site_[ball].x, site_[ball].y, site_[ball].z}; }
  double power(int32_t ball, const Vec3 &x) const;
  double form(int32_t ball, const Vec3 &x, const Vec3 &a) const;

  double shrink_, root_; // root_: of it
  std::size_t balls_ = 0, hidden_ = 0;
  std::vector<Site> site_; // grown balls, then the far corners
  PowerDiagram diagram_;

  // Simplices are balls, edges, triangles, tetrahedra, from these numbers on.
  int32_t edges_ = 0, triangles_ = 0, cells_ = 0;
  std::vector<Simplex> simplex_;
  std::vector<std::array<int32_t, 10>> of_cell_; // per cell: 6 edges, 4 triangles

  std::vector<Vec3> focus_; // where the simplex's balls are equally far, in its own plane
  std::vector<Vec3> low_;   // of the simplex, the point nearest to its focus
  std::vector<Vec3> high_;  // of its face of the power diagram, the point nearest to its focus
};

} // namespace vbm::impl
