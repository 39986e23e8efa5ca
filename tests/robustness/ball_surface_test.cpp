// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces and measures of any balls at the C interface, in every style: cancelling at every
// report, the same bytes in every environment, options of old and new callers.
#include "child.h"
#include "host.h"
#include "snapshot.h"

#include <vbm/vbm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace {

struct Balls {
  std::vector<double> centers, radii;
};

/// Most of them meet others; some are apart, one is hidden, one a point.
Balls scattered(std::size_t count) {
  Balls balls;
  uint64_t state = 1;
  const auto unit = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return double(state >> 11) * 0x1p-53;
  };
  for (std::size_t i = 0; i < count; ++i) {
    for (int a = 0; a < 3; ++a) balls.centers.push_back(unit());
    balls.radii.push_back(.02 + .15 * unit());
  }
  balls.centers.insert(balls.centers.end(), {.5, .5, .5, .5, .5, .5, 2, 2, 2});
  balls.radii.insert(balls.radii.end(), {.2, .1, 0});
  return balls;
}

/// One call: its status, and the bytes of what it made.
using Call = std::function<vbm_status(vbm_context *, std::string *bytes)>;

vbm_status surface_of(vbm_context *context, const Balls &balls, int32_t style, std::string *bytes) {
  vbm_ball_surface_options options;
  vbm_ball_surface_options_init(&options, sizeof options);
  options.style = style;
  options.errors = style == VBM_BALL_STYLE_SINGULAR_POINTS;
  vbm_surface *surface = reinterpret_cast<vbm_surface *>(context);
  const vbm_status status = vbm_surface_from_balls(
      context, balls.centers.data(), balls.radii.data(), balls.radii.size(), &options, &surface);
  EXPECT_EQ(status == VBM_OK, surface != nullptr);
  if (bytes && surface) *bytes = snapshot(surface);
  vbm_surface_free(surface);
  return status;
}

vbm_status measures_of(vbm_context *context, const Balls &balls, std::string *bytes) {
  vbm_measures *measures = reinterpret_cast<vbm_measures *>(context);
  const vbm_status status = vbm_union_measures(context, balls.centers.data(), balls.radii.data(),
                                               balls.radii.size(), &measures);
  EXPECT_EQ(status == VBM_OK, measures != nullptr);
  std::size_t count = 0;
  if (bytes && measures) {
    const double *volumes = vbm_measures_ball_volumes(measures, &count);
    bytes->assign(reinterpret_cast<const char *>(volumes), count * sizeof *volumes);
    const double *areas = vbm_measures_ball_areas(measures, &count);
    bytes->append(reinterpret_cast<const char *>(areas), count * sizeof *areas);
  }
  vbm_measures_free(measures);
  return status;
}

class BallSurfaces : public testing::TestWithParam<int> {
protected:
  void SetUp() override { ASSERT_EQ(vbm_context_create(&context), VBM_OK); }
  void TearDown() override { vbm_context_free(context); }

  Call call(const Balls &balls) const {
    return [&balls, style = GetParam()](vbm_context *c, std::string *bytes) {
      return style < 0 ? measures_of(c, balls, bytes) : surface_of(c, balls, style, bytes);
    };
  }

  vbm_context *context = nullptr;
};

struct Watch {
  int stop = 0, calls = 0;
  double last = 0;
  bool fell = false;
  static int report(void *user, double fraction, const char *) {
    Watch &w = *static_cast<Watch *>(user);
    w.fell |= fraction < w.last;
    w.last = fraction;
    return ++w.calls == w.stop;
  }
};

