// SPDX-License-Identifier: GPL-3.0-or-later
// The steps from a ball model to a pruned medial axis, which several filters share.
#pragma once

#include "layer.h"
#include "params.h"
#include "progress.h"

#include <vbm/vbm.hpp>

#include <string>
#include <vector>

namespace vbm_filters {

// The library's parameters of the axis.
std::vector<Param> axis_params();

// The thesis's scheme (7.7): small parts by their triangles first, then less significant ones by
// another measure.
std::vector<Param> pruning_params();

vbm::Axis build_axis(vbm::Context &context, const vbm::Model &model, const Values &values);

// Removes parts as the values of pruning_params() say; the work from `from` to `to` percent. Says
// what went in `log`.
vbm::Axis prune(vbm::Context &context, vbm::Axis axis, const Values &values, Progress &progress,
                int from, int to, std::vector<std::string> &log);

} // namespace vbm_filters
