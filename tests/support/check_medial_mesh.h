// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for everything that is made from a medial axis, however bad the input was.
#pragma once

#include "problems.h"

#include <vbm/vbm.h>

#include <string>

/// The axis of a few balls, the curve skeleton, and the axis by the other construction: sizes and
/// ranges, numbers that are finite, no simplex twice, and the solid's Euler number and pieces. All
/// bytes shown are appended to *bytes.
Problems exercise_derived(vbm_context *context, const vbm_model *model, const vbm_axis *axis,
                          int64_t euler, uint64_t components, std::string *bytes);