TEST_P(BallSurfaces, CancelAtReports) {
  const bool slow = GetParam() == VBM_BALL_STYLE_SKIN || GetParam() == VBM_BALL_STYLE_POWER_CRUST;
  const Balls balls = scattered(slow ? 60 : 200);
  std::string whole, again;
  ASSERT_EQ(call(balls)(context, &whole), VBM_OK) << vbm_context_message(context);
  Watch watch;
  vbm_context_set_progress(context, &Watch::report, &watch);
  ASSERT_EQ(call(balls)(context, &again), VBM_OK);
  EXPECT_TRUE(again == whole);
  EXPECT_FALSE(watch.fell);
  EXPECT_EQ(watch.last, 1);
  const int reports = watch.calls;
  for (int k = 1; k <= reports; k += 1 + reports / (sanitized() ? 10 : 40)) {
    watch = {};
    watch.stop = k;
    const vbm_status status = call(balls)(context, nullptr);
    if (watch.calls < k) continue; // reports come by the clock
    EXPECT_EQ(status, VBM_ERROR_CANCELLED) << k;
    EXPECT_EQ(std::string(vbm_context_message(context)).rfind("cancelled", 0), 0u);
  }
  vbm_context_set_progress(context, nullptr, nullptr);
  ASSERT_EQ(call(balls)(context, &again), VBM_OK);
  EXPECT_TRUE(again == whole) << "another result after cancelling";
}

TEST_P(BallSurfaces, TheSameInEveryEnvironment) {
  const Balls balls = scattered(sanitized() ? 50 : 150), other = scattered(30);
  std::string first, again, there;
  ASSERT_EQ(call(balls)(context, &first), VBM_OK);
  ASSERT_EQ(call(other)(context, nullptr), VBM_OK);
  ASSERT_EQ(call(balls)(context, &again), VBM_OK);
  EXPECT_TRUE(again == first);
  std::thread([&] {
    vbm_context *own = nullptr;
    ASSERT_EQ(vbm_context_create(&own), VBM_OK);
    EXPECT_EQ(call(balls)(own, &there), VBM_OK);
    vbm_context_free(own);
  }).join();
  EXPECT_TRUE(there == first) << "in another thread";
  if (!have_comma_locale()) GTEST_SKIP() << "no locale de_DE.UTF-8";
  EXPECT_EQ(in_odd_host([&] { EXPECT_EQ(call(balls)(context, &again), VBM_OK); }), "");
  EXPECT_TRUE(again == first) << "in an odd host";
}

std::string name_of(const testing::TestParamInfo<int> &info) {
  static const char *const kNames[] = {"Measures", "SingularPoints", "Skin", "PowerCrust"};
  return kNames[info.param + 1];
}

INSTANTIATE_TEST_SUITE_P(Styles, BallSurfaces,
                         testing::Values(-1, VBM_BALL_STYLE_SINGULAR_POINTS, VBM_BALL_STYLE_SKIN,
                                         VBM_BALL_STYLE_POWER_CRUST),
                         name_of);

TEST(BallSurfaceOptions, OlderCallersGetTheDefaultShrinkFactor) {
  vbm_context *context = nullptr;
  ASSERT_EQ(vbm_context_create(&context), VBM_OK);
  const Balls balls = scattered(30);
  const auto skin = [&](const vbm_ball_surface_options &options, std::string *bytes) {
    vbm_surface *surface = nullptr;
    const vbm_status status = vbm_surface_from_balls(
        context, balls.centers.data(), balls.radii.data(), balls.radii.size(), &options, &surface);
    if (surface) *bytes = snapshot(surface);
    vbm_surface_free(surface);
    return status;
  };
  vbm_ball_surface_options options;
  vbm_ball_surface_options_init(&options, sizeof options);
  EXPECT_EQ(options.shrink, .9);
  options.style = VBM_BALL_STYLE_SKIN;
  std::string usual, old, other;
  EXPECT_EQ(skin(options, &usual), VBM_OK);
  options.shrink = .5;
  EXPECT_EQ(skin(options, &other), VBM_OK);
  EXPECT_FALSE(other == usual);
  options.struct_size = offsetof(vbm_ball_surface_options, shrink); // does not know of it
  EXPECT_EQ(skin(options, &old), VBM_OK);
  EXPECT_TRUE(old == usual);
  options.struct_size = sizeof options;
  for (const double bad : {0., .04, 1., -1., std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    options.shrink = bad;
    EXPECT_EQ(skin(options, &old), VBM_ERROR_ARGUMENT);
    EXPECT_STREQ(vbm_context_message(context), "option shrink is outside its range 0.05 to 0.99");
  }
  options.shrink = .9;
  for (const int32_t bad : {-1, 3}) {
    options.style = bad;
    EXPECT_EQ(skin(options, &old), VBM_ERROR_ARGUMENT);
  }
  vbm_context_free(context);
}

} // namespace
