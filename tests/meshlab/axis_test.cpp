// SPDX-License-Identifier: GPL-3.0-or-later
// The filters of the medial axis, on shapes whose axes are known.
#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace {

constexpr double kSpacing = 0.1;

// How far inside the box of shapes::box() a point is.
double depth(const Point3m &p) {
  const double size[3] = {4, 2, 1};
  double least = 10;
  for (int a = 0; a < 3; ++a) least = std::min({least, double(p[a]), size[a] - p[a]});
  return least;
}

// Vertices - edges + triangles of what the layer holds.
int euler(const CMeshO &mesh) {
  std::set<std::pair<const CVertexO *, const CVertexO *>> edges;
  for (const auto &face : mesh.face)
    for (int k = 0; k < 3; ++k) edges.insert(std::minmax(face.cV(k), face.cV((k + 1) % 3)));
  return mesh.VN() - int(edges.size()) + mesh.FN();
}

// Faces by the part they say they are of.
std::map<int, int> parts(const CMeshO &mesh) {
  std::map<int, int> faces;
  for (const auto &face : mesh.face) ++faces[int(face.cQ())];
  return faces;
}

MeshModel *box_axis(MeshDocument &document) {
  shapes::box(document, kSpacing);
  const auto result = host::apply(host::kAxis, document);
  EXPECT_TRUE(result.ok) << result.error;
  return document.mm();
}

// The part of the sheet in the middle of the box; the outer ones lie around it.
int middle_part(const CMeshO &mesh) {
  for (const auto &face : mesh.face) {
    const Point3m center = (face.cP(0) + face.cP(1) + face.cP(2)) / 3;
    if ((center - Point3m(2, 1, 0.5f)).Norm() < 0.2) return int(face.cQ());
  }
  ADD_FAILURE() << "nothing in the middle";
  return -1;
}

void select(MeshModel &layer, int part, int most = 1) {
  for (auto &face : layer.cm.face)
    if (int(face.cQ()) == part && most-- > 0) face.SetS();
}

TEST(MedialAxis, OfABoxHasTwelveOuterPartsAndOneInner) {
  MeshDocument document;
  MeshModel *axis = box_axis(document);
  const CMeshO &mesh = axis->cm;
  EXPECT_EQ(axis->label(), "box axis");
  EXPECT_EQ(host::layers(document), 2);
  ASSERT_TRUE(axis->hasDataMask(MeshModel::MM_VERTRADIUS | MeshModel::MM_VERTQUALITY |
                                MeshModel::MM_FACECOLOR | MeshModel::MM_FACEQUALITY));
  EXPECT_GT(mesh.FN(), 500);
  EXPECT_EQ(euler(mesh), 1);
  for (const auto &ball : mesh.vert) {
    EXPECT_NEAR(ball.cR(), depth(ball.cP()), 0.03);
    EXPECT_EQ(float(ball.cR()), float(ball.cQ()));
  }
  const auto found = parts(mesh);
  EXPECT_EQ(found.size(), 13u);
  EXPECT_EQ(found.begin()->first, 0);
  EXPECT_EQ(found.rbegin()->first, 12);
  // A part has one colour, and no other part has it.
  std::map<int, std::set<unsigned>> colors;
  std::set<unsigned> all;
  for (const auto &face : mesh.face) {
    const auto c = face.cC();
    const unsigned color = c[0] << 16 | c[1] << 8 | c[2];
    colors[int(face.cQ())].insert(color);
    all.insert(color);
  }
  for (const auto &[part, own] : colors) EXPECT_EQ(own.size(), 1u) << part;
  EXPECT_EQ(all.size(), 13u);
}

