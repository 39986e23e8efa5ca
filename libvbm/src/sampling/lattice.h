// SPDX-License-Identifier: GPL-3.0-or-later
// Points spread evenly over the planes of a mesh.
#pragma once

#include "sampling/triangle_mesh.h"

#include <functional>

namespace vbm::impl {

/// The planar patches of a mesh for one spacing: neighbouring triangles of one plane, joined across
/// edges longer than the spacing, so that a plane cut into needles gets no more samples than one
/// that is not. Only triangles with such a long edge are in a patch; the others have samples
/// enough.
class Lattice {
public:
  Lattice(const TriangleMesh &mesh, const std::vector<Vec3> &position,
          const std::vector<Vec3> &face_normal, const std::vector<double> &edge_length,
          double spacing, Progress &progress);

  /// Whether an edge lies within a patch, so that no samples are needed on it.
  bool within_patch(std::size_t edge) const { return !joined_.empty() && joined_[edge]; }

  /// About how many points visit() will give, from the area; never far too few.
  double estimate() const { return estimate_; }

  /// Call visit(triangle, point) for every lattice point on the triangles, in a fixed order.
  void visit(const std::function<void(int32_t triangle, const Vec3 &point)> &visit) const;

private:
  struct Patch {
    Vec3 origin, u, v, normal;
  };
  struct Member {
    int32_t triangle, patch;
  };
  struct Corner {
    int32_t name;
    double u, v;
  };

  void grow(int32_t seed, Progress &progress);
  Patch plane_of(int32_t triangle) const;
  bool is_flat(int32_t edge) const;
  bool is_long(int32_t edge) const { return length_[edge] > spacing_; }
  void visit_points(const Member &member,
                    const std::function<void(int32_t, const Vec3 &)> &visit) const;
  std::array<Corner, 3> flatten(const Member &member) const;
  bool in_margin(int32_t triangle, const std::array<Corner, 3> &corner, double u, double v) const;
  Vec3 place(const Member &member, const std::array<Corner, 3> &corner, int64_t row, int64_t column,
             double u, double v) const;

  const TriangleMesh &mesh_;
  const std::vector<Vec3> &position_;
  const std::vector<Vec3> &face_normal_;
  double spacing_, estimate_ = 0;
  const std::vector<double> &length_;
  std::vector<uint8_t> joined_;
  std::vector<int32_t> patch_of_; // per triangle, -1: none
  std::vector<Patch> patches_;
  std::vector<Member> members_;
};

} // namespace vbm::impl
