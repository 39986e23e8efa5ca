// SPDX-License-Identifier: GPL-3.0-or-later
// Clusters at the C interface: what is refused and how, old and new structs, cancelling, other
// floating-point environments, and inputs of a kind that could cost the square of their number.
#include "child.h"
#include "host.h"

#include <vbm/vbm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <ctime>
#include <limits>
#include <string>
#include <vector>

namespace {

struct Balls {
  std::vector<double> centers, radii;
  void add(double x, double y, double z, double r) {
    centers.insert(centers.end(), {x, y, z});
    radii.push_back(r);
  }
  vbm::View<double, 3> center_view() const { return {centers.data(), radii.size()}; }
  vbm::View<double> radius_view() const { return {radii.data(), radii.size()}; }
};

double unit(uint64_t &state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return double(state >> 11) * 0x1p-53;
}

Balls scattered(std::size_t count, double size) {
  Balls balls;
  uint64_t state = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = unit(state), y = unit(state), z = unit(state);
    balls.add(x, y, z, size * unit(state));
  }
  return balls;
}

std::string bytes(const vbm::Clusters &clusters) {
  std::string out;
  const auto append = [&](const auto &view, std::size_t width) {
    out.append(reinterpret_cast<const char *>(view.data), view.size * width * sizeof *view.data);
  };
  append(clusters.centers(), 3);
  append(clusters.radii(), 1);
  append(clusters.sphericity(), 1);
  append(clusters.gap(), 1);
  append(clusters.ball_cluster(), 1);
  append(clusters.balls().offsets, 1);
  append(clusters.balls().indices, 1);
  return out;
}

