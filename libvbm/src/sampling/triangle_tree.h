// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles sorted in space, for winding numbers and nearest points.
#pragma once

#include "sampling/triangle_mesh.h"

#include <cstddef>

namespace vbm::impl {

/// A bounding volume hierarchy. Queries are const, use no state, and may run on many threads at
/// once.
class TriangleTree {
public:
  TriangleTree() = default;
  /// What a triangle counts for.
  enum Use : uint8_t { winding = 1, surface = 2 };

  /// Of the triangles over `position` (unit frame); both are kept, in an order of the tree's own.
  /// `use` holds what each triangle counts for, or is empty: both.
  TriangleTree(std::vector<Vec3> position, const std::vector<Triangle> &triangles,
               const std::vector<uint8_t> &use, Progress &progress);

  /// How often the triangles that count for it, which must close, wind round p; false if p is on a
  /// triangle (or no ray from p is clear of all edges).
  bool winding_number(const Vec3 &p, int &number) const;

  struct Nearest {
    double distance; // in: only nearer points count; out: the distance
    Vec3 point;
    int32_t triangle = -1;
  };
  /// The point of the triangles nearest to p; false if none is nearer than found.distance.
  bool nearest(const Vec3 &p, Nearest &found) const;

  /// The pseudo-normal of the surface at a point on it: the faces there, weighted by their angles.
  Vec3 normal_at(const Vec3 &point) const;

private:
  struct Box {
    float low[3], high[3];
  };
  static constexpr std::size_t kLeaf = 4; // triangles per leaf

  Box box_of_leaf(std::size_t leaf) const;
  bool counts(std::size_t triangle, Use use) const {
    return use_.empty() || (use_[triangle] & use);
  }
  double distance2(const Box &box, const Vec3 &p) const;
  template <class Accept, class Leaf> void descend(Accept accept, Leaf leaf) const;

  std::vector<Vec3> position_;
  std::vector<Triangle> triangle_;
  std::vector<uint8_t> use_;
  std::vector<Box> box_;                 // level by level, leaves first
  std::vector<std::size_t> level_begin_; // of every level in box_, and the end
};

} // namespace vbm::impl
