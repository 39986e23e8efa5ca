// SPDX-License-Identifier: GPL-3.0-or-later
// Axes of a number of balls, on shapes whose axes are known.
#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace {

// How far inside the box of shapes::box() a point is.
double depth(const Point3m &p) {
  const double size[3] = {4, 2, 1};
  double least = 10;
  for (int a = 0; a < 3; ++a) least = std::min({least, double(p[a]), size[a] - p[a]});
  return least;
}

TEST(AxisOfBalls, HasAsManyAsAskedFor) {
  MeshDocument document;
  MeshModel *source = shapes::box(document, 0.1);
  const auto result = host::apply(host::kAxisOfBalls, document, {{"count", 80}});
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_EQ(host::layers(document), 2);
  EXPECT_FALSE(source->isVisible());
  const MeshModel *made = document.mm();
  EXPECT_EQ(made->label(), "box axis of 80 balls");
  ASSERT_EQ(made->cm.VN(), 80);
  EXPECT_GT(made->cm.FN(), 80);
  ASSERT_TRUE(made->hasDataMask(MeshModel::MM_VERTRADIUS | MeshModel::MM_VERTQUALITY |
                                MeshModel::MM_VERTCOLOR));
  for (const auto &ball : made->cm.vert) {
    EXPECT_NEAR(ball.cR(), depth(ball.cP()), 0.1);
    EXPECT_EQ(float(ball.cR()), float(ball.cQ()));
  }
  EXPECT_TRUE(result.logged("Axis of 80 balls: "));
  EXPECT_TRUE(result.logged("1 component, Euler characteristic 1."));
  EXPECT_TRUE(result.logged("off by at most 0."));
}

// In ascending order: the same whatever the order of vertices.
std::vector<std::vector<float>> balls(const CMeshO &mesh) {
  std::vector<std::vector<float>> all;
  for (const auto &v : mesh.vert) all.push_back({v.cP()[0], v.cP()[1], v.cP()[2], float(v.cR())});
  std::sort(all.begin(), all.end());
  return all;
}

TEST(AxisOfBalls, OfAnAxisTakesThePartsThatAreLeft) {
  MeshDocument document;
  MeshModel *source = shapes::horned_sphere(document);
  ASSERT_TRUE(host::apply(host::kAxisOfBalls, document, {{"count", 30}, {"spacing", -1}}).ok);
  const auto of_shape = balls(document.mm()->cm);
  document.setCurrentMesh(source->id());
  ASSERT_TRUE(host::apply(host::kAxis, document, {{"spacing", -1}}).ok);
  auto result = host::apply(host::kAxisOfBalls, document, {{"count", 30}, {"spacing", -1}});
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_EQ(balls(document.mm()->cm), of_shape) << "of the whole axis it is that of the shape";
  EXPECT_FALSE(result.logged("inside told from outside")) << "there is no need to build it again";

  document.setCurrentMesh(source->id());
  ASSERT_TRUE(
      host::apply(
          host::kSimplify, document,
          {{"spacing", -1}, {"axis", 1}, {"measure", 1}, {"threshold", 0.2}, {"iterations", 40}})
          .ok);
  MeshModel *pruned = nullptr;
  for (int id = 0; id < 20; ++id)
    if (MeshModel *layer = document.getMesh(id))
      if (layer->label().contains(" axis") && !layer->label().contains(" of ")) pruned = layer;
  ASSERT_NE(pruned, nullptr);
  document.setCurrentMesh(pruned->id());
  result = host::apply(host::kAxisOfBalls, document, {{"count", 30}, {"spacing", -1}});
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_NE(balls(document.mm()->cm), of_shape);
  EXPECT_EQ(document.mm()->label().count(" axis"), 1);
}

TEST(AxisOfBalls, SaysHowFewBallsTheTopologyAllows) {
  MeshDocument document;
  shapes::torus(document, 3, 1);
  for (const auto &[count, part] : {std::pair{1.0, "balls"}, std::pair{0.0, "count is 0"}}) {
    const auto result =
        host::apply(host::kAxisOfBalls, document, {{"count", count}, {"spacing", -1}});
    EXPECT_FALSE(result.ok);
    EXPECT_NE(result.error.find(part), std::string::npos) << result.error;
    EXPECT_TRUE(result.logged(result.error));
    EXPECT_EQ(host::layers(document), 1);
  }
}

} // namespace
