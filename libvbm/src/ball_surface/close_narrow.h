// SPDX-License-Identifier: GPL-3.0-or-later
// Patches, or parts of them, that are too narrow to be seen as faces, closed.
#pragma once

#include "ball_surface/complex_editor.h"

#include <vector>

namespace vbm::impl {

class Progress;

/// Contracts arcs that are shorter than `reach` of their patches' balls (unit lengths), and closes
/// patches where they are narrower, so that their neighbours' faces meet in one line. Nothing moves
/// farther than twice that. Corners that are left with two arcs go where the arc that takes their
/// place stays within `bulge` radii of them.
void close_narrow(ComplexEditor &editor, const std::vector<double> &reach, double bulge,
                  Progress &progress);

} // namespace vbm::impl
