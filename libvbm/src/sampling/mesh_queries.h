// SPDX-License-Identifier: GPL-3.0-or-later
// What later stages may ask a mesh.
#pragma once

#include "core/samples.h"
#include "sampling/buried.h"

namespace vbm::impl {

/// Set samples.refiner, over all triangles, and samples.inside where `parts` says that the mesh's
/// solids can be told from the outside. Solids are closed parts and those closed by small caps;
/// inside is where they wind round at least once (the union). `position` holds at least the
/// triangles' vertices. `buried` knows where no samples are wanted; null: nowhere.
void set_mesh_queries(std::vector<Triangle> triangles, std::vector<Vec3> position,
                      const Parts &parts, std::shared_ptr<const BuriedTest> buried,
                      Samples &samples, Progress &progress);

} // namespace vbm::impl
