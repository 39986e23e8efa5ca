// SPDX-License-Identifier: GPL-3.0-or-later
// What MedialAxis.prune() is asked for.
#pragma once

#include "signature.h"

#include <vbm/vbm.hpp>

#include <vector>

namespace vbm::python {

/// prune() and its arguments.
Signature pruning_signature();

/// Its help.
extern const char *const kPruneDoc;

/// The steps a call asks for, in the order in which they are done. Throws TypeError for what is no
/// number, and ArgumentError for none, or for both steps and thresholds.
std::vector<PruneOptions> pruning_steps(const Arguments &given);

} // namespace vbm::python
