// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "layer.h"

namespace vbm_filters {

// The colour of a part, by its number: neighbouring numbers have colours far apart.
Color part_color(std::int32_t part);

} // namespace vbm_filters
