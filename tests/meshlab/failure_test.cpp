// SPDX-License-Identifier: GPL-3.0-or-later
// What goes wrong is said, in the message and in the log, and leaves the document as it was.
#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace {

// Everything about the layers that a filter could have changed.
std::string state(MeshDocument &document) {
  QString text;
  for (int id = 0; id < 10; ++id) {
    MeshModel *layer = document.getMesh(id);
    if (!layer) continue;
    QByteArray bytes;
    for (const auto &v : layer->cm.vert) {
      const Point3m place = v.cP();
      const auto quality = v.cQ();
      bytes.append(reinterpret_cast<const char *>(&place), sizeof place);
      bytes.append(reinterpret_cast<const char *>(&quality), sizeof quality);
    }
    text += QString("%1 %2 %3 %4 %5 %6 %7\n")
                .arg(id)
                .arg(layer->label())
                .arg(layer->cm.VN())
                .arg(layer->cm.FN())
                .arg(layer->dataMask())
                .arg(qHash(bytes))
                .arg(layer->isVisible());
  }
  text += QString("current %1").arg(document.mm() ? document.mm()->id() : -1);
  return text.toStdString();
}

void expect_refused(const char *filter, MeshDocument &document, const host::Given &given,
                    const std::string &part) {
  const std::string before = state(document);
  const auto result = host::apply(filter, document, given);
  EXPECT_FALSE(result.ok) << filter;
  EXPECT_NE(result.error.find(part), std::string::npos) << filter << ": " << result.error;
  EXPECT_TRUE(result.logged(result.error)) << filter;
  EXPECT_EQ(state(document), before) << filter;
}

// Those that start from any shape.
const std::vector<const char *> all = {host::kBalls,      host::kSurface,  host::kThickness,
                                       host::kAxis,       host::kSimplify, host::kPartColor,
                                       host::kAxisOfBalls};

TEST(Failure, NotFinite) {
  for (const char *filter : all) {
    MeshDocument document;
    MeshModel *source = shapes::sphere(document, 2);
    source->cm.vert[1023].P()[1] = std::numeric_limits<Scalarm>::quiet_NaN();
    expect_refused(filter, document, {}, "1023");
    vcg::tri::Allocator<CMeshO>::DeleteVertex(source->cm, source->cm.vert[3]);
    source->cm.face.clear();
    source->cm.fn = 0;
    expect_refused(filter, document, {}, "not deleted");
  }
}

TEST(Failure, NotFinitePointsCanBeLeftOut) {
  MeshDocument document;
  MeshModel *source = shapes::sphere(document, 2);
  shapes::forget_faces(*source);
  source->cm.vert[1023].P()[1] = std::numeric_limits<Scalarm>::quiet_NaN();
  const auto result = host::apply(host::kThickness, document, {{"drop_invalid", 1}});
  ASSERT_TRUE(result.ok) << result.error;
  EXPECT_EQ(source->cm.vert[1023].cQ(), 0);
  EXPECT_NEAR(source->cm.vert[1000].cQ(), 4, 0.1);
}

// What the message names stands in the dialog.
TEST(Failure, LimitsCanBeRaised) {
  for (const char *filter : all) {
    MeshDocument document;
    shapes::sphere(document, 2);
    for (const char *limit : {"sample_limit", "cell_limit"}) {
      expect_refused(filter, document, {{limit, 100}}, std::string("(") + limit + ")");
      const std::vector<std::string> names = host::dialog(filter, document);
      EXPECT_EQ(std::count(names.begin(), names.end(), limit), 1) << filter;
    }
  }
  MeshDocument document;
  shapes::sphere(document, 2);
  const auto result =
      host::apply(host::kBalls, document, {{"sample_limit", 1e6}, {"cell_limit", 1e7}});
  EXPECT_TRUE(result.ok) << result.error;
}

TEST(Failure, TooFewOrFlat) {
  for (const char *filter : all) {
    MeshDocument document;
    MeshModel *layer = host::add_layer(document, "points");
    expect_refused(filter, document, {}, "");
    for (int i = 0; i < 3; ++i)
      vcg::tri::Allocator<CMeshO>::AddVertex(layer->cm, Point3m(Scalarm(i), Scalarm(i * i), 0));
    expect_refused(filter, document, {}, "");
    for (int i = 0; i < 20; ++i)
      for (int j = 0; j < 20; ++j)
        vcg::tri::Allocator<CMeshO>::AddVertex(layer->cm, Point3m(Scalarm(i), Scalarm(j), 0));
    expect_refused(filter, document, {}, "");
  }
}

