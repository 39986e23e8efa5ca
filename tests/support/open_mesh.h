// SPDX-License-Identifier: GPL-3.0-or-later
// A second opinion on surfaces, by OpenMesh.
#pragma once

#include "problems.h"

#include <vbm/vbm.h>

/// OpenMesh takes every triangle and every polygon as a face, finds no boundary, and no vertex that
/// is not manifold, and counts the Euler characteristic that the report says.
void open_mesh_check(const vbm_surface *surface, Problems &problems);
