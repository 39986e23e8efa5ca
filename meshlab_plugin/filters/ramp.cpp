// SPDX-License-Identifier: GPL-3.0-or-later
#include "ramp.h"

#include <algorithm>
#include <cmath>

namespace vbm_filters {

Spread spread(const std::vector<double> &values) {
  std::vector<double> finite;
  finite.reserve(values.size());
  for (double value : values)
    if (std::isfinite(value)) finite.push_back(value);
  Spread result;
  result.finite = finite.size();
  if (finite.empty()) return result;

  const auto rank = [&](double part) {
    const auto nth = finite.begin() + static_cast<std::ptrdiff_t>(part * (finite.size() - 1));
    std::nth_element(finite.begin(), nth, finite.end());
    return *nth;
  };
  const auto [low, high] = std::minmax_element(finite.begin(), finite.end());
  result.minimum = *low;
  result.maximum = *high;
  result.ramp = {true, rank(0.01), rank(0.99)};
  return result;
}

} // namespace vbm_filters
