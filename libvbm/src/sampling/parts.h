// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a mesh (pieces joined by edges), and which of them bound a solid.
#pragma once

#include "core/samples.h"
#include "sampling/holes.h"
#include "sampling/triangle_mesh.h"

namespace vbm::impl {

struct Part {
  Vec3 low, high;                // bounding box
  double area = 0, cap_area = 0; // of its faces, and of the caps on its holes
  double volume = 0;             // signed; of faces and caps
  bool closed = true;            // without caps
  bool solid = true;             // closed, or by small caps
};

struct Parts {
  std::vector<Part> part;
  std::vector<int32_t> part_of; // per triangle
  std::vector<Triangle> caps;   // over `position`
  std::vector<int32_t> cap_part;
  std::vector<Vec3> position; // the samples' and the middles of the caps
  bool usable = false;        // solids are what counts: open parts are a small share
  bool overlap = false; // boxes of two parts overlap: there may be windings other than 0 and 1
};

/// Find the parts of a mesh whose faces agree, and measure them.
Parts find_parts(const TriangleMesh &mesh, const std::vector<Vec3> &position, const Holes &holes,
                 Progress &progress);

/// Turn what is inside out: everything if the solids' volumes add up to less than 0
/// (samples.flipped), then each solid of negative volume that lies in no other part, with what lies
/// in it. Adds notes.
void turn_upright(TriangleMesh &mesh, Parts &parts, Samples &samples);

} // namespace vbm::impl
