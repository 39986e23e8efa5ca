// SPDX-License-Identifier: GPL-3.0-or-later
// What the filters leave in the document, on shapes whose balls are known.
#include "shapes.h"

#include <gtest/gtest.h>
#include <vbm/vbm.hpp>

#include <cmath>
#include <set>

namespace {

// The vertices of these shapes lie on smooth surfaces; samples on their flat faces would not.
const host::Given vertices_only = {{"spacing", -1}};

host::Given with(host::Given given, const char *name, double value) {
  given[name] = value;
  return given;
}

void expect_progress(const host::Result &result) {
  ASSERT_GE(result.percents.size(), 3u);
  for (std::size_t i = 0; i < result.percents.size(); ++i) {
    EXPECT_GE(result.percents[i], i ? result.percents[i - 1] + 1 : 0);
    EXPECT_FALSE(result.stages[i].empty());
  }
  EXPECT_GE(result.percents.back(), 90);
  EXPECT_LE(result.percents.back(), 100);
}

void expect_closed(const shapes::Check &check, int genus, int components = 1) {
  EXPECT_EQ(check.border_edges, 0);
  EXPECT_EQ(check.bad_edges, 0);
  EXPECT_EQ(check.bad_vertices, 0);
  EXPECT_EQ(check.holes, 0);
  EXPECT_EQ(check.components, components);
  EXPECT_EQ(check.genus, genus);
  EXPECT_TRUE(check.oriented);
}

TEST(BallModel, IsALayerOfBallsOnTheMedialAxis) {
  MeshDocument document;
  // Of a torus, the medial axis is the circle within the tube.
  MeshModel *source = shapes::torus(document, 3, 1);
  const auto result = host::apply(host::kBalls, document, vertices_only);
  ASSERT_TRUE(result.ok) << result.error;
  expect_progress(result);
  EXPECT_TRUE(result.logged("inner balls"));
  EXPECT_TRUE(result.logged("inside told from outside by"));
  ASSERT_EQ(host::layers(document), 2);
  MeshModel *balls = document.mm();
  ASSERT_NE(balls, source);
  EXPECT_EQ(balls->label(), "torus balls");
  EXPECT_EQ(source->cm.VN(), 96 * 48);
  EXPECT_EQ(balls->cm.FN(), 0);
  EXPECT_GT(balls->cm.VN(), 96);
  ASSERT_TRUE(balls->hasDataMask(MeshModel::MM_VERTRADIUS | MeshModel::MM_VERTQUALITY |
                                 MeshModel::MM_VERTCOLOR));
  for (const auto &ball : balls->cm.vert) {
    const double axis = std::hypot(std::hypot(ball.cP()[0], ball.cP()[1]) - 3, ball.cP()[2]);
    EXPECT_NEAR(axis, 0, 0.05);
    EXPECT_NEAR(ball.cR(), 1, 0.05);
    EXPECT_EQ(float(ball.cR()), float(ball.cQ()));
  }
  EXPECT_NEAR(balls->cm.bbox.DimX(), 6, 0.1);
}

TEST(BallModel, ColoursRunFromSmallToLarge) {
  MeshDocument document;
  // Two spheres, one twice as large.
  MeshModel *model = shapes::sphere(document, 1);
  MeshModel *other = shapes::sphere(document, 2);
  for (auto &vertex : other->cm.vert) vertex.P()[0] += 5;
  vcg::tri::Append<CMeshO, CMeshO>::Mesh(model->cm, other->cm);
  shapes::finish(*model);
  document.setCurrentMesh(model->id());
  const auto result = host::apply(host::kBalls, document, vertices_only);
  ASSERT_TRUE(result.ok) << result.error;
  int small = 0, large = 0;
  for (const auto &ball : document.mm()->cm.vert) {
    const auto color = ball.cC();
    if (ball.cP()[0] < 1.5) {
      ++small;
      EXPECT_GT(color[0], 200);
      EXPECT_LT(color[2], 50);
    } else {
      ++large;
      EXPECT_LT(color[0], 50);
      EXPECT_GT(color[2], 200);
    }
  }
  EXPECT_GT(small, 0);
  EXPECT_GT(large, 0);
}

TEST(BallModel, CanHaveOuterBallsAndAllVoronoiBalls) {
  MeshDocument document;
  MeshModel *source = shapes::torus(document, 3, 1);
  const auto count = [&](const host::Given &given) {
    document.setCurrentMesh(source->id());
    const auto result = host::apply(host::kBalls, document, given);
    EXPECT_TRUE(result.ok) << result.error;
    return document.mm()->cm.VN();
  };
  const int inner = count({});
  EXPECT_GT(count({{"outer", 1}}), inner);
  EXPECT_GT(count({{"balls", 1}}), inner);
  EXPECT_EQ(host::layers(document), 4);
}

TEST(ClosedSurface, OfAMeshGoesThroughItsVertices) {
  MeshDocument document;
  MeshModel *source = shapes::torus(document, 3, 1);
  const auto result = host::apply(host::kSurface, document, vertices_only);
  ASSERT_TRUE(result.ok) << result.error;
  expect_progress(result);
  EXPECT_TRUE(result.logged("genus 1"));
  ASSERT_EQ(host::layers(document), 2);
  MeshModel *surface = document.mm();
  EXPECT_EQ(surface->label(), "torus surface");
  const auto check = shapes::check(*surface);
  expect_closed(check, 1);
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(check.volume, 2 * pi * pi * 3, 0.6);
  std::set<std::vector<float>> places;
  for (const auto &v : source->cm.vert) places.insert({v.cP()[0], v.cP()[1], v.cP()[2]});
  for (const auto &v : surface->cm.vert) {
    EXPECT_EQ(places.count({v.cP()[0], v.cP()[1], v.cP()[2]}), 1u);
    EXPECT_NEAR(v.cR(), 1, 0.05);
    EXPECT_NEAR(v.cQ(), 1, 0.05);
    EXPECT_NEAR(v.cN().Norm(), 1, 1e-3);
  }
}

TEST(ClosedSurface, OfAMeshWithSamplesOnItsFaces) {
  MeshDocument document;
  shapes::torus(document, 3, 1);
  const auto result = host::apply(host::kSurface, document, {{"spacing", 0.05}});
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_TRUE(result.logged("samples on faces at a spacing of 0.05"));
  expect_closed(shapes::check(*document.mm()), 1);
  EXPECT_GT(document.mm()->cm.VN(), 2 * 96 * 48);
}

// A lens: its rim is too sharp for its samples.
MeshModel *lens(MeshDocument &document) {
  MeshModel *model = shapes::sphere(document, 2);
  for (auto &vertex : model->cm.vert) vertex.P()[2] *= 0.05f;
  shapes::finish(*model);
  return model;
}

int selected(const MeshModel &model) {
  int count = 0;
  for (const auto &vertex : model.cm.vert) count += vertex.IsS();
  return count;
}

// The library's undersampled vertices of a layer whose vertices alone are samples, by their places.
std::set<std::vector<float>> undersampled(const MeshModel &layer) {
  std::vector<double> points;
  std::vector<std::int32_t> triangles;
  for (const auto &v : layer.cm.vert)
    for (int k = 0; k < 3; ++k) points.push_back(v.cP()[k]);
  for (const auto &face : layer.cm.face)
    for (int k = 0; k < 3; ++k)
      triangles.push_back(std::int32_t(vcg::tri::Index(layer.cm, face.cV(k))));
  vbm::Context context;
  vbm::BuildOptions options;
  options.spacing = -1;
  const vbm::View<double, 3> given{points.data(), points.size() / 3};
  const vbm::View<std::int32_t, 3> faces{triangles.data(), triangles.size() / 3};
  const vbm::Model model = triangles.empty() ? vbm::build_points(context, given, {}, options)
                                             : vbm::build_mesh(context, given, faces, options);
  std::set<std::vector<float>> places;
  for (std::int32_t sample : model.undersampled()) {
    const auto &p = layer.cm.vert[std::size_t(model.sample_input()[sample])].cP();
    places.insert({p[0], p[1], p[2]});
  }
  return places;
}

TEST(ClosedSurface, SelectsWhereTheSamplingIsTooThin) {
  for (const bool points : {false, true}) {
    MeshDocument document;
    MeshModel *source = lens(document);
    if (points) shapes::forget_faces(*source);
    source->cm.vert[0].SetS();
    auto result = host::apply(host::kSurface, document, {{"spacing", -1}, {"select", 0}});
    ASSERT_TRUE(result.ok) << result.error;
    ASSERT_TRUE(result.logged("too thin to trust"));
    EXPECT_EQ(selected(*source), 1);
    EXPECT_EQ(selected(*document.mm()), 0);

    document.setCurrentMesh(source->id());
    result = host::apply(host::kSurface, document, {{"spacing", -1}});
    ASSERT_TRUE(result.ok) << result.error;
    const auto expected = undersampled(*source);
    const int chosen = selected(*source);
    EXPECT_GT(chosen, 10);
    EXPECT_LT(chosen, source->cm.VN());
    EXPECT_TRUE(
        result.logged(std::to_string(chosen) + " vertices are selected where it is too thin"));
    for (const auto &v : source->cm.vert)
      EXPECT_EQ(v.IsS(), expected.count({v.cP()[0], v.cP()[1], v.cP()[2]}) == 1);
    EXPECT_GT(selected(*document.mm()), 10);
    for (const auto &v : document.mm()->cm.vert)
      EXPECT_EQ(v.IsS(), expected.count({v.cP()[0], v.cP()[1], v.cP()[2]}) == 1);
  }
}

TEST(ClosedSurface, SelectsTheVertexNearestToAnAddedSample) {
  MeshDocument document;
  // A needle of few vertices: most samples are added.
  MeshModel *source = shapes::sphere(document, 2);
  for (auto &vertex : source->cm.vert)
    for (int k = 0; k < 2; ++k) vertex.P()[k] *= 0.02f;
  shapes::finish(*source);
  // A vertex that is left out, right beside others, is none of them.
  source->cm.vert[0].SetS();
  const auto result = host::apply(host::kSurface, document, {{"spacing", 0.02}, {"refine", 0}});
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_TRUE(result.logged("samples on faces"));
  ASSERT_TRUE(result.logged("too thin to trust"));
  EXPECT_GT(selected(*source), 1);
  EXPECT_TRUE(result.logged(std::to_string(selected(*source)) + " vert"));
}

TEST(ClosedSurface, LeavesTheSelectionWhereSamplingIsDense) {
  MeshDocument document;
  MeshModel *source = shapes::torus(document, 3, 1);
  source->cm.vert[7].SetS();
  const auto result = host::apply(host::kSurface, document, vertices_only);
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_EQ(selected(*source), 1);
  EXPECT_TRUE(source->cm.vert[7].IsS());
  EXPECT_EQ(selected(*document.mm()), 0);
}

TEST(ClosedSurface, OfBarePointsAndOfAnOpenMesh) {
  for (const bool open_mesh : {false, true}) {
    MeshDocument document;
    MeshModel *source = shapes::sphere(document, 2);
    if (open_mesh) { // a hole at the top; the faces would leave it, the bare points do not know it
      for (auto &face : source->cm.face)
        if (vcg::Barycenter(face)[2] > 1.97)
          vcg::tri::Allocator<CMeshO>::DeleteFace(source->cm, face);
      ASSERT_LT(source->cm.FN(), int(source->cm.face.size()));
    } else {
      shapes::forget_faces(*source);
      ASSERT_EQ(source->cm.FN(), 0);
    }
    const auto result =
        host::apply(host::kSurface, document, {{"ignore_faces", open_mesh ? 1 : 0}});
    ASSERT_TRUE(result.ok) << result.error;
    const auto check = shapes::check(*document.mm());
    expect_closed(check, 0);
    EXPECT_EQ(check.vertices, 2562);
    EXPECT_EQ(check.faces, 2 * 2562 - 4);
    EXPECT_GT(check.volume, 33);
  }
}

TEST(ClosedSurface, PowerCrustInTrianglesAndPolygons) {
  MeshDocument document;
  MeshModel *source = shapes::torus(document, 3, 1);
  auto result = host::apply(host::kSurface, document, {{"method", 1}});
  ASSERT_TRUE(result.ok) << result.error;
  expect_progress(result);
  MeshModel *crust = document.mm();
  EXPECT_EQ(crust->label(), "torus power crust");
  expect_closed(shapes::check(*crust), 1);
  for (const auto &v : crust->cm.vert) EXPECT_NEAR(v.cN().Norm(), 1, 1e-3);
  EXPECT_FALSE(crust->hasDataMask(MeshModel::MM_POLYGONAL));

  document.setCurrentMesh(source->id());
  result = host::apply(host::kSurface, document, {{"method", 1}, {"polygons", 1}});
  ASSERT_TRUE(result.ok) << result.error;
  MeshModel *polygons = document.mm();
  ASSERT_TRUE(polygons->hasDataMask(MeshModel::MM_POLYGONAL));
  expect_closed(shapes::check(*polygons), 1);
  EXPECT_EQ(polygons->cm.FN(), crust->cm.FN());
  int hidden = 0;
  for (auto &face : polygons->cm.face)
    for (int k = 0; k < 3; ++k)
      if (face.IsF(k)) {
        ++hidden;
        // Both sides of a hidden edge say so.
        EXPECT_TRUE(face.FFp(k)->IsF(face.FFi(k)));
      }
  EXPECT_GT(hidden, 0);
}

TEST(ClosedSurface, KeepsColours) {
  for (const int method : {0, 1}) {
    MeshDocument document;
    MeshModel *source = shapes::sphere(document, 2);
    source->updateDataMask(MeshModel::MM_VERTCOLOR);
    for (auto &v : source->cm.vert)
      v.C() = v.cP()[2] > 0 ? vcg::Color4b(200, 10, 20, 255) : vcg::Color4b(10, 20, 200, 255);
    const auto result = host::apply(host::kSurface, document, {{"method", double(method)}});
    ASSERT_TRUE(result.ok) << result.error;
    MeshModel *surface = document.mm();
    ASSERT_TRUE(surface->hasDataMask(MeshModel::MM_VERTCOLOR));
    for (const auto &v : surface->cm.vert) {
      if (v.cP()[2] > 0.3) {
        EXPECT_EQ(v.cC(), vcg::Color4b(200, 10, 20, 255));
      } else if (v.cP()[2] < -0.3) {
        EXPECT_EQ(v.cC(), vcg::Color4b(10, 20, 200, 255));
      }
    }
  }
}

TEST(Thickness, IsWrittenToTheLayerItself) {
  MeshDocument document;
  MeshModel *source = shapes::torus(document, 3, 1);
  // Used by no face: it has no thickness.
  vcg::tri::Allocator<CMeshO>::AddVertex(source->cm, Point3m(9, 9, 9));
  const auto result = host::apply(host::kThickness, document, vertices_only);
  ASSERT_TRUE(result.ok) << result.error;
  expect_progress(result);
  EXPECT_EQ(host::layers(document), 1);
  ASSERT_TRUE(source->hasDataMask(MeshModel::MM_VERTRADIUS | MeshModel::MM_VERTQUALITY |
                                  MeshModel::MM_VERTCOLOR));
  EXPECT_EQ(source->cm.VN(), 96 * 48 + 1);
  for (int i = 0; i < 96 * 48; ++i) {
    EXPECT_NEAR(source->cm.vert[i].cQ(), 2, 0.05);
    EXPECT_NEAR(source->cm.vert[i].cR(), 1, 0.025);
  }
  EXPECT_EQ(source->cm.vert.back().cQ(), 0);
  EXPECT_EQ(source->cm.vert.back().cR(), 0);
  EXPECT_EQ(source->cm.vert.back().cC(), vcg::Color4b(vcg::Color4b::Gray));
  EXPECT_TRUE(result.logged("1 vertex has no such ball"));
  EXPECT_TRUE(result.logged("Quality from "));
}

TEST(Thickness, MeasuresGapsAndCanLeaveColoursAlone) {
  MeshDocument document;
  MeshModel *source = shapes::torus(document, 3, 1);
  auto result = host::apply(host::kThickness, document,
                            with(with(vertices_only, "measure", 1), "colorize", 0));
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_FALSE(source->hasDataMask(MeshModel::MM_VERTCOLOR));
  // Across the hole, at the innermost circle, the largest empty ball has radius 2.
  int inmost = 0;
  for (const auto &v : source->cm.vert)
    if (std::hypot(v.cP()[0], v.cP()[1]) < 2.001) {
      ++inmost;
      EXPECT_NEAR(v.cQ(), 4, 0.1);
    }
  EXPECT_GT(inmost, 0);
  result = host::apply(host::kThickness, document,
                       with(with(vertices_only, "measure", 2), "colorize", 0));
  ASSERT_TRUE(result.ok) << result.error;
  for (const auto &v : source->cm.vert) EXPECT_NEAR(v.cQ(), 1, 0.05);
}

TEST(Filters, LeaveOutDeletedElements) {
  MeshDocument document;
  MeshModel *source = shapes::sphere(document, 2);
  // A vertex far off, deleted, first in the list; and a face across the sphere, deleted too.
  CMeshO &mesh = source->cm;
  vcg::tri::Allocator<CMeshO>::AddVertex(mesh, Point3m(50, 0, 0));
  const std::size_t last = mesh.vert.size() - 1;
  for (auto &face : mesh.face)
    for (int k = 0; k < 3; ++k)
      if (face.V(k) == &mesh.vert[0]) face.V(k) = &mesh.vert[last];
  std::swap(mesh.vert[0].P(), mesh.vert[last].P());
  vcg::tri::Allocator<CMeshO>::AddFace(mesh, &mesh.vert[5], &mesh.vert[700], &mesh.vert[1900]);
  vcg::tri::Allocator<CMeshO>::DeleteFace(mesh, mesh.face.back());
  vcg::tri::Allocator<CMeshO>::DeleteVertex(mesh, mesh.vert[0]);
  mesh.vert[0].Q() = 77;

  auto result = host::apply(host::kThickness, document, vertices_only);
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_FALSE(result.logged("the mesh is open")) << "by a face that is not there";
  EXPECT_EQ(mesh.vert[0].cQ(), 77);
  for (std::size_t i = 1; i < mesh.vert.size(); ++i) EXPECT_NEAR(mesh.vert[i].cQ(), 4, 0.05);
  result = host::apply(host::kSurface, document, vertices_only);
  ASSERT_TRUE(result.ok) << result.error;
  expect_closed(shapes::check(*document.mm()), 0);
  EXPECT_EQ(document.mm()->cm.VN(), 2562);
}

TEST(Filters, KeepTheLayersMatrix) {
  for (const char *filter : {host::kBalls, host::kSurface}) {
    MeshDocument document;
    MeshModel *source = shapes::sphere(document, 2);
    source->cm.Tr.SetTranslate(10, 20, 30);
    const Matrix44m matrix = source->cm.Tr;
    const auto result = host::apply(filter, document);
    ASSERT_TRUE(result.ok) << result.error;
    EXPECT_TRUE(document.mm()->cm.Tr == matrix);
    EXPECT_LT(document.mm()->cm.bbox.Center().Norm(), 0.1);
    EXPECT_TRUE(result.logged("matrix"));
  }
}

TEST(Filters, HideTheLayerThatWouldCoverTheNewOne) {
  MeshDocument document;
  MeshModel *source = shapes::sphere(document, 2);
  ASSERT_TRUE(host::apply(host::kThickness, document, {{"spacing", -1}}).ok);
  EXPECT_TRUE(source->isVisible());
  for (const char *filter : {host::kBalls, host::kSurface}) {
    document.setCurrentMesh(source->id());
    ASSERT_TRUE(host::apply(filter, document, {{"spacing", -1}, {"hide", 0}}).ok);
    EXPECT_TRUE(source->isVisible());
  }
  document.setCurrentMesh(source->id());
  ASSERT_TRUE(host::apply(host::kBalls, document, vertices_only).ok);
  EXPECT_FALSE(source->isVisible());
  EXPECT_TRUE(document.mm()->isVisible());
}

TEST(Filters, NameLayersWithoutDots) {
  MeshDocument document;
  MeshModel *source = shapes::sphere(document, 2); // "my.ball.ply"
  ASSERT_TRUE(host::apply(host::kSurface, document).ok);
  EXPECT_EQ(document.mm()->label(), "my_ball surface");
  document.setCurrentMesh(source->id());
  ASSERT_TRUE(host::apply(host::kSurface, document).ok);
  EXPECT_EQ(document.mm()->label(), "my_ball surface(1)");
}

TEST(Filters, WriteNumbersWithAPoint) {
  MeshDocument document;
  shapes::sphere(document, 2.25);
  const auto result = host::apply(host::kThickness, document, vertices_only);
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_TRUE(result.logged("Quality from 4.")) << "a sphere of thickness 4.5";
  for (const std::string &line : result.log) EXPECT_EQ(line.find("4,"), std::string::npos) << line;
}

} // namespace
