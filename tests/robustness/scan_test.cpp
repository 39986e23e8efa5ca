// SPDX-License-Identifier: GPL-3.0-or-later
// Range scans: points with the positions of the scanners that saw them.
#include "outcome.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using shapes::Vec;

/// Six scanners on the axes, and for every point of a shape one that faces it.
struct Scan {
  shapes::Shape shape;
  std::vector<double> scanners = {9, 0, 0, -9, 0, 0, 0, 9, 0, 0, -9, 0, 0, 0, 9, 0, 0, -9};
  std::vector<int32_t> scanner_of;

  explicit Scan(shapes::Shape s) : shape(std::move(s)) {
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const Vec p = shape.at(i);
      int32_t best = 0;
      double facing = -2;
      for (int32_t k = 0; k < 6; ++k) {
        const Vec q = {scanners[3 * k], scanners[3 * k + 1], scanners[3 * k + 2]};
        double cosine = 0;
        for (std::size_t a = 0; a < 3; ++a)
          cosine += shape.normals[3 * i + a] * (q[a] - p[a]) / shapes::distance(p, q);
        if (cosine > facing) facing = cosine, best = k;
      }
      scanner_of.push_back(best);
    }
  }

  Build build() const {
    return [this](vbm_context *c, const vbm_build_options *o, vbm_model **out) {
      return vbm_build_range_scan(c, shape.points.data(), shape.size(), scanners.data(),
                                  scanners.size() / 3,
                                  scanner_of.empty() ? nullptr : scanner_of.data(), o, out);
    };
  }
};

TEST(RangeScan, SphereFromSixSides) {
  const Scan scan(shapes::sphere_mesh(20, 40));
  const Outcome o = run(scan.build());
  ASSERT_EQ(o.status, VBM_OK) << o.message;
  EXPECT_EQ(o.problems, "");
  EXPECT_EQ(o.report.rule, VBM_LABELS_SCAN);
  EXPECT_EQ(o.surface.components, 1u);
  EXPECT_EQ(o.surface.genus, 0);
  EXPECT_EQ(o.surface.triangles, 2 * scan.shape.size() - 4);
  EXPECT_EQ(o.crust.genus, 0);
}

TEST(RangeScan, TorusHasItsHole) {
  const Scan scan(shapes::torus(48, 24, 2, .8, .3));
  const Outcome o = run(scan.build());
  ASSERT_EQ(o.status, VBM_OK) << o.message;
  EXPECT_EQ(o.problems, "");
  EXPECT_EQ(o.surface.components, 1u);
  EXPECT_EQ(o.surface.genus, 1);
  EXPECT_EQ(o.crust.genus, 1);
}

TEST(RangeScan, ScannerInsideAVaseSeesItsInnerWall) {
  // A hollow sphere scanned from outside and, the inner wall, from its middle: a shell. Without the
  // scanners the two walls and the space between them look the same.
  shapes::Shape shell = shapes::join(shapes::sphere_mesh(20, 40),
                                     shapes::inside_out(shapes::sphere_mesh(16, 32, .6)));
  Scan scan(std::move(shell));
  scan.scanners.insert(scan.scanners.end(), {0, 0, 0});
  for (std::size_t i = shapes::sphere_mesh(20, 40).size(); i < scan.shape.size(); ++i)
    scan.scanner_of[i] = 6;
  const Outcome o = run(scan.build());
  ASSERT_EQ(o.status, VBM_OK) << o.message;
  EXPECT_EQ(o.problems, "");
  EXPECT_EQ(o.surface.components, 2u);
  EXPECT_EQ(o.surface.euler, 4);
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(o.surface.volume * std::pow(o.surface.diagonal, 3), 4 * pi / 3 * (1 - .216), .12);
}

TEST(RangeScan, OneScannerAPoint) {
  Scan scan(shapes::sphere_points(500));
  std::vector<double> each;
  for (int32_t k : scan.scanner_of)
    each.insert(each.end(),
                {scan.scanners[3 * k], scan.scanners[3 * k + 1], scan.scanners[3 * k + 2]});
  const std::string indexed = run(scan.build()).bytes;
  scan.scanners = each;
  scan.scanner_of.clear();
  EXPECT_TRUE(run(scan.build()).bytes == indexed);
  scan.scanners.resize(3 * 499);
  const Outcome o = run(scan.build());
  EXPECT_EQ(o.status, VBM_ERROR_ARGUMENT) << o.message;
}

TEST(RangeScan, WrongScanners) {
  Scan scan(shapes::sphere_points(200));
  scan.scanner_of[17] = 6;
  scan.scanner_of[18] = -1;
  Outcome o = run(scan.build());
  EXPECT_EQ(o.status, VBM_ERROR_INPUT);
  EXPECT_EQ(o.problems, "");
  EXPECT_EQ(o.bad, (std::vector<int64_t>{17, 18}));
  EXPECT_NE(o.message.find("vertex 17"), std::string::npos) << o.message;
  scan = Scan(shapes::sphere_points(200));
  scan.scanners[4] = std::nan("");
  o = run(scan.build());
  EXPECT_EQ(o.status, VBM_ERROR_INPUT) << o.message;
  EXPECT_EQ(o.bad, std::vector<int64_t>{1});
  scan = Scan(shapes::sphere_points(200));
  scan.scanners.clear();
  o = run(scan.build());
  EXPECT_EQ(o.status, VBM_ERROR_ARGUMENT) << o.message;
}

TEST(RangeScan, ScannersThatTellNothing) {
  // On the point itself, grazing, or beyond any number: still a closed surface of these points.
  Scan scan(shapes::sphere_mesh(16, 32));
  for (std::size_t i = 0; i < scan.shape.size(); i += 5) scan.scanner_of[i] = int32_t(i % 6);
  const Outcome wrong = run(scan.build());
  EXPECT_EQ(wrong.problems, "");
  EXPECT_EQ(wrong.status, VBM_OK) << wrong.message;
  scan = Scan(shapes::sphere_mesh(16, 32));
  scan.scanners = scan.shape.points; // each where its point is
  scan.scanner_of.clear();
  const Outcome on_points = run(scan.build());
  EXPECT_EQ(on_points.problems, "");
  EXPECT_EQ(on_points.surface.genus, 0);
  scan = Scan(shapes::sphere_mesh(16, 32));
  for (double &x : scan.scanners) x *= 1e307;
  const Outcome far = run(scan.build());
  EXPECT_EQ(far.problems, "");
  EXPECT_EQ(far.surface.components, 1u);
}

TEST(RangeScan, OtherLabelsOnRequest) {
  const Scan scan(shapes::sphere_mesh(16, 32));
  EXPECT_EQ(run(scan.build(), make_options(VBM_BALLS_POLAR, VBM_LABELS_PROPAGATION)).report.rule,
            VBM_LABELS_PROPAGATION);
  EXPECT_EQ(run(scan.build(), make_options(VBM_BALLS_POLAR, VBM_LABELS_VOXELS)).status,
            VBM_ERROR_ARGUMENT);
}

} // namespace
