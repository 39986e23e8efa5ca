// SPDX-License-Identifier: GPL-3.0-or-later
// Both surfaces of real models, from bare points and from meshes: closed, manifold, and of the
// model's components and handles, by our own counting and by OpenMesh's.
#include "outcome.h"
#include "read.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <string>

namespace {

struct Real {
  const char *file;
  bool faces; // its vertices alone are too thin a sampling
  int64_t genus;

  friend void PrintTo(const Real &r, std::ostream *out) { *out << r.file; }
};

class RealModels : public testing::TestWithParam<Real> {};

TEST_P(RealModels, HaveTheirTopology) {
  const char *shared = std::getenv("VBM_SHARED");
  const std::string path = std::string(shared ? shared : VBM_SOURCE_DIR "/../shared") +
                           "/data/meshes/" + GetParam().file;
  if (!std::filesystem::exists(path))
    GTEST_SKIP() << path << " is not there; VBM_SHARED names the folder with test data";
  const Geometry g = read_geometry(path);
  const Build points = [&](vbm_context *context, const vbm_build_options *o, vbm_model **out) {
    return vbm_build_points(context, g.points.data(), g.size(), nullptr, o, out);
  };
  const Build mesh = [&](vbm_context *context, const vbm_build_options *o, vbm_model **out) {
    return vbm_build_mesh(context, g.points.data(), g.size(), g.sizes.data(), g.corners.data(),
                          g.corners.size(), g.sizes.size(), o, out);
  };
  const Outcome o = run(GetParam().faces ? mesh : points);
  ASSERT_EQ(o.status, VBM_OK) << o.message;
  EXPECT_EQ(o.problems, "");
  for (const Topology &t : {o.surface, o.crust}) {
    EXPECT_EQ(t.components, 1u);
    EXPECT_EQ(t.genus, GetParam().genus);
  }
  // Every sample is a vertex once: two triangles a sample, but for the handles' few.
  if (o.report.unused_samples == 0 && o.surface.vertices == o.report.samples) {
    EXPECT_EQ(int64_t(o.surface.triangles),
              2 * int64_t(o.report.samples) - 4 + 4 * GetParam().genus);
  }
  EXPECT_NEAR(double(o.surface.triangles) / double(o.report.samples), 2, .05);
  // The largest reach out of the samples' box, in its diagonals: no needles.
  EXPECT_LT(o.surface.reach, 1e-12);
  EXPECT_LT(o.crust.reach, .02);
}

INSTANTIATE_TEST_SUITE_P(
    All, RealModels,
    testing::Values(Real{"double-torus.obj", false, 2}, Real{"3holes.obj", false, 3},
                    Real{"penguin.obj", false, 0}, Real{"wingnut.obj", false, 0},
                    Real{"spot.obj", false, 0}, Real{"decimated-max.obj", false, 0},
                    Real{"stanford-bunny.obj", false, 0}, Real{"fandisk.obj", true, 0},
                    Real{"femur.off", true, 2}, Real{"skull_low_resolution.obj", true, 2}),
    [](const testing::TestParamInfo<Real> &info) {
      std::string name = info.param.file;
      name = name.substr(0, name.rfind('.'));
      for (char &c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
      return name;
    });

} // namespace