TEST(Cluster, Refusals) {
  vbm_context *context = nullptr;
  ASSERT_EQ(vbm_context_create(&context), VBM_OK);
  const Balls balls = scattered(10, .5);
  vbm_clusters *clusters = reinterpret_cast<vbm_clusters *>(context);
  const auto refused = [&](const double *c, const double *r, std::size_t n,
                           const vbm_cluster_options *o, vbm_status status, const char *message) {
    clusters = reinterpret_cast<vbm_clusters *>(context);
    EXPECT_EQ(vbm_cluster_balls(context, c, r, n, o, &clusters), status);
    EXPECT_EQ(clusters, nullptr);
    EXPECT_STREQ(vbm_context_message(context), message);
  };
  refused(nullptr, balls.radii.data(), 10, nullptr, VBM_ERROR_ARGUMENT,
          "centers is NULL, but 10 balls were announced");
  refused(balls.centers.data(), nullptr, 10, nullptr, VBM_ERROR_ARGUMENT,
          "radii is NULL, but 10 balls were announced");
  refused(nullptr, nullptr, 0, nullptr, VBM_ERROR_INPUT, "there are no balls to cluster");
  vbm_cluster_options options;
  vbm_cluster_options_init(&options, sizeof options);
  options.measure = 2;
  refused(balls.centers.data(), balls.radii.data(), 10, &options, VBM_ERROR_ARGUMENT,
          "option measure is 2: use 0 (enclosing) or 1 (union)");
  EXPECT_EQ(vbm_cluster_balls(nullptr, nullptr, nullptr, 0, nullptr, &clusters),
            VBM_ERROR_ARGUMENT);
  EXPECT_EQ(vbm_cluster_balls(context, nullptr, nullptr, 0, nullptr, nullptr), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(vbm_model_cluster(context, nullptr, nullptr, &clusters), VBM_ERROR_ARGUMENT);
  EXPECT_STREQ(vbm_context_message(context), "model is NULL");

  ASSERT_EQ(vbm_cluster_balls(context, balls.centers.data(), balls.radii.data(), 10, nullptr,
                              &clusters),
            VBM_OK);
  vbm_cluster_error error;
  std::memset(&error, 0x55, sizeof error);
  const vbm_cluster_error before = error;
  error.struct_size = sizeof error;
  EXPECT_EQ(vbm_clusters_measure(context, clusters, 0, &error), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(vbm_clusters_measure(context, nullptr, 10, &error), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(vbm_clusters_measure(context, clusters, 10, nullptr), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(0, std::memcmp(&error.outward_points, &before.outward_points,
                           sizeof error - sizeof error.struct_size)); // untouched
  error.struct_size = 0;
  EXPECT_EQ(vbm_clusters_measure(context, clusters, 10, &error), VBM_ERROR_ARGUMENT);
  vbm_clusters_free(clusters);
  vbm_clusters_free(nullptr);
  std::size_t count = 7;
  EXPECT_EQ(vbm_clusters_radii(nullptr, &count), nullptr);
  EXPECT_EQ(count, 0u);
  EXPECT_STREQ(vbm_clusters_notes(nullptr), "");
  vbm_context_free(context);
}

TEST(Cluster, OlderCallers) {
  vbm::Context context;
  const Balls balls = scattered(200, .3);
  vbm::ClusterOptions options;
  options.sphericity = .8;
  options.measure = VBM_CLUSTER_UNION; // beyond the older struct: must not be read
  const std::string enclosing = [&] {
    vbm::ClusterOptions o;
    o.sphericity = .8;
    return bytes(vbm::cluster_balls(context, balls.center_view(), balls.radius_view(), o));
  }();
  options.struct_size = offsetof(vbm_cluster_options, count);
  EXPECT_TRUE(bytes(vbm::cluster_balls(context, balls.center_view(), balls.radius_view(),
                                       options)) == enclosing);
  struct {
    vbm_clusters_report report;
    double more[2];
  } newer;
  std::memset(&newer, 0x55, sizeof newer);
  newer.report.struct_size = sizeof newer;
  const vbm::Clusters clusters =
      vbm::cluster_balls(context, balls.center_view(), balls.radius_view());
  ASSERT_EQ(vbm_clusters_get_report(clusters.handle(), &newer.report), VBM_OK);
  EXPECT_EQ(newer.report.balls, 200u);
  EXPECT_EQ(newer.more[1], 0);
}

TEST(Cluster, TheSameInEveryEnvironment) {
  const Balls balls = scattered(2000, .2);
  const auto run = [&] {
    vbm::Context context;
    std::string all;
    for (const uint64_t count : {0, 40})
      for (const int32_t measure : {VBM_CLUSTER_ENCLOSING, VBM_CLUSTER_UNION}) {
        vbm::ClusterOptions options;
        options.sphericity = .8;
        options.count = count;
        options.measure = measure;
        const vbm::Clusters clusters =
            vbm::cluster_balls(context, balls.center_view(), balls.radius_view(), options);
        all += bytes(clusters);
        const vbm_cluster_error error = clusters.measure(context, 3000);
        all.append(reinterpret_cast<const char *>(&error), sizeof error);
      }
    return all;
  };
  const std::string usual = run();
  EXPECT_TRUE(run() == usual);
  if (!have_comma_locale()) GTEST_SKIP() << "no locale de_DE.UTF-8";
  std::string odd;
  EXPECT_EQ(in_odd_host([&] { odd = run(); }), "");
  EXPECT_TRUE(odd == usual);
}

/// Between any two reports cancelling waits as long as from one to the next.
TEST(Cluster, CancelsSoonOnAMillionBalls) {
  const Balls balls = scattered(sanitized() ? 100000 : 1000000, .02);
  for (const bool many : {true, false}) { // clusters, or one
    const double sphericity = many ? .95 : .05;
    vbm::Context context;
    vbm::ClusterOptions options;
    options.sphericity = sphericity;
    double last = 0, longest = 0;
    std::string where;
    context.set_progress([&](double fraction, const char *stage) {
      const double now = double(std::clock()) / CLOCKS_PER_SEC;
      if (now - last > longest) {
        longest = now - last;
        where = stage + std::string(" before ") + std::to_string(fraction);
      }
      last = now;
      return many && fraction > .1; // all the same from there on
    });
    last = double(std::clock()) / CLOCKS_PER_SEC;
    try {
      vbm::cluster_balls(context, balls.center_view(), balls.radius_view(), options);
      EXPECT_FALSE(many);
    } catch (const vbm::Error &error) {
      EXPECT_EQ(error.status, VBM_ERROR_CANCELLED) << error.what();
    }
    std::printf("sphericity %.2f: at most %.0f ms of processor time between reports: %s\n", sphericity,
                1e3 * longest, where.c_str());
    if (!sanitized()) {
      EXPECT_LT(longest, .5); // a tenth, and room for a busy machine
    }
  }
}

TEST(Cluster, NoInputCostsTheSquareOfItsNumber) {
  const std::size_t kCount = sanitized() ? 4000 : 20000;
  Balls line, shell, same, growing, plane;
  uint64_t state = 5;
  for (std::size_t i = 0; i < kCount; ++i) {
    const double t = double(i) / double(kCount), a = 2.39996322972865332 * double(i);
    line.add(t * .1, 0, 0, 1);
    const double z = 2 * t - 1, s = std::sqrt(1 - z * z), r = .2 + .8 * unit(state);
    shell.add(s * std::cos(a) * (1.06 - r), s * std::sin(a) * (1.06 - r), z * (1.06 - r), r);
    same.add(1, 2, 3, 4);
    growing.add(std::exp(-t * 20), 0, 0, std::exp(-t * 20)); // smaller and smaller, side by side
    plane.add(std::sqrt(t) * std::cos(a), std::sqrt(t) * std::sin(a), 0, .5);
  }
  for (const Balls *balls : {&line, &shell, &same, &growing, &plane})
    for (const double sphericity : {1., .99, .95, .5, .01})
      for (const uint64_t count : {0, 100}) {
        vbm::Context context;
        vbm::ClusterOptions options;
        options.sphericity = sphericity;
        options.count = count;
        const std::clock_t start = std::clock();
        const vbm::Clusters clusters =
            vbm::cluster_balls(context, balls->center_view(), balls->radius_view(), options);
        const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
        EXPECT_LT(seconds, 20) << sphericity << " " << count; // a square: hundreds
        EXPECT_EQ(clusters.ball_cluster().size, kCount);
        const vbm_clusters_report report = clusters.report();
        EXPECT_LE(report.gap, report.bound);
        if (!count) {
          EXPECT_GE(report.sphericity, sphericity);
        }
      }
}

} // namespace
