// SPDX-License-Identifier: GPL-3.0-or-later
// Where a mesh is thin, and how near to each other its samples should be for that.
#pragma once

#include "core/samples.h"
#include "sampling/buried.h"
#include "sampling/spacing_field.h"
#include "sampling/triangle_mesh.h"
#include "sampling/triangle_tree.h"

namespace vbm::impl {

/// Points spread over a mesh's faces, and what is known of the walls at them.
struct ThinWalls {
  struct Probe {
    Vec3 at;
    double area; // of the surface it stands for
  };
  std::vector<Probe> probe;
  double area = 0, thin_area = 0;     // unit frame; of all faces, and at walls found
  double thinnest = 0;                // unit frame length
  std::vector<SpacingSite> site;      // at walls
  std::vector<SpacingSite> edge_site; // at their sharp edges
};

/// Look for walls (faces that run along each other, the shape between them) that a spacing of
/// `most` would not resolve. Faces that meet at a tip near by are none: no sampling resolves a tip.
/// Takes time for some thousand queries, whatever the mesh's size. `buried` may be null. Unit
/// frame.
ThinWalls find_thin_walls(const TriangleMesh &mesh, const std::vector<Vec3> &position,
                          const std::vector<Vec3> &face_normal, const TriangleTree &tree,
                          const BuriedTest *buried, double most, Progress &progress);

} // namespace vbm::impl
