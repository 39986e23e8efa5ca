// SPDX-License-Identifier: GPL-3.0-or-later
// Between the filters' parameters and MeshLab's, from which it makes its dialogs.
#pragma once

#include "../filters/params.h"
#include "meshlab.h"

namespace vbm_meshlab {

// `model` may be null: there may be no layer yet.
RichParameterList dialog(const std::vector<vbm_filters::Param> &params, const MeshModel *model);

vbm_filters::Values values(const std::vector<vbm_filters::Param> &params,
                           const RichParameterList &given);

} // namespace vbm_meshlab