TEST(Failure, NoLayer) {
  for (const char *filter : all) {
    MeshDocument document;
    expect_refused(filter, document, {}, "no layer");
  }
}

// Scripts can say anything.
TEST(Failure, ParameterOutOfItsRange) {
  MeshDocument document;
  shapes::sphere(document, 2);
  expect_refused(host::kSurface, document, {{"method", 2}}, "method is 2");
  expect_refused(host::kBalls, document, {{"labels", -1}}, "labels is -1");
  expect_refused(host::kBalls, document, {{"labels", 3}}, "labels is 3");
  expect_refused(host::kBalls, document, {{"undersampling", 0.001}}, "undersampling is 0.001");
  expect_refused(host::kBalls, document, {{"spacing", std::numeric_limits<double>::quiet_NaN()}},
                 "spacing is nan");
  // Any negative spacing means the vertices alone.
  EXPECT_TRUE(host::apply(host::kBalls, document, {{"spacing", -3}}).ok);
}

TEST(Failure, Cancelled) {
  for (const char *filter : all)
    for (const int at : {1, 2, 5}) {
      MeshDocument document;
      shapes::torus(document, 3, 1);
      const std::string before = state(document);
      int calls = 0;
      const auto result = host::apply(filter, document, {}, [&] { return ++calls < at; });
      EXPECT_FALSE(result.ok) << filter << at;
      EXPECT_EQ(calls, at) << "nothing is called after it said stop";
      EXPECT_NE(result.error.find("Cancelled"), std::string::npos) << result.error;
      EXPECT_TRUE(result.logged("Cancelled"));
      EXPECT_EQ(state(document), before);
    }
}

TEST(Failure, AppliedWithinItself) {
  MeshDocument document;
  shapes::sphere(document, 2);
  int tried = 0;
  const auto result = host::apply(host::kSurface, document, {}, [&] {
    if (tried++ > 2) return true;
    const auto inner = host::apply(tried % 2 ? host::kSurface : host::kThickness, document);
    EXPECT_FALSE(inner.ok);
    EXPECT_NE(inner.error.find("running already"), std::string::npos) << inner.error;
    return true;
  });
  EXPECT_GT(tried, 2);
  EXPECT_TRUE(result.ok) << result.error;
  EXPECT_EQ(host::layers(document), 2);
  // And it can run again.
  EXPECT_TRUE(host::apply(host::kBalls, document).ok);
}

TEST(Failure, LayerGoneOrChangedMeanwhile) {
  {
    MeshDocument document;
    MeshModel *source = shapes::sphere(document, 2);
    bool gone = false;
    const auto result = host::apply(host::kThickness, document, {}, [&] {
      if (!gone) host::remove_layer(document, source);
      return gone = true;
    });
    EXPECT_FALSE(result.ok);
    EXPECT_NE(result.error.find("removed"), std::string::npos) << result.error;
    EXPECT_EQ(host::layers(document), 0);
  }
  for (const bool added : {false, true}) {
    MeshDocument document;
    MeshModel *source = shapes::sphere(document, 2);
    bool changed = false;
    const auto result = host::apply(host::kThickness, document, {}, [&] {
      if (!changed && added)
        vcg::tri::Allocator<CMeshO>::AddVertex(source->cm, Point3m(0, 0, 0));
      else if (!changed)
        vcg::tri::Allocator<CMeshO>::DeleteVertex(source->cm, source->cm.vert[8]);
      return changed = true;
    });
    EXPECT_FALSE(result.ok);
    EXPECT_NE(result.error.find("changed"), std::string::npos) << result.error;
    EXPECT_FALSE(source->hasDataMask(MeshModel::MM_VERTRADIUS));
  }
  { // What was read is whole: a new layer can be added all the same.
    MeshDocument document;
    MeshModel *source = shapes::sphere(document, 2);
    bool gone = false;
    const auto result = host::apply(host::kSurface, document, {}, [&] {
      if (!gone) host::remove_layer(document, source);
      return gone = true;
    });
    EXPECT_TRUE(result.ok) << result.error;
    EXPECT_EQ(shapes::check(*document.mm()).border_edges, 0);
  }
}

TEST(Failure, ExceptionFromTheCallback) {
  for (const char *filter : all) {
    MeshDocument document;
    shapes::sphere(document, 2);
    const std::string before = state(document);
    const auto result = host::apply(filter, document, {}, []() -> bool { throw 42; });
    EXPECT_FALSE(result.ok);
    EXPECT_FALSE(result.error.empty());
    EXPECT_EQ(state(document), before);
  }
}

} // namespace
