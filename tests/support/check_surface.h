// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for every surface, found without the library's help.
#pragma once

#include "problems.h"

#include <vbm/vbm.h>

#include <cstdint>

struct Topology {
  std::size_t vertices = 0, triangles = 0, components = 0;
  int64_t euler = 0, genus = 0;
  /// Enclosed volume and area, as shares of the bounding box's diagonal to the third and second.
  double volume = 0, area = 0;
  double diagonal = 0;
  /// How far the surface leaves the samples' bounding box, in diagonals of it.
  double reach = 0;
};

/// Finite, closed, every edge in two triangles that agree on its direction, every vertex a disk and
/// in use, positive volume; triangles that are the polygons cut up, polygons that are closed
/// likewise; tables of the right size that point at what they should; a report that agrees.
/// `model` is the surface's. The topology counted is stored in *found if that is not NULL. A power
/// crust of samples that are mostly reported as too thin may have any volume and extent.
Problems check_surface(const vbm_surface *surface, const vbm_model *model,
                       Topology *found = nullptr);