TEST(MedialAxis, OfAPaddleShowsItsStickInAColourOfItsOwn) {
  MeshDocument document;
  shapes::paddle(document);
  const auto result = host::apply(host::kAxis, document);
  ASSERT_TRUE(result.ok) << result.error;
  const CMeshO &mesh = document.mm()->cm;
  ASSERT_GT(mesh.FN(), 100);
  ASSERT_TRUE(document.mm()->hasDataMask(MeshModel::MM_VERTCOLOR | MeshModel::MM_FACECOLOR));
  const auto number = [](const vcg::Color4b &c) { return unsigned(c[0] << 16 | c[1] << 8 | c[2]); };
  std::set<const CVertexO *> sheets;
  std::set<unsigned> of_sheets, of_stick;
  for (const auto &face : mesh.face) {
    of_sheets.insert(number(face.cC()));
    for (int k = 0; k < 3; ++k) sheets.insert(face.cV(k));
  }
  int balls = 0;
  for (const auto &vertex : mesh.vert) {
    if (vertex.cP()[0] < 1.5) continue;
    ++balls;
    EXPECT_FALSE(sheets.count(&vertex));
    of_stick.insert(number(vertex.cC()));
  }
  EXPECT_GT(balls, 20);
  ASSERT_EQ(of_stick.size(), 1u);
  EXPECT_FALSE(of_sheets.count(*of_stick.begin()));
  // Where sheets are, vertices have the colour of one of their faces.
  std::map<const CVertexO *, std::set<unsigned>> at;
  for (const auto &face : mesh.face)
    for (int k = 0; k < 3; ++k) at[face.cV(k)].insert(number(face.cC()));
  std::size_t like_faces = 0;
  for (const auto &[vertex, colors] : at) like_faces += colors.count(number(vertex->cC()));
  EXPECT_GE(like_faces + 1, at.size()) << "all but where the stick begins";
}

TEST(MedialAxis, HasSheetsThatFaceOneWay) {
  MeshDocument document;
  const CMeshO &mesh = box_axis(document)->cm;
  std::map<std::pair<const CVertexO *, const CVertexO *>, int> forth;
  std::map<std::pair<const CVertexO *, const CVertexO *>, int> faces;
  double up = 0;
  for (const auto &face : mesh.face) {
    for (int k = 0; k < 3; ++k) {
      const auto *a = face.cV(k), *b = face.cV((k + 1) % 3);
      ++forth[{a, b}];
      ++faces[std::minmax(a, b)];
    }
    up += ((face.cP(1) - face.cP(0)) ^ (face.cP(2) - face.cP(0)))[2];
  }
  int inner = 0;
  for (const auto &[edge, count] : faces)
    if (count == 2) {
      ++inner;
      EXPECT_EQ(forth[edge], 1);
    }
  EXPECT_GT(inner, 500);
  // Twice the inner rectangle of 3 by 1, or more.
  EXPECT_GT(up, 5) << "to where MeshLab looks from";
}

TEST(MedialAxis, SaysWhatItIs) {
  MeshDocument document;
  MeshModel *source = shapes::box(document, kSpacing);
  const auto result = host::apply(host::kAxis, document);
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_TRUE(result.logged("13 parts: 12 of level 1, 1 of level 2."));
  EXPECT_TRUE(result.logged("1 part cannot be removed now: it has no border"));
  EXPECT_TRUE(result.logged("1 component, Euler characteristic 1"));
  EXPECT_FALSE(source->isVisible());
}

TEST(Simplify, TakesAHornOffAndKeepsTheRest) {
  MeshDocument document;
  MeshModel *source = shapes::horned_sphere(document);
  const auto simplified = [&](host::Given given) {
    document.setCurrentMesh(source->id());
    given["spacing"] = -1;
    const auto result = host::apply(host::kSimplify, document, given);
    EXPECT_TRUE(result.ok) << result.error;
    EXPECT_EQ(document.mm()->label().left(17).toStdString(), "horned simplified");
    const auto check = shapes::check(*document.mm());
    EXPECT_EQ(check.border_edges + check.bad_edges + check.holes + check.genus, 0);
    EXPECT_EQ(check.components, 1);
    EXPECT_TRUE(check.oriented);
    return check.volume;
  };
  const double whole = simplified({{"triangle_iterations", 0}, {"iterations", 0}});
  EXPECT_NEAR(document.mm()->cm.bbox.max[2], 3.5, 0.01);
  const double rest = simplified({{"measure", 1}, {"threshold", 0.2}, {"iterations", 40}});
  EXPECT_LT(document.mm()->cm.bbox.max[2], 2.5);
  EXPECT_NEAR(document.mm()->cm.bbox.min[2], -2, 0.05);
  EXPECT_LT(rest, whole);
  EXPECT_GT(rest, 0.9 * whole);
}

