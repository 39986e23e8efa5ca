// SPDX-License-Identifier: GPL-3.0-or-later
// Hues a golden section of the circle apart: whatever number of them is used, no two are near.
#include "part_colors.h"

#include <algorithm>
#include <cmath>

namespace vbm_filters {

Color part_color(std::int32_t part) {
  const double turn = std::fmod(0.08 + part * 0.6180339887498949, 1.0) * 6;
  // Two neighbouring hues are told apart by how light and how strong they are as well.
  const double light = part % 3 == 1 ? 0.75 : 0.95, strong = part % 2 ? 0.85 : 0.6;
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + turn, 6);
    const double value = light - light * strong * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
    return static_cast<std::uint8_t>(std::lround(255 * value));
  };
  return {channel(5), channel(3), channel(1), 255};
}

} // namespace vbm_filters
