// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for every ball model, however bad the input was.
#pragma once

#include "problems.h"

#include <vbm/vbm.h>

/// Sizes and ranges of every view, balls that touch their samples, neighbours that are symmetric,
/// index maps that are each other's inverse, medial radii that are those of the largest balls, a
/// report that agrees with all of it. `brute_force` also looks for samples inside balls, taking
/// samples times balls steps.
Problems check_model(const vbm_model *model, bool brute_force);