TEST(Simplify, GivesTheAxisThatIsLeftToo) {
  MeshDocument document;
  MeshModel *source = shapes::box(document, kSpacing);
  auto result = host::apply(host::kSimplify, document,
                            {{"triangle_iterations", 0}, {"iterations", 0}, {"axis", 1}});
  ASSERT_TRUE(result.ok) << result.error;
  ASSERT_EQ(host::layers(document), 3);
  EXPECT_EQ(document.mm()->label(), "box simplified") << "the surface is the last one added";
  MeshModel *axis = document.getMesh(document.mm()->id() - 1);
  ASSERT_EQ(axis->label(), "box axis");
  EXPECT_EQ(parts(axis->cm).size(), 13u);

  document.setCurrentMesh(source->id());
  result = host::apply(host::kSimplify, document,
                       {{"measure", 1}, {"threshold", 0.9}, {"iterations", 1}, {"axis", 1}});
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_TRUE(result.logged("Pruned by volume up to 0.9, 1 time: "));
  axis = document.getMesh(document.mm()->id() - 1);
  EXPECT_LT(parts(axis->cm).size(), 13u);
  EXPECT_EQ(euler(axis->cm), 1);
  // Its parts can be removed as well.
  document.setCurrentMesh(axis->id());
  axis->cm.face[0].SetS();
  result = host::apply(host::kRemoveParts, document);
  EXPECT_TRUE(result.ok || result.error.find("Part ") == 0) << result.error;
}

TEST(Simplify, KeepsATunnelWhateverTheThreshold) {
  MeshDocument document;
  shapes::torus(document, 3, 1);
  const auto result = host::apply(
      host::kSimplify, document,
      {{"spacing", -1}, {"triangle_threshold", 1e9}, {"threshold", 1}, {"iterations", 3}});
  ASSERT_TRUE(result.ok) << result.error;
  const auto check = shapes::check(*document.mm());
  EXPECT_EQ(check.border_edges + check.bad_edges + check.holes, 0);
  EXPECT_EQ(check.genus, 1);
  EXPECT_EQ(check.components, 1);
}

TEST(Simplify, KeepsColours) {
  MeshDocument document;
  MeshModel *source = shapes::sphere(document, 2);
  source->updateDataMask(MeshModel::MM_VERTCOLOR);
  for (auto &v : source->cm.vert)
    v.C() = v.cP()[2] > 0 ? vcg::Color4b(200, 10, 20, 255) : vcg::Color4b(10, 20, 200, 255);
  const auto expect_colors = [](const CMeshO &mesh) {
    int above = 0;
    for (const auto &v : mesh.vert)
      if (v.cP()[2] > 0.5) {
        ++above;
        EXPECT_EQ(v.cC(), vcg::Color4b(200, 10, 20, 255));
      }
    EXPECT_GT(above, 100);
  };
  const auto result = host::apply(host::kSimplify, document, {{"spacing", -1}});
  ASSERT_TRUE(result.ok) << result.error;
  expect_colors(document.mm()->cm);
}

TEST(RemoveParts, TakesThePartOfASelectedFace) {
  MeshDocument document;
  MeshModel *axis = box_axis(document);
  const auto before = parts(axis->cm);
  const int middle = middle_part(axis->cm), chosen = middle == 0 ? 1 : 0;
  select(*axis, chosen);
  const auto result = host::apply(host::kRemoveParts, document);
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_TRUE(result.logged("1 part removed."));
  ASSERT_EQ(host::layers(document), 4);
  MeshModel *rest = document.mm();
  EXPECT_EQ(rest->label(), "box axis(1)");
  EXPECT_EQ(rest->cm.FN(), axis->cm.FN() - before.at(chosen));
  EXPECT_EQ(euler(rest->cm), 1);
  EXPECT_FALSE(axis->isVisible());
  MeshModel *surface = document.getMesh(rest->id() - 1);
  EXPECT_EQ(surface->label(), "box simplified");
  const auto check = shapes::check(*surface);
  EXPECT_EQ(check.border_edges + check.bad_edges + check.holes + check.genus, 0);
  EXPECT_NEAR(check.volume, 8, 0.3);

  // And on, from the layer this left; and back, from the one before.
  const auto now = parts(rest->cm);
  select(*rest,
         now.begin()->first == middle_part(rest->cm) ? now.rbegin()->first : now.begin()->first);
  ASSERT_TRUE(host::apply(host::kRemoveParts, document, {{"surface", 0}}).ok);
  EXPECT_EQ(host::layers(document), 5);
  EXPECT_LT(document.mm()->cm.FN(), rest->cm.FN());
  document.setCurrentMesh(axis->id());
  for (auto &face : axis->cm.face) face.ClearS();
  select(*axis, middle == 2 ? 3 : 2);
  ASSERT_TRUE(host::apply(host::kRemoveParts, document, {{"surface", 0}}).ok);
  EXPECT_EQ(parts(axis->cm), before);
}

