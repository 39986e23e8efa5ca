// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the faces of a mesh agree on front and back, and making them.
#pragma once

#include "sampling/triangle_mesh.h"

namespace vbm::impl {

struct Orientation {
  std::size_t inconsistent_edges =
      0;                        // as given: two sides of one direction, or three and more sides
  std::size_t turned_edges = 0; // of these: had two sides of one direction, and no longer have
  bool orientable = true;       // faces can agree across all edges of two sides
};

/// Turn faces so that across every edge of two sides both agree on the front, if that is possible,
/// else leave all as they are. A piece that agrees already is left alone; in others the direction
/// of the most area wins, or for closed pieces without a clear majority the one of positive volume.
/// With `turn` false only look.
Orientation make_consistent(TriangleMesh &mesh, const std::vector<Vec3> &position, bool turn,
                            Progress &progress);

} // namespace vbm::impl
