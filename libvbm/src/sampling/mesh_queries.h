// SPDX-License-Identifier: GPL-3.0-or-later
// What later stages may ask a mesh.
#pragma once

#include "core/samples.h"
#include "sampling/buried.h"
#include "sampling/triangle_tree.h"

namespace vbm::impl {

/// A tree of all triangles and the parts' caps. Solids, which points are inside of, are closed
/// parts and those closed by small caps. `position` holds at least the triangles' vertices.
std::shared_ptr<const TriangleTree> mesh_tree(std::vector<Triangle> triangles,
                                              std::vector<Vec3> position, const Parts &parts,
                                              Progress &progress);

/// Set samples.refiner, over all triangles, and samples.inside where `parts` says that the mesh's
/// solids can be told from the outside; inside is where they wind round at least once (the union).
/// `buried` knows where no samples are wanted; null: nowhere.
void set_mesh_queries(std::shared_ptr<const TriangleTree> tree, const Parts &parts,
                      std::shared_ptr<const BuriedTest> buried, Samples &samples);

} // namespace vbm::impl