TEST(RemoveParts, TakesTheHornOfASphereOff) {
  MeshDocument document;
  shapes::horned_sphere(document);
  ASSERT_TRUE(
      host::apply(host::kSimplify, document, {{"spacing", -1}, {"threshold", 0.0005}, {"axis", 1}})
          .ok);
  EXPECT_NEAR(document.mm()->cm.bbox.max[2], 3.5, 0.2);
  MeshModel *axis = document.getMesh(document.mm()->id() - 1);
  document.setCurrentMesh(axis->id());
  for (auto &face : axis->cm.face)
    if (face.cP(0)[2] > 1) face.SetS();
  for (auto &vertex : axis->cm.vert)
    if (vertex.cP()[2] > 1) vertex.SetS();
  const auto result = host::apply(host::kRemoveParts, document);
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_LT(document.getMesh(document.mm()->id() - 1)->cm.bbox.max[2], 2.6);
}

TEST(RemoveParts, TakesWhatHasABorderOnlyThen) {
  MeshDocument document;
  MeshModel *axis = box_axis(document);
  // All but one outer part, and the inner one, which has no border until the first are gone.
  const int middle = middle_part(axis->cm), stays = middle == 0 ? 1 : 0;
  for (auto &face : axis->cm.face)
    if (int(face.cQ()) != stays) face.SetS();
  const auto result = host::apply(host::kRemoveParts, document);
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_EQ(euler(document.mm()->cm), 1);
  EXPECT_EQ(document.mm()->cm.FN(), parts(axis->cm).at(stays)) << "what was not selected is left";
  EXPECT_TRUE(result.logged("12 parts removed."));
}

TEST(RemoveParts, SaysWhyAPartStays) {
  {
    MeshDocument document;
    MeshModel *axis = box_axis(document);
    const int middle = middle_part(axis->cm);
    select(*axis, middle);
    auto result = host::apply(host::kRemoveParts, document);
    EXPECT_FALSE(result.ok);
    EXPECT_EQ(result.error, "Part " + std::to_string(middle) +
                                " stays: it has no border, so the parts around it must go first.");
    EXPECT_EQ(host::layers(document), 2);
    // The whole axis cannot go.
    for (auto &face : axis->cm.face) face.SetS();
    result = host::apply(host::kRemoveParts, document);
    ASSERT_TRUE(result.ok) << result.error;
    EXPECT_TRUE(result.logged("all that is left of a piece of the shape"));
    EXPECT_EQ(euler(document.mm()->cm), 1);
  }
  { // Nor what holds a tunnel.
    MeshDocument document;
    shapes::torus(document, 3, 1);
    ASSERT_TRUE(host::apply(host::kAxis, document, {{"spacing", -1}}).ok);
    MeshModel *axis = document.mm();
    for (auto &face : axis->cm.face) face.SetS();
    for (auto &vertex : axis->cm.vert) vertex.SetS();
    const auto result = host::apply(host::kRemoveParts, document);
    ASSERT_TRUE(result.ok) << result.error;
    EXPECT_TRUE(result.logged("stays: a tunnel or cavity of the shape would be lost."));
    EXPECT_EQ(euler(document.mm()->cm), 0);
  }
}

