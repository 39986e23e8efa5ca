// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for every medial axis, pruned or not, however bad the input was.
#pragma once

#include "problems.h"

#include <vbm/vbm.h>

#include <string>

/// Sizes and ranges of every view, no simplex twice, all edges' ends and triangles' corners there,
/// numbers that are finite, a report that agrees with what is counted anew, parts that add up to
/// the whole. `euler` and `components` are the solid's, which the axis must have.
Problems check_axis(const vbm_axis *axis, const vbm_model *model, int64_t euler,
                    uint64_t components);

/// An axis of the model, pruned by each measure and by naming a part, and the surface of what is
/// left. All bytes it shows are appended to *bytes, all that is wrong is returned.
Problems exercise_axis(vbm_context *context, const vbm_model *model, std::string *bytes);
