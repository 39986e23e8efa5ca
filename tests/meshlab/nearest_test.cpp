// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest of many points, against looking at each.
#include "../../meshlab_plugin/filters/nearest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

std::int32_t slowly(const std::vector<double> &points, const std::vector<std::int32_t> &numbers,
                    const double *place) {
  std::int32_t found = -1;
  double least = 0;
  for (std::int32_t n : numbers) {
    double distance2 = 0;
    for (int k = 0; k < 3; ++k) {
      const double d = points[3 * std::size_t(n) + k] - place[k];
      distance2 += d * d;
    }
    if (found < 0 || distance2 < least || (distance2 == least && n < found)) {
      found = n;
      least = distance2;
    }
  }
  return found;
}

TEST(Nearest, IsWhatLookingAtEachFinds) {
  std::mt19937 random(7);
  for (const int count : {0, 1, 2, 3, 10, 1000}) {
    // On a coarse lattice there are equal points, and equal distances.
    for (const double step : {0.0, 0.25}) {
      std::uniform_real_distribution<double> anywhere(-1, 1);
      const auto number = [&] {
        const double x = anywhere(random);
        return step > 0 ? step * std::round(x / step) : x;
      };
      std::vector<double> points(3 * std::size_t(count));
      for (double &x : points) x = number();
      std::vector<std::int32_t> numbers;
      for (std::int32_t n = 0; n < count; ++n)
        if (n % 5 != 1) numbers.push_back(n);
      const vbm_filters::Nearest nearest(points.data(), numbers);
      for (int trial = 0; trial < 200; ++trial) {
        const double place[3] = {number(), number(), number()};
        ASSERT_EQ(nearest.find(place), slowly(points, numbers, place));
      }
    }
  }
}

} // namespace
