// SPDX-License-Identifier: GPL-3.0-or-later
// How far apart the samples of a mesh should be where the options leave it open.
#pragma once

#include "core/samples.h"
#include "sampling/buried.h"
#include "sampling/spacing_field.h"
#include "sampling/thin_walls.h"
#include "sampling/triangle_mesh.h"
#include "sampling/triangle_tree.h"

#include <cmath>
#include <functional>

namespace vbm::impl {

/// What the spacing is chosen from. Edges have their lengths in unit frame; `buried` may be null.
struct SpacingInput {
  const TriangleMesh &mesh;
  const std::vector<Vec3> &face_normal;
  const std::vector<double> &edge_length;
  const TriangleTree &tree;
  const BuriedTest *buried;
};

/// A spacing over a mesh, as SpacingField, and the coarsest step of its lattices; 0: nothing to
/// add.
struct Spacing {
  SpacingField field{0};
  double top = 0;
};

class SpacingChoice {
public:
  /// At most kSpacingsAcross and kTypicalSides ask for, unless that needs too many samples.
  SpacingChoice(const SpacingInput &input, const vbm_build_options &options, Samples &samples,
                Progress &progress);

  const Spacing &get() const { return spacing_; }
  /// How many samples the spacing may add, those of thin walls among them; no limit without walls.
  double most() const { return most_; }
  /// Take a larger spacing for thin walls, or, where that would not resolve them, none of their own.
  void coarsen();
  /// Say what the samples are too few for.
  void note(Samples &samples) const;

private:
  void look_for_walls(const SpacingInput &input, const vbm_build_options &options,
                      const Samples &samples, Progress &progress);
  void build();
  double estimate(const SpacingField &field, double top) const;

  Spacing spacing_;
  ThinWalls walls_;
  double base_ = 0, wanted_ = 0, count_ = 0; // spacing without thin walls, and what it adds
  double least_ = 0, floor_ = 0, most_ = HUGE_VAL;
};

/// The parts each edge is cut into: a double, as it may be more than any integer.
std::vector<double> edge_parts(const TriangleMesh &mesh, const std::vector<Vec3> &position,
                               const std::vector<double> &edge_length, const SpacingField &field,
                               Progress &progress);

/// Call visit(share) for the places that cut an edge from a to b into so many parts, each in
/// accordance with the spacing where it is.
void cut_edge(const Vec3 &a, const Vec3 &b, double parts, const SpacingField &field,
              const std::function<void(double share)> &visit);

} // namespace vbm::impl
