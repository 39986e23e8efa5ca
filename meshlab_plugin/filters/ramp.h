// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "layer.h"

#include <vector>

namespace vbm_filters {

struct Spread {
  double minimum = 0, maximum = 0; // of the finite values; 0 if there are none
  std::size_t finite = 0;
  Ramp ramp; // from the 1st to the 99th percentile, so that a few outliers do not flatten the
             // colours
};

Spread spread(const std::vector<double> &values);

} // namespace vbm_filters
