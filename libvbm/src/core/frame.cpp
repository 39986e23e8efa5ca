// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame.h"

#include <algorithm>
#include <limits>

namespace vbm::impl {

Frame frame_of(const double *points, std::size_t count) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Vec3 low{inf, inf, inf}, high{-inf, -inf, -inf};
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 p{points[3 * i], points[3 * i + 1], points[3 * i + 2]};
    if (!is_finite(p)) continue;
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  Frame frame;
  if (!(low.x <= high.x)) return frame;
  // Halves first: high - low may overflow where high / 2 - low / 2 does not. Denormal halves lose
  // a bit, which only moves the exponent by one.
  double side = 0, magnitude = 0;
  for (int a = 0; a < 3; ++a) {
    side = std::max(side, high[a] / 2 - low[a] / 2);
    magnitude = std::max({magnitude, std::fabs(low[a]), std::fabs(high[a])});
  }
  int largest = 0;
  if (magnitude > 0) std::frexp(magnitude, &largest);
  if (side > 0) {
    std::frexp(side, &frame.exponent);
    ++frame.exponent;
    // Farther away than this for its size, a box has only one value left along some axis: the points
    // are flat, whatever the scale, and scaling up further would overflow.
    frame.exponent = std::max(frame.exponent, largest - 1000);
  } else {
    frame.exponent = largest;
  }
  const Frame scale{frame.exponent, {}};
  const Vec3 l = scale.to_unit(low), h = scale.to_unit(high);
  frame.center = l * 0.5 + h * 0.5;
  return frame;
}

} // namespace vbm::impl