TEST(RemoveParts, NeedsASelectionInALayerOfItsOwn) {
  MeshDocument document;
  MeshModel *axis = box_axis(document);
  auto result = host::apply(host::kRemoveParts, document);
  EXPECT_FALSE(result.ok);
  EXPECT_NE(result.error.find("Nothing is selected"), std::string::npos) << result.error;

  // A copy of the layer is as good.
  MeshModel *copy = host::add_layer(document, "copy");
  copy->updateDataMask(axis);
  vcg::tri::Append<CMeshO, CMeshO>::MeshCopy(copy->cm, axis->cm);
  select(*copy, middle_part(axis->cm) == 0 ? 1 : 0);
  document.setCurrentMesh(copy->id());
  result = host::apply(host::kRemoveParts, document, {{"surface", 0}});
  EXPECT_TRUE(result.ok) << result.error;

  // One that was edited is not.
  document.setCurrentMesh(copy->id());
  vcg::tri::Allocator<CMeshO>::DeleteFace(copy->cm, copy->cm.face[10]);
  result = host::apply(host::kRemoveParts, document);
  EXPECT_FALSE(result.ok);
  EXPECT_NE(result.error.find("apply \"Build Medial Axis\""), std::string::npos) << result.error;
  EXPECT_TRUE(result.logged(result.error));
  copy->cm.vert[5].P()[0] += 0.01f;
  EXPECT_FALSE(host::apply(host::kRemoveParts, document).ok);

  MeshModel *other = shapes::sphere(document, 2);
  for (auto &face : other->cm.face) face.SetS();
  result = host::apply(host::kRemoveParts, document);
  EXPECT_FALSE(result.ok);
  EXPECT_NE(result.error.find("not a medial axis"), std::string::npos) << result.error;
}

TEST(PartColor, GivesVerticesThePartThatTouchesThem) {
  MeshDocument document;
  MeshModel *source = shapes::box(document, kSpacing);
  const host::Given whole = {{"triangle_iterations", 0}, {"iterations", 0}};
  const auto result = host::apply(host::kPartColor, document, whole);
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_EQ(host::layers(document), 1);
  ASSERT_TRUE(source->hasDataMask(MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY));
  EXPECT_FALSE(source->hasDataMask(MeshModel::MM_VERTRADIUS));
  ASSERT_TRUE(host::apply(host::kAxis, document).ok);
  const CMeshO &axis = document.mm()->cm;

  // The part has a ball that touches the vertex, and the vertex has its colour.
  int touched = 0;
  for (const auto &v : source->cm.vert) {
    double nearest = 10;
    for (const auto &face : axis.face) {
      if (int(face.cQ()) != int(v.cQ())) continue;
      EXPECT_EQ(face.cC(), v.cC());
      for (int k = 0; k < 3; ++k)
        nearest =
            std::min(nearest, std::abs(double((face.cP(k) - v.cP()).Norm()) - face.cV(k)->cR()));
    }
    touched += nearest < kSpacing;
  }
  EXPECT_GT(touched, 0.98 * source->cm.VN());
}

TEST(PartColor, OfPrunedPartsGoesToTheRest) {
  MeshDocument document;
  MeshModel *source = shapes::box(document, kSpacing);
  ASSERT_TRUE(host::apply(host::kPartColor, document,
                          {{"measure", 1}, {"threshold", 0.9}, {"iterations", 1}})
                  .ok);
  std::set<float> seen;
  for (const auto &v : source->cm.vert) {
    seen.insert(v.cQ());
    EXPECT_FALSE(v.cC() == vcg::Color4b(128, 128, 128, 255));
  }
  EXPECT_LE(seen.size(), 3u);
  // By level: the twelve outer parts share a colour.
  ASSERT_TRUE(host::apply(host::kPartColor, document,
                          {{"by", 1}, {"triangle_iterations", 0}, {"iterations", 0}})
                  .ok);
  seen.clear();
  for (const auto &v : source->cm.vert) seen.insert(v.cQ());
  EXPECT_EQ(seen, (std::set<float>{1, 2}));
}

TEST(PartColor, LeavesVerticesOfNoFaceGrey) {
  MeshDocument document;
  MeshModel *source = shapes::torus(document, 3, 1);
  vcg::tri::Allocator<CMeshO>::AddVertex(source->cm, Point3m(9, 9, 9));
  const auto result = host::apply(host::kPartColor, document);
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_EQ(source->cm.vert.back().cC(), vcg::Color4b(128, 128, 128, 255));
  EXPECT_EQ(source->cm.vert.back().cQ(), 0);
  EXPECT_TRUE(result.logged("1 vertex belongs to none"));
}

} // namespace
