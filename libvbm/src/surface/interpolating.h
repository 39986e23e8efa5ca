// SPDX-License-Identifier: GPL-3.0-or-later
// The interpolating surface: the boundary of the inside Delaunay tetrahedra.
#pragma once

#include "core/model.h"
#include "core/progress.h"

namespace vbm::impl {

/// Closed, oriented outward and manifold by construction; vertices are samples. Throws
/// Error(VBM_ERROR_NO_INTERIOR) if no tetrahedron is inside.
Surface interpolating_surface(const Model &model, Progress &progress);

} // namespace vbm::impl
