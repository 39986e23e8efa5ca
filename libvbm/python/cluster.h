// SPDX-License-Identifier: GPL-3.0-or-later
// Clustering, of a model's balls or of any.
#pragma once

#include "signature.h"

#include <vbm/vbm.hpp>

namespace vbm::python {

/// Add Clusters and cluster() to the module.
void bind_cluster(py::module_ &module);

/// Model.cluster(): its parameters, its help, and what it does.
const Signature &model_cluster_signature();
std::string model_cluster_doc();
Clusters cluster_model(const Model &model, const Arguments &given);

} // namespace vbm::python
