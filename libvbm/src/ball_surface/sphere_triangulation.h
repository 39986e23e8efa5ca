// SPDX-License-Identifier: GPL-3.0-or-later
// Constrained Delaunay triangles of points on the sphere.
#pragma once

#include "core/vec3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// Triangles between directions from one point, which cover all of them once: seen from there none
/// lies over another, whatever the points' distances. Starts with an octahedron.
class SphereTriangulation {
public:
  struct Triangle {
    std::array<int32_t, 3> vertex;   // counter-clockwise seen from outside
    std::array<int32_t, 3> neighbor; // across the side opposite each vertex
    std::array<uint8_t, 3> fixed;    // whether that side is a constraint
    int32_t mark;                    // the caller's own, 0 at first
  };

  /// Its corners: six unit vectors, each pair of opposite ones in a row; vertices 0 to 5.
  SphereTriangulation(const std::array<Vec3, 6> &octahedron, Progress &progress);

  /// The vertex in a direction (a unit vector, not the opposite of a vertex it would be joined to):
  /// a new one unless there is one. Not after constrain().
  int32_t insert(const Vec3 &direction);
  /// Makes an edge of two vertices less than half a turn apart; false, and nothing that matters
  /// done, where it would run through a vertex or another constraint.
  bool constrain(int32_t a, int32_t b);
  /// Delaunay again, apart from the constraints.
  void improve();

  /// The triangle with an edge from a to b on its left and the side it is, -1 if there is none.
  int32_t find(int32_t a, int32_t b, int &side) const;
  std::vector<Triangle> &triangles() { return t_; }
  const Vec3 &at(int32_t vertex) const { return p_[vertex]; }
  std::size_t vertices() const { return p_.size(); }
  static int index(const Triangle &t, int32_t vertex) {
    return (t.vertex[1] == vertex) + 2 * (t.vertex[2] == vertex);
  }
  /// The side of t's neighbour across its side k that leads back.
  int mirror(int32_t t, int k) const;

private:
  int turn(int32_t a, int32_t b, int32_t c) const { return turn(p_[a], p_[b], p_[c]); }
  static int turn(const Vec3 &a, const Vec3 &b, const Vec3 &c);
  bool is_above(int32_t a, int32_t b, int32_t c, int32_t d) const;
  int32_t locate(const Vec3 &p) const;
  void split_triangle(int32_t t, int32_t v);
  void split_edge(int32_t t, int k, int32_t v);
  void set(int32_t t, const std::array<int32_t, 3> &v, const std::array<int32_t, 3> &n,
           const std::array<uint8_t, 3> &fixed);
  void relink(int32_t t, int k);
  bool is_convex(int32_t t, int k) const;
  void flip(int32_t t, int k);
  void legalize(std::vector<int32_t> &work);

  Progress &progress_;
  std::vector<Vec3> p_;
  std::vector<Triangle> t_;
  std::vector<int32_t> of_; // per vertex, one of its triangles
};

} // namespace vbm::impl
