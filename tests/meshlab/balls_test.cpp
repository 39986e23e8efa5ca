// SPDX-License-Identifier: GPL-3.0-or-later
// The filters that work on any layer of balls, on balls whose union is known.
#include "shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace {

const double kPi = std::acos(-1.0);

// x, y, z and radius of each.
MeshModel *balls(MeshDocument &document, const std::vector<std::array<double, 4>> &list) {
  MeshModel *layer = host::add_layer(document, "balls.ply");
  layer->updateDataMask(MeshModel::MM_VERTRADIUS);
  for (const auto &ball : list) {
    auto added = vcg::tri::Allocator<CMeshO>::AddVertex(
        layer->cm, Point3m(Scalarm(ball[0]), Scalarm(ball[1]), Scalarm(ball[2])));
    added->R() = Scalarm(ball[3]);
  }
  vcg::tri::UpdateBounding<CMeshO>::Box(layer->cm);
  return layer;
}

std::vector<std::array<double, 4>> ring(int count) {
  std::vector<std::array<double, 4>> list;
  for (int i = 0; i < count; ++i) {
    const double turn = 2 * kPi * i / count;
    list.push_back({3 * std::cos(turn), 3 * std::sin(turn), 0.1 * (i % 2), 1});
  }
  return list;
}

void expect_closed(MeshModel &layer, int genus, int components = 1) {
  const auto check = shapes::check(layer);
  EXPECT_EQ(check.border_edges + check.bad_edges + check.bad_vertices + check.holes, 0);
  EXPECT_EQ(check.genus, genus);
  EXPECT_EQ(check.components, components);
  EXPECT_TRUE(check.oriented);
  EXPECT_GT(check.volume, 0);
}

TEST(BallSurface, HasTheTopologyOfTheUnion) {
  MeshDocument document;
  MeshModel *source = balls(document, ring(12));
  auto result = host::apply(host::kBallSurface, document);
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_EQ(document.mm()->label(), "balls surface");
  EXPECT_TRUE(result.logged("Took 12 balls."));
  EXPECT_TRUE(result.logged("genus 1"));
  EXPECT_FALSE(result.logged("to the surface: at most"));
  expect_closed(*document.mm(), 1);
  EXPECT_FALSE(source->isVisible());

  document.setCurrentMesh(source->id());
  result = host::apply(host::kBallSurface, document, {{"errors", 1}});
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_TRUE(result.logged("to the balls' union: at most 0."));
  EXPECT_TRUE(result.logged("to the surface: at most 0."));

  // Far apart: each ball a surface of its own.
  balls(document, {{0, 0, 0, 1}, {5, 0, 0, 2}, {0, 9, 0, 0.5}});
  result = host::apply(host::kBallSurface, document);
  ASSERT_TRUE(result.ok) << result.error;
  expect_closed(*document.mm(), 0, 3);
}

TEST(BallSurface, HasStyles) {
  MeshDocument document;
  EXPECT_EQ(host::items(host::kBallSurface, "style", document),
            (std::vector<std::string>{"Singular Points", "Skin", "Power Crust"}));
  for (const int style : {1, 2}) {
    balls(document, ring(12));
    const auto result =
        host::apply(host::kBallSurface, document, {{"style", style}, {"shrink", 0.95}});
    ASSERT_TRUE(result.ok) << result.error;
    expect_closed(*document.mm(), 1);
    EXPECT_EQ(result.logged("square root of the shrink factor"), style == 1);
  }
  // The dialog's floats at both ends are in the range.
  for (const double shrink : {0.05, 0.99}) {
    balls(document, ring(12));
    const auto end = host::apply(host::kBallSurface, document, {{"shrink", shrink}});
    EXPECT_TRUE(end.ok) << end.error;
  }
  balls(document, ring(12));
  const auto result = host::apply(host::kBallSurface, document, {{"style", 1}, {"shrink", 1}});
  EXPECT_FALSE(result.ok);
  EXPECT_NE(result.error.find("shrink"), std::string::npos) << result.error;
}

TEST(BallSurface, OfABallModelHasAboutAFaceABall) {
  MeshDocument document;
  shapes::torus(document, 3, 1);
  ASSERT_TRUE(host::apply(host::kBalls, document, {{"spacing", -1}}).ok);
  const int count = document.mm()->cm.VN();
  const auto result = host::apply(host::kBallSurface, document, {{"polygons", 1}});
  ASSERT_TRUE(result.ok) << result.error;
  expect_closed(*document.mm(), 1);
  EXPECT_TRUE(document.mm()->hasDataMask(MeshModel::MM_POLYGONAL));
  // Balls have colours, faces have those of their balls.
  EXPECT_TRUE(document.mm()->hasDataMask(MeshModel::MM_FACECOLOR));
  EXPECT_GT(document.mm()->cm.FN(), count);
}

