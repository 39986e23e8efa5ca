// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs cut into pieces that are short enough for their chords to stand for them.
#pragma once

#include "ball_surface/complex_editor.h"

#include <vector>

namespace vbm::impl {

class Progress;

/// Arcs at wide balls: so that they are as flat as these balls' patches are to be.
void refine_arcs(ComplexEditor &editor, const PatchOptions &options, Progress &progress);

/// And where chords of a ball cross, seen from its centre: these are cut until none do, or
/// that cannot be had, because points of theirs have been moved.
void uncross_chords(ComplexEditor &editor, Progress &progress);

} // namespace vbm::impl
