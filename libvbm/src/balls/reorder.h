// SPDX-License-Identifier: GPL-3.0-or-later
// Samples in an order that is kind to memory while a model is built, and back.
#pragma once

#include "core/model.h"
#include "core/progress.h"

#include <cstdint>
#include <vector>

namespace vbm::impl {

/// Put samples into the given order: new sample i is old sample order[i]. input_sample follows.
void reorder(Samples &samples, const std::vector<int32_t> &order, Progress &progress);

/// Renumber the samples of a finished model: sample i becomes sample order[i], which undoes
/// reorder(). Lists of samples stay ascending. Samples from order.size() on keep their numbers.
void restore_order(Model &model, const std::vector<int32_t> &order, Progress &progress);

} // namespace vbm::impl
