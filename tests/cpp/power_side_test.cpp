// SPDX-License-Identifier: GPL-3.0-or-later
// The conflict test of the power diagram, two doubles at a time and four, against each other and
// against exact arithmetic. It looks behind the C interface: which of the two is used depends on
// the processor, and a result that differs would be another surface elsewhere.
#include "core/grid.h"
#include "surface/power_side_wide.h"

#include <gtest/gtest.h>

#include <random>

namespace vbm::impl {
namespace {

class PowerSide : public testing::Test {
protected:
  void SetUp() override {
    if (!has_four_doubles()) GTEST_SKIP() << "this processor has no four doubles at once";
  }

  Site site(double x, double y, double z, double r) const {
    return {on_grid(x, kSiteGrid), on_grid(y, kSiteGrid), on_grid(z, kSiteGrid),
            on_grid(r, kSiteGrid)};
  }
  double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }

  /// Both, and what more digits and exact integers say; orientation does not matter to that.
  void compare(const Site (&s)[5]) {
    const int sign = power_side_precise(s[0], s[1], s[2], s[3], s[4]);
    ASSERT_EQ(power_side(s[0], s[1], s[2], s[3], s[4]), sign);
    ASSERT_EQ(power_side_wide(s[0], s[1], s[2], s[3], s[4]), sign);
    ++seen_[sign + 1];
  }

  std::mt19937_64 random_{1};
  int seen_[3] = {0, 0, 0};
};

TEST_F(PowerSide, OfAnyBalls) {
  for (int i = 0; i < 200000; ++i) {
    Site s[5];
    for (Site &t : s) t = site(number(), number(), number(), 0.3 + 0.3 * number());
    compare(s);
  }
  EXPECT_GT(seen_[0], 1000);
  EXPECT_GT(seen_[2], 1000);
}

TEST_F(PowerSide, OfBallsThroughOnePoint) {
  // All have the same power there, nearly: rounding to the grid and then to doubles decides.
  for (int i = 0; i < 100000; ++i) {
    Site s[5];
    for (Site &t : s) {
      const double x = number(), y = number(), z = number();
      t = site(x, y, z, std::sqrt(x * x + y * y + z * z));
    }
    compare(s);
  }
  EXPECT_GT(seen_[0], 1000);
  EXPECT_GT(seen_[2], 1000);
}

TEST_F(PowerSide, OfTies) {
  std::uniform_int_distribution<int> corner(0, 2);
  for (int i = 0; i < 100000; ++i) {
    Site s[5];
    for (Site &t : s) t = site(corner(random_), corner(random_), corner(random_), 0.5);
    compare(s);
  }
  EXPECT_GT(seen_[1], 1000);
}

} // namespace
} // namespace vbm::impl
