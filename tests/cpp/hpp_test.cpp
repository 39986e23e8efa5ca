// SPDX-License-Identifier: GPL-3.0-or-later
// The C++ header used as a C++ program would, and the parameter table against the options'
// defaults.
#include <vbm/vbm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace {

// An octahedron with every face split once: 18 points, and 8 triangles of the octahedron itself.
const std::vector<double> kPoints = {1,   0,  0,  -1, 0,  0,   0, 1,   0,   0, -1,  0,   0, 0,
                                     1,   0,  0,  -1, .7, .7,  0, .7,  -.7, 0, -.7, .7,  0, -.7,
                                     -.7, 0,  .7, 0,  .7, .7,  0, -.7, -.7, 0, .7,  -.7, 0, -.7,
                                     0,   .7, .7, 0,  .7, -.7, 0, -.7, .7,  0, -.7, -.7};
const std::vector<int32_t> kTriangles = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                         2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

vbm::View<double, 3> points() { return {kPoints.data(), kPoints.size() / 3}; }

TEST(Hpp, BuildsAndReads) {
  vbm::Context context;
  const vbm::Model model = vbm::build_points(context, points());
  EXPECT_EQ(model.report().input_points, 18u);
  EXPECT_EQ(model.centers().size, model.radii().size);
  EXPECT_EQ(model.ball_samples().size(), model.radii().size);
  EXPECT_GE(model.ball_samples()[0].size, 4u);
  EXPECT_TRUE(model.inside()[0]);
  const vbm::Surface surface = model.surface(context);
  EXPECT_EQ(surface.report().components, 1u);
  EXPECT_EQ(surface.polygons().size(), surface.triangles().size);
  const int32_t *triangle = surface.triangles()[0];
  EXPECT_EQ(surface.polygons()[0][1], triangle[1]);
  const double *corner = surface.vertices()[std::size_t(triangle[0])];
  EXPECT_LE(corner[0] * corner[0] + corner[1] * corner[1] + corner[2] * corner[2], 1.0);
}

TEST(Hpp, TrianglesAndPolygonsAreTheSame) {
  vbm::Context context;
  const vbm::View<double, 3> vertices{kPoints.data(), 6};
  const vbm::Model triangles =
      vbm::build_mesh(context, vertices, vbm::View<int32_t, 3>{kTriangles.data(), 8});
  const std::vector<uint32_t> sizes(8, 3);
  const vbm::Model polygons = vbm::build_mesh(context, vertices, {sizes.data(), sizes.size()},
                                              {kTriangles.data(), kTriangles.size()});
  ASSERT_EQ(triangles.radii().size, polygons.radii().size);
  EXPECT_EQ(0, std::memcmp(triangles.centers().data, polygons.centers().data,
                           triangles.centers().size * 3 * sizeof(double)));
}

TEST(Hpp, ErrorsAreThrown) {
  vbm::Context context;
  std::vector<double> bad = kPoints;
  bad[7] = HUGE_VAL;
  try {
    vbm::build_points(context, {bad.data(), bad.size() / 3});
    FAIL() << "an infinite coordinate was accepted";
  } catch (const vbm::Error &error) {
    EXPECT_EQ(error.status, VBM_ERROR_INPUT);
    EXPECT_EQ(error.kind, "vertex");
    EXPECT_EQ(error.elements, std::vector<int64_t>{2});
    EXPECT_EQ(error.total, 1u);
    EXPECT_NE(std::string(error.what()).find('2'), std::string::npos);
  }
  EXPECT_NO_THROW(vbm::build_points(context, points()));
}

TEST(Hpp, AnEmptyMaskKeepsNothing) {
  vbm::Context context;
  const vbm::Model model = vbm::build_points(context, points());
  EXPECT_THROW(model.power_crust(context, vbm::View<uint8_t>{}), vbm::Error);
  EXPECT_NO_THROW(model.power_crust(context));
}

