// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes: known shapes in every element type, borders, values that are no numbers, nothing and
// everything inside, noise, sizes that cannot be.
#include "outcome.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

namespace {

const double kPi = std::acos(-1.0);

struct Grid {
  size_t n[3];
  double size[3] = {1, 1, 1}, origin[3] = {0, 0, 0};
};

/// A build from a volume, which must live as long as the build.
template <class T>
Build volume_of(const std::vector<T> &values, vbm_scalar type, const Grid &g, double level) {
  return [&values, type, &g, level](vbm_context *context, const vbm_build_options *options,
                                    vbm_model **out) {
    return vbm_build_volume(context, values.data(), type, g.n[0], g.n[1], g.n[2], g.size, g.origin,
                            level, options, out);
  };
}

/// The function's values at the voxels' centres.
template <class T>
std::vector<T> fill(const Grid &g, const std::function<double(const shapes::Vec &)> &function) {
  std::vector<T> values;
  for (size_t i = 0; i < g.n[0]; ++i)
    for (size_t j = 0; j < g.n[1]; ++j)
      for (size_t k = 0; k < g.n[2]; ++k) {
        const double value =
            function({g.origin[0] + double(i) * g.size[0], g.origin[1] + double(j) * g.size[1],
                      g.origin[2] + double(k) * g.size[2]});
        values.push_back(T(std::is_integral_v<T> ? std::round(value) : value));
      }
  return values;
}

double volume_in_units(const Topology &t) { return t.volume * std::pow(t.diagonal, 3); }

void expect_solid(const Outcome &o, size_t components, int64_t genus, const char *what) {
  ASSERT_EQ(o.status, VBM_OK) << what << ": " << o.message;
  EXPECT_EQ(o.problems, "") << what;
  EXPECT_EQ(o.surface.components, components) << what << "\n" << o.notes;
  EXPECT_EQ(o.surface.genus, genus) << what;
  EXPECT_EQ(o.crust.components, components) << what << ", power crust";
  EXPECT_EQ(o.crust.genus, genus) << what << ", power crust";
  EXPECT_EQ(o.report.rule, VBM_LABELS_VOXELS) << what;
}

/// A ball of radius 6 in a grid of uneven voxels, far from the origin.
constexpr double kRadius = 6;
const Grid kBallGrid = {{17, 15, 30}, {1, 1.125, .5}, {100, -50, 7}};
double ball(const shapes::Vec &p) { return kRadius - shapes::distance(p, {108.1, -42.2, 14.3}); }

template <class T> Outcome ball_of(vbm_scalar type, double scale, double shift) {
  const std::vector<T> values =
      fill<T>(kBallGrid, [&](const shapes::Vec &p) { return scale * ball(p) + shift; });
  return run(volume_of(values, type, kBallGrid, shift));
}

TEST(Volume, EveryElementType) {
  const double exact = 4 * kPi / 3 * std::pow(kRadius, 3);
  const auto expect_ball = [&](const Outcome &o, const char *what) {
    expect_solid(o, 1, 0, what);
    EXPECT_NEAR(volume_in_units(o.surface) / exact, 1, .03) << what;
    EXPECT_NEAR(volume_in_units(o.crust) / exact, 1, .03) << what;
    EXPECT_EQ(o.report.input_points, 17u * 15 * 30) << what;
  };
  expect_ball(ball_of<double>(VBM_SCALAR_DOUBLE, 1, .25), "double");
  expect_ball(ball_of<float>(VBM_SCALAR_FLOAT, 1, -3), "float");
  expect_ball(ball_of<int16_t>(VBM_SCALAR_INT16, 1000, -2000), "int16");
  expect_ball(ball_of<uint16_t>(VBM_SCALAR_UINT16, 1000, 30000), "uint16");
  expect_ball(ball_of<uint8_t>(VBM_SCALAR_UINT8, 9, 128), "uint8");
}

TEST(Volume, BallsAreAsKnown) {
  const std::vector<double> values = fill<double>(kBallGrid, ball);
  vbm_context *context = nullptr;
  vbm_model *model = nullptr;
  ASSERT_EQ(vbm_context_create(&context), VBM_OK);
  ASSERT_EQ(volume_of(values, VBM_SCALAR_DOUBLE, kBallGrid, 0)(context, nullptr, &model), VBM_OK);
  size_t count = 0;
  const double *samples = vbm_model_samples(model, &count);
  for (size_t s = 0; s < count; ++s)
    // Linear interpolation of the distance: the chord's sagitta at most.
    EXPECT_NEAR(ball({samples[3 * s], samples[3 * s + 1], samples[3 * s + 2]}), 0, .04);
  const double *radii = vbm_model_inner_radius(model, &count);
  // Samples off the sphere by that much have poles before its middle, but none beyond.
  std::vector<double> sorted(radii, radii + count);
  std::sort(sorted.begin(), sorted.end());
  EXPECT_GT(sorted[count / 2], .8 * kRadius);
  EXPECT_LT(sorted.back(), kRadius + .04);
  size_t inputs = 0;
  const int32_t *input = vbm_model_sample_input(model, &inputs);
  for (size_t s = 0; s < inputs; ++s) EXPECT_EQ(input[s], -1);
  vbm_model_free(model);
  vbm_context_free(context);
}

TEST(Volume, Masks) {
  const Grid g = {{20, 20, 20}};
  const auto inside = [](const shapes::Vec &p) {
    return shapes::distance(p, {9.5, 9.5, 9.5}) < 7.2 ? 1. : 0.;
  };
  const std::vector<uint8_t> values = fill<uint8_t>(g, inside);
  const Outcome o = run(volume_of(values, VBM_SCALAR_UINT8, g, .5));
  expect_solid(o, 1, 0, "mask");
  double voxels = 0;
  for (uint8_t v : values) voxels += v;
  EXPECT_NEAR(volume_in_units(o.surface) / voxels, 1, .05);
}

TEST(Volume, Torus) {
  const Grid g = {{44, 44, 18}, {.25, .25, .25}, {-5.4, -5.4, -2.1}};
  const std::vector<float> values = fill<float>(
      g, [](const shapes::Vec &p) { return 1.5 - std::hypot(std::hypot(p[0], p[1]) - 3.5, p[2]); });
  const Outcome o = run(volume_of(values, VBM_SCALAR_FLOAT, g, 0));
  expect_solid(o, 1, 1, "torus");
  EXPECT_NEAR(volume_in_units(o.surface) / (2 * kPi * kPi * 3.5 * 1.5 * 1.5), 1, .03);
}

TEST(Volume, ClosedAtTheBorder) {
  // Half a ball, cut by the first layer of voxels; and a slab that touches four sides.
  const Grid g = {{8, 18, 18}};
  const std::vector<double> half = fill<double>(g, [](const shapes::Vec &p) {
    return 6.3 - shapes::distance(p, {0, 8.6, 8.4});
  });
  expect_solid(run(volume_of(half, VBM_SCALAR_DOUBLE, g, 0)), 1, 0, "half a ball");
  const std::vector<uint8_t> slab =
      fill<uint8_t>(g, [](const shapes::Vec &p) { return p[0] > 1.5 && p[0] < 5.5; });
  const Outcome o = run(volume_of(slab, VBM_SCALAR_UINT8, g, .5));
  expect_solid(o, 1, 0, "slab");
  EXPECT_NEAR(volume_in_units(o.surface) / (4 * 18 * 18), 1, .06);
}

TEST(Volume, CavitiesAndSeparateParts) {
  const Grid g = {{26, 26, 26}};
  const std::vector<double> values = fill<double>(g, [](const shapes::Vec &p) {
    const double r = shapes::distance(p, {12.6, 12.5, 12.4});
    return std::max(3.1 - r, std::min(11.3 - r, r - 6.8)); // a shell round a ball
  });
  expect_solid(run(volume_of(values, VBM_SCALAR_DOUBLE, g, 0)), 3, 0, "shell and ball");
}

TEST(Volume, NothingOrEverything) {
  const Grid g = {{6, 6, 6}};
  const std::vector<uint8_t> values(216, 7);
  const Outcome none = run(volume_of(values, VBM_SCALAR_UINT8, g, 8));
  EXPECT_EQ(none.status, VBM_ERROR_NO_INTERIOR) << none.message;
  EXPECT_EQ(none.problems, "");
  EXPECT_NE(none.message.find("level 8"), std::string::npos) << none.message;
  // All inside: refused, or the whole box.
  const Outcome all = run(volume_of(values, VBM_SCALAR_UINT8, g, 7));
  EXPECT_EQ(all.problems, "");
  if (all.status == VBM_OK) {
    EXPECT_NEAR(volume_in_units(all.surface), 216, 20);
  } else {
    EXPECT_EQ(all.status, VBM_ERROR_NO_INTERIOR) << all.message;
  }
}

TEST(Volume, SingleVoxels) {
  const Grid g = {{3, 3, 3}};
  std::vector<uint8_t> values(27, 0);
  values[13] = 1;
  const Outcome middle = run(volume_of(values, VBM_SCALAR_UINT8, g, 1));
  expect_solid(middle, 1, 0, "one voxel");
  values[13] = 0, values[0] = 1;
  expect_solid(run(volume_of(values, VBM_SCALAR_UINT8, g, 1)), 1, 0, "one voxel in the corner");
  const Grid one = {{1, 1, 1}};
  const std::vector<double> single = {1};
  const Outcome o = run(volume_of(single, VBM_SCALAR_DOUBLE, one, .5));
  EXPECT_EQ(o.problems, "");
  EXPECT_TRUE(o.status == VBM_OK || o.status == VBM_ERROR_NO_INTERIOR) << o.message;
  // A row and a plane of voxels are as thick as a voxel.
  const Grid row = {{1, 1, 9}};
  const std::vector<uint8_t> bar = {0, 0, 1, 1, 1, 1, 0, 0, 0};
  expect_solid(run(volume_of(bar, VBM_SCALAR_UINT8, row, 1)), 1, 0, "a row");
}

TEST(Volume, NotANumber) {
  std::vector<double> values = fill<double>(kBallGrid, ball);
  values[2000] = std::nan("");
  const Outcome o = run(volume_of(values, VBM_SCALAR_DOUBLE, kBallGrid, 0));
  EXPECT_EQ(o.status, VBM_ERROR_INPUT);
  EXPECT_EQ(o.problems, "");
  EXPECT_EQ(o.bad, std::vector<int64_t>{2000});
  EXPECT_NE(o.message.find("(4, 6, 20)"), std::string::npos) << o.message;
  vbm_build_options options = make_options();
  options.drop_invalid = 1;
  const Outcome dropped = run(volume_of(values, VBM_SCALAR_DOUBLE, kBallGrid, 0), options);
  EXPECT_EQ(dropped.status, VBM_OK) << dropped.message;
  EXPECT_EQ(dropped.problems, "");
  EXPECT_EQ(dropped.report.dropped, 1u);
  values.assign(values.size(), std::nan(""));
  const Outcome all = run(volume_of(values, VBM_SCALAR_DOUBLE, kBallGrid, 0), options);
  EXPECT_EQ(all.status, VBM_ERROR_NO_INTERIOR) << all.message;
  EXPECT_EQ(all.problems, "");
}

TEST(Volume, InfiniteValuesAreLargeValues) {
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<double> values =
      fill<double>(kBallGrid, [&](const shapes::Vec &p) { return ball(p) >= 0 ? inf : -inf; });
  expect_solid(run(volume_of(values, VBM_SCALAR_DOUBLE, kBallGrid, 0)), 1, 0, "infinite");
  const std::vector<double> huge = fill<double>(
      kBallGrid, [&](const shapes::Vec &p) { return ball(p) >= 0 ? 1.7e308 : -1.7e308; });
  expect_solid(run(volume_of(huge, VBM_SCALAR_DOUBLE, kBallGrid, 0)), 1, 0, "nearly infinite");
}

TEST(Volume, CheckerboardAndNoise) {
  // Corners and edges touch everywhere: closed and manifold all the same.
  const Grid g = {{9, 9, 9}};
  const std::vector<uint8_t> checker =
      fill<uint8_t>(g, [](const shapes::Vec &p) { return int(p[0] + p[1] + p[2]) % 2; });
  for (const vbm_labels labels : {VBM_LABELS_AUTO, VBM_LABELS_PROPAGATION, VBM_LABELS_NORMALS}) {
    const Outcome o =
        run(volume_of(checker, VBM_SCALAR_UINT8, g, 1), make_options(VBM_BALLS_POLAR, labels));
    EXPECT_TRUE(o.status == VBM_OK || o.status == VBM_ERROR_NO_INTERIOR) << o.message;
    EXPECT_EQ(o.problems, "");
  }
  shapes::Random random(5);
  const Grid h = {{14, 14, 14}};
  const std::vector<float> noise =
      fill<float>(h, [&](const shapes::Vec &) { return random.real(); });
  for (double level : {.05, .5, .95}) {
    const Outcome o = run(volume_of(noise, VBM_SCALAR_FLOAT, h, level));
    EXPECT_TRUE(o.status == VBM_OK || o.status == VBM_ERROR_NO_INTERIOR) << o.message;
    EXPECT_EQ(o.problems, "") << level;
  }
}

TEST(Volume, ImpossibleGrids) {
  const std::vector<uint8_t> values(64, 1);
  const auto refused = [&](Grid g, double level, const char *what) {
    const Outcome o = run(volume_of(values, VBM_SCALAR_UINT8, g, level));
    EXPECT_EQ(o.status, VBM_ERROR_ARGUMENT) << what << ": " << o.message;
    EXPECT_EQ(o.problems, "") << what;
  };
  const double nan = std::nan(""), inf = HUGE_VAL;
  const size_t huge = size_t(1) << 32;
  refused({{4, 4, 0}}, 1, "no voxels");
  refused({{huge, huge, 1}}, 1, "2^64 voxels");
  refused({{SIZE_MAX, SIZE_MAX, SIZE_MAX}}, 1, "far too many voxels");
  refused({{4, 4, 4}, {0, 1, 1}}, 1, "voxel of no size");
  refused({{4, 4, 4}, {1, -1, 1}}, 1, "voxel of negative size");
  refused({{4, 4, 4}, {1, 1, nan}}, 1, "voxel size not a number");
  refused({{4, 4, 4}, {1, 1, inf}}, 1, "infinite voxel");
  refused({{4, 4, 4}, {1, 1, 1}, {0, nan, 0}}, 1, "origin not a number");
  refused({{4, 4, 4}, {1e308, 1, 1}, {1e308, 0, 0}}, 1, "beyond the largest double");
  refused({{4, 4, 4}}, nan, "level not a number");
  const Grid g = {{4, 4, 4}};
  const Outcome o = run(volume_of(values, vbm_scalar(5), g, 1));
  EXPECT_EQ(o.status, VBM_ERROR_ARGUMENT) << o.message;
}

TEST(Volume, ExtremeVoxelSizes) {
  const Outcome unit = ball_of<double>(VBM_SCALAR_DOUBLE, 1, 0);
  for (int exponent : {-900, -300, 300, 900}) {
    Grid g = kBallGrid;
    for (double *x : {&g.size[0], &g.size[1], &g.size[2], &g.origin[0], &g.origin[1], &g.origin[2]})
      *x = std::ldexp(*x, exponent);
    const std::vector<double> values = fill<double>(kBallGrid, ball);
    const Outcome o = run(volume_of(values, VBM_SCALAR_DOUBLE, g, 0));
    expect_solid(o, 1, 0, "scaled by a power of two");
    EXPECT_EQ(o.surface.triangles, unit.surface.triangles);
    EXPECT_DOUBLE_EQ(o.surface.volume, unit.surface.volume);
  }
  // A million times longer than wide: done, or refused with a reason.
  const Grid thin = {{4, 12, 12}, {1e6, 1, 1}};
  const std::vector<double> rod = fill<double>(
      {{4, 12, 12}}, [](const shapes::Vec &p) { return 4.3 - std::hypot(p[1] - 5.6, p[2] - 5.4); });
  const Outcome o = run(volume_of(rod, VBM_SCALAR_DOUBLE, thin, 0));
  EXPECT_EQ(o.problems, "");
}

} // namespace