TEST(Cluster, PutsOneBallInTheirPlace) {
  MeshDocument document;
  balls(document, {{0, 0, 0, 1}, {0.01, 0, 0, 1}, {7, 0, 0, 1}});
  auto result = host::apply(host::kCluster, document, {{"sphericity", 0.9}});
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_TRUE(result.logged("3 balls in 2 clusters, 1 of them of one ball"));
  ASSERT_TRUE(document.mm()->hasDataMask(MeshModel::MM_VERTRADIUS | MeshModel::MM_VERTCOLOR));
  ASSERT_EQ(document.mm()->cm.VN(), 2);
  EXPECT_EQ(document.mm()->label(), "balls clusters");
  for (const auto &v : document.mm()->cm.vert) EXPECT_NEAR(v.cR(), v.cP()[0] > 1 ? 1 : 1.005, 1e-6);

  document.setCurrentMesh(0);
  result = host::apply(host::kCluster, document, {{"count", 1}});
  ASSERT_TRUE(result.ok) << result.error;
  ASSERT_EQ(document.mm()->cm.VN(), 1);
  EXPECT_NEAR(document.mm()->cm.vert[0].cR(), 4.5, 1e-5);

  document.setCurrentMesh(0);
  result = host::apply(host::kCluster, document, {{"sphericity", 0.01}}); // the range's end
  EXPECT_TRUE(result.ok) << result.error;
}

TEST(BallMeasures, AreThoseOfTwoBalls) {
  MeshDocument document;
  MeshModel *layer = balls(document, {{0, 0, 0, 1}, {1, 0, 0, 1}, {0.2, 0, 0, 0.1}});
  auto result = host::apply(host::kBallMeasures, document);
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_TRUE(result.logged("Union of 3 balls: volume 7.06858, area 18.8496."));
  EXPECT_TRUE(result.logged("1 ball has no share"));
  EXPECT_NEAR(layer->cm.vert[0].cQ(), 9 * kPi / 8, 1e-5);
  EXPECT_NEAR(layer->cm.vert[1].cQ(), 9 * kPi / 8, 1e-5);
  EXPECT_EQ(layer->cm.vert[2].cQ(), 0);
  EXPECT_FALSE(layer->hasDataMask(MeshModel::MM_VERTCOLOR));
  EXPECT_NEAR(layer->cm.vert[0].cR(), 1, 1e-6);
#if VBM_MESHLAB_GENERATION > 2020
  EXPECT_NEAR(result.measures.at("volume"), 9 * kPi / 4, 1e-6);
  EXPECT_NEAR(result.measures.at("area"), 6 * kPi, 1e-6);
#endif
  result = host::apply(host::kBallMeasures, document, {{"share", 1}});
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_NEAR(layer->cm.vert[0].cQ(), 3 * kPi, 1e-5);
}

TEST(BallFilters, RefuseWhatIsNoBalls) {
  for (const char *filter : {host::kBallSurface, host::kCluster, host::kBallMeasures}) {
    {
      MeshDocument document;
      shapes::sphere(document, 2);
      const auto result = host::apply(filter, document);
      EXPECT_FALSE(result.ok);
      EXPECT_NE(result.error.find("have no radius"), std::string::npos) << result.error;
      EXPECT_TRUE(result.logged(result.error));
      EXPECT_EQ(host::layers(document), 1);
    }
    {
      MeshDocument document;
      balls(document, {});
      const auto result = host::apply(filter, document);
      EXPECT_FALSE(result.ok);
      EXPECT_NE(result.error.find("no vertices"), std::string::npos) << result.error;
    }
    for (const double bad : {-1.0, double(std::numeric_limits<float>::quiet_NaN())}) {
      MeshDocument document;
      balls(document, {{0, 0, 0, 1}, {0, 0, 1, 1}, {0, 0, 2, bad}});
      const auto result = host::apply(filter, document);
      EXPECT_FALSE(result.ok) << filter << bad;
      EXPECT_NE(result.error.find("2"), std::string::npos) << result.error;
      EXPECT_EQ(host::layers(document), 1);
    }
  }
}

} // namespace