TEST(Hpp, ProgressCancelsAndThrows) {
  vbm::Context first;
  double last = -1;
  first.set_progress([&](double fraction, const char *) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return false;
  });
  vbm::Context context = std::move(first); // the callback moves with it
  vbm::build_points(context, points());
  EXPECT_EQ(last, 1);
  context.set_progress([](double, const char *) { return true; });
  try {
    vbm::build_points(context, points());
    FAIL() << "not cancelled";
  } catch (const vbm::Error &error) {
    EXPECT_EQ(error.status, VBM_ERROR_CANCELLED);
  }
  context.set_progress([](double, const char *) -> bool { throw 42; });
  EXPECT_THROW(vbm::build_points(context, points()), int);
  context.set_progress(nullptr);
  EXPECT_NO_THROW(vbm::build_points(context, points()));
}

TEST(Hpp, HandlesMove) {
  static_assert(!std::is_copy_constructible_v<vbm::Model>);
  static_assert(std::is_nothrow_move_constructible_v<vbm::Model>);
  static_assert(!std::is_copy_constructible_v<vbm::Surface>);
  vbm::Context context;
  vbm::Model model = vbm::build_points(context, points());
  const double *centers = model.centers().data;
  const vbm::Model moved = std::move(model);
  EXPECT_EQ(moved.centers().data, centers);
}

TEST(Parameters, AgreeWithTheOptionsDefaults) {
  const vbm::BuildOptions options;
  const std::map<std::string, double> defaults = {{"balls", options.balls},
                                                  {"labels", options.labels},
                                                  {"spacing", options.spacing},
                                                  {"undersampling", options.undersampling},
                                                  {"drop_invalid", options.drop_invalid},
                                                  {"refine", options.refine},
                                                  {"sample_limit", double(options.sample_limit)},
                                                  {"cell_limit", double(options.cell_limit)}};
  std::size_t found = 0;
  for (const vbm_param &param : vbm::parameters()) {
    EXPECT_EQ(param.struct_size, sizeof(vbm_param));
    if (std::string(param.operation) != "build") continue;
    ++found;
    ASSERT_TRUE(defaults.count(param.name)) << param.name;
    EXPECT_EQ(param.default_value, defaults.at(param.name)) << param.name;
    EXPECT_LE(param.minimum, param.default_value) << param.name;
    EXPECT_GE(param.maximum, param.default_value) << param.name;
    if (param.type == VBM_PARAM_ENUM) {
      EXPECT_EQ(param.maximum + 1, param.enum_count) << param.name;
    }
  }
  EXPECT_EQ(found, defaults.size());
}

TEST(Parameters, OlderAndNewerCallers) {
  struct Newer {
    vbm_param param;
    double unknown[4];
  } newer;
  std::memset(&newer, 0xff, sizeof newer);
  newer.param.struct_size = sizeof newer;
  ASSERT_EQ(vbm_param_describe(0, &newer.param), VBM_OK);
  EXPECT_EQ(newer.param.struct_size, sizeof newer);
  EXPECT_STREQ(newer.param.name, "balls");
  EXPECT_EQ(newer.unknown[0], 0);
  EXPECT_EQ(newer.unknown[3], 0);

  vbm_param older;
  std::memset(&older, 0xff, sizeof older);
  older.struct_size = offsetof(vbm_param, label);
  ASSERT_EQ(vbm_param_describe(1, &older), VBM_OK);
  EXPECT_STREQ(older.name, "labels");
  EXPECT_EQ(older.struct_size, offsetof(vbm_param, label));
  vbm_param untouched;
  std::memset(&untouched, 0xff, sizeof untouched);
  EXPECT_EQ(0,
            std::memcmp(&older.label, &untouched.label, sizeof older - offsetof(vbm_param, label)));
}

TEST(Parameters, RefusesWhatIsNotThere) {
  vbm_param param;
  param.struct_size = sizeof param;
  EXPECT_EQ(vbm_param_describe(vbm_param_count(), &param), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(vbm_param_describe(0, nullptr), VBM_ERROR_ARGUMENT);
  param.struct_size = 0;
  EXPECT_EQ(vbm_param_describe(0, &param), VBM_ERROR_ARGUMENT);
}

} // namespace
