// SPDX-License-Identifier: GPL-3.0-or-later
// Points spread evenly over the planes of a mesh.
#pragma once

#include "sampling/spacing_field.h"
#include "sampling/triangle_mesh.h"

#include <functional>

namespace vbm::impl {

/// The planar patches of a mesh for a spacing: neighbouring triangles of one plane, joined across
/// edges that are too long for it, so that a plane cut into needles gets no more samples than one
/// that is not. Only triangles with such a long edge are in a patch; the others have samples
/// enough. Where the spacing varies, so does the lattice: `top`, halved as often as the spacing
/// asks.
class Lattice {
public:
  /// `parts` says into how many parts an edge is cut: more than one where it is too long.
  Lattice(const TriangleMesh &mesh, const std::vector<Vec3> &position,
          const std::vector<Vec3> &face_normal, const std::vector<double> &edge_length,
          const std::vector<double> &parts, const SpacingField &field, double top,
          Progress &progress);

  /// Whether an edge lies within a patch, so that no samples are needed on it.
  bool within_patch(std::size_t edge) const { return !joined_.empty() && joined_[edge]; }

  /// Samples on all edges that are not within a patch.
  double samples_on_edges() const;

  /// About how many points visit() will give at a constant spacing, from the area; never far too
  /// few.
  double estimate() const { return estimate_; }

  /// Called with a lattice point and the spacing of the lattice there.
  using Visit = std::function<void(int32_t triangle, const Vec3 &point, double spacing)>;
  /// Call visit for every lattice point on the triangles, in a fixed order.
  void visit(const Visit &visit) const;

  /// The spacing of a lattice of levels from `top` down that is at most `spacing`.
  static double level_spacing(double top, double spacing);

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
  bool is_long(int32_t edge) const { return parts_[edge] > 1; }
  void visit_points(const Member &member, int level, const Visit &visit) const;
  bool may_have(const Member &member, int level) const;
  double spacing_at(const Vec3 &p) const;
  std::array<Corner, 3> flatten(const Member &member) const;
  bool in_margin(int32_t triangle, const std::array<Corner, 3> &corner, double u, double v,
                 double spacing) const;
  Vec3 place(const Member &member, const std::array<Corner, 3> &corner, int64_t row, int64_t column,
             double u, double v, double spacing) const;

  const TriangleMesh &mesh_;
  const std::vector<Vec3> &position_;
  const std::vector<Vec3> &face_normal_;
  const SpacingField &field_;
  double top_, estimate_ = 0;
  int levels_ = 1;
  const std::vector<double> &length_, &parts_;
  std::vector<uint8_t> joined_;
  std::vector<int32_t> patch_of_; // per triangle, -1: none
  std::vector<Patch> patches_;
  std::vector<Member> members_;
};

} // namespace vbm::impl
