// SPDX-License-Identifier: GPL-3.0-or-later
// The step that all filters begin with: from a layer to a ball model.
#pragma once

#include "layer.h"
#include "params.h"

#include <vbm/vbm.hpp>

namespace vbm_filters {

// The parameters of this step: the host's own two, then the library's but for those in `without`.
// Its limits, which errors name and hardly anybody else needs, come last.
std::vector<Param> model_params(const std::vector<std::string> &without);

// For filters that add a layer: whether to hide the one it was made from.
Param hide_param();

vbm::Model build_model(vbm::Context &context, const Layer &layer, const Values &values);

// What was done, and what the library has to say about it, a sentence each.
void describe(const vbm::Model &model, const Layer &layer, std::vector<std::string> &log);

} // namespace vbm_filters
