// SPDX-License-Identifier: GPL-3.0-or-later
// What the outside sees of a model: arrays in input units, the report and the notes.
#pragma once

#include "core/model.h"
#include "core/progress.h"

namespace vbm::impl {

/// Fill the model's arrays in input units, its report and its notes from everything else in it.
void describe(Model &model, Progress &progress);

} // namespace vbm::impl
