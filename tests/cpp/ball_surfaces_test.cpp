// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces from balls, in every style: what OpenMesh takes them for. (GUDHI's opinion:
// tests/python/test_ball_surface.py and test_ball_styles.py.)
#include "open_mesh.h"
#include "shapes.h"

#include <vbm/vbm.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

struct Balls {
  std::vector<double> centers, radii;
  void add(double x, double y, double z, double r) {
    centers.insert(centers.end(), {x, y, z});
    radii.push_back(r);
  }
};

/// The inner polar balls of a jittered torus: most of them are bare in strips round its tube.
Balls torus() {
  const shapes::Shape shape = shapes::torus(60, 24, 1, .35, .4);
  vbm_context *context = nullptr;
  vbm_model *model = nullptr;
  EXPECT_EQ(vbm_context_create(&context), VBM_OK);
  EXPECT_EQ(vbm_build_points(context, shape.points.data(), shape.size(), shape.normals.data(),
                             nullptr, &model),
            VBM_OK);
  const double *centers = vbm_model_centers(model, nullptr),
               *radii = vbm_model_radii(model, nullptr);
  Balls balls;
  for (std::size_t b = 0; b < vbm_model_inner_count(model); ++b)
    balls.add(centers[3 * b], centers[3 * b + 1], centers[3 * b + 2], radii[b]);
  vbm_model_free(model);
  vbm_context_free(context);
  return balls;
}

Balls scattered(uint64_t seed) {
  shapes::Random random(seed);
  Balls balls;
  for (int i = 0; i < 60; ++i) {
    const double x = random.real(), y = random.real(), z = random.real();
    balls.add(x, y, z, random.real(.05, .25));
  }
  return balls;
}

/// Not one tetrahedron: a chain, a ring, a sheet, one alone.
Balls flat() {
  Balls balls;
  for (int i = 0; i < 8; ++i) balls.add(i * .9, 0, 0, .5);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 5; ++j) balls.add(i, 4 + j, 0, .8);
  const double turn[6][2] = {{1, 0}, {.5, .866}, {-.5, .866}, {-1, 0}, {-.5, -.866}, {.5, -.866}};
  for (const auto &t : turn) balls.add(20 + t[0], t[1], 0, .55);
  balls.add(30, 0, 0, 1);
  return balls;
}

class BallSurfaces : public testing::TestWithParam<int32_t> {};

void check(const Balls &balls, int32_t style, double bulge, const std::string &name) {
  vbm::BallSurfaceOptions options;
  options.style = style;
  options.bulge = bulge;
  vbm_context *context = nullptr;
  ASSERT_EQ(vbm_context_create(&context), VBM_OK);
  vbm_surface *surface = nullptr;
  ASSERT_EQ(vbm_surface_from_balls(context, balls.centers.data(), balls.radii.data(),
                                   balls.radii.size(), &options, &surface),
            VBM_OK)
      << vbm_context_message(context);
  Problems problems;
  open_mesh_check(surface, problems);
  EXPECT_EQ(problems.text(), "") << name << ", bulge " << bulge;
  vbm_surface_free(surface);
  vbm_context_free(context);
}

TEST_P(BallSurfaces, AreWhatOpenMeshTakesForClosed) {
  const bool quick = GetParam() == VBM_BALL_STYLE_SINGULAR_POINTS;
  for (const double bulge : {.15, .03}) {
    check(torus(), GetParam(), bulge, "torus");
    check(flat(), GetParam(), bulge, "flat");
    for (uint64_t seed = 1; seed <= (quick ? 20 : 2); ++seed)
      check(scattered(seed), GetParam(), bulge, "scattered " + std::to_string(seed));
    if (!quick) break;
  }
}

std::string style_name(const testing::TestParamInfo<int32_t> &info) {
  const char *names[] = {"SingularPoints", "Skin", "PowerCrust"};
  return names[info.param];
}

INSTANTIATE_TEST_SUITE_P(Styles, BallSurfaces,
                         testing::Values(VBM_BALL_STYLE_SINGULAR_POINTS, VBM_BALL_STYLE_SKIN,
                                         VBM_BALL_STYLE_POWER_CRUST),
                         style_name);

} // namespace
