// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 8.5: the power crust with a union's singular points as samples. The balls themselves are
// the inner ones; outer ones are the poles of the points' Delaunay triangulation (3.1.2). It
// differs in that all vertices of the singular-point surface are samples, those on arcs and
// patches too, so that balls that meet at no point have some; and in that, where the crust's
// components and handles are not the union's, it is made again of more points on patches.
#include "ball_surface/singular_crust.h"

#include "ball_surface/singular_points.h"
#include "balls/build.h"
#include "core/error.h"
#include "core/progress.h"
#include "sampling/points.h"
#include "surface/power_crust.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vbm::impl {
namespace {

constexpr int kAttempts = 3;
/// How much flatter the patches between samples are at each attempt.
constexpr double kFiner = 0.25, kLeastBulge = 0.002;

/// The singular-point surface's vertices, with normals away from their balls' centres.
Samples samples_of(const Surface &surface, const UnionInput &set, Progress &progress) {
  std::vector<Vec3> normal(surface.vertices.size());
  for (std::size_t p = 0; p < surface.polygon_ball.size(); ++p) {
    progress.tick(0, 1);
    const Ball &ball = set.balls[surface.polygon_ball[p]];
    const Vec3 center = set.frame.to_input(ball.center);
    for (uint64_t i = surface.polygons.offset[p]; i < surface.polygons.offset[p + 1]; ++i) {
      const int32_t v = surface.polygons.index[i];
      const Vec3 out = surface.vertices[v] - center;
      // Lengths first: squares of very small or large ones would not be numbers.
      const double size = std::max({std::fabs(out.x), std::fabs(out.y), std::fabs(out.z)});
      if (size > 0) normal[v] += unit(Vec3{out.x / size, out.y / size, out.z / size});
    }
  }
  vbm_build_options options{};
  std::vector<double> points, normals;
  for (std::size_t v = 0; v < normal.size(); ++v) {
    progress.tick(0, 1);
    for (int a = 0; a < 3; ++a) {
      points.push_back(surface.vertices[v][a]);
      normals.push_back(normal[v][a]);
    }
  }
  return sample_points(points.data(), normal.size(), normals.data(), options, progress);
}

/// The samples that are corners of each ball's polygons, ascending, as a model has them.
std::vector<std::vector<int32_t>> samples_of_balls(const Surface &surface, const Samples &samples,
                                                   std::size_t balls, Progress &progress) {
  std::vector<std::vector<int32_t>> lists(balls);
  for (std::size_t p = 0; p < surface.polygon_ball.size(); ++p) {
    progress.tick(0, 1);
    for (uint64_t i = surface.polygons.offset[p]; i < surface.polygons.offset[p + 1]; ++i)
      if (const int32_t s = samples.input_sample[surface.polygons.index[i]]; s >= 0)
        lists[surface.polygon_ball[p]].push_back(s);
  }
  for (auto &list : lists) {
    progress.tick(0, 1);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return lists;
}

/// A model's inner balls replaced by the set's; `number` receives theirs.
void take_balls(Model &model, const Surface &surface, const UnionInput &set,
                std::vector<int32_t> &number, Progress &progress) {
  const auto lists = samples_of_balls(surface, model.samples, set.balls.size(), progress);
  std::vector<Ball> balls;
  Incidence touched;
  std::vector<int32_t> pole(model.samples.position.size(), -1);
  std::vector<double> reach(pole.size(), -1);
  for (std::size_t b = 0; b < lists.size(); ++b) {
    progress.tick(0, 1);
    const int32_t n = int32_t(balls.size());
    const Ball &given = set.balls[b];
    balls.push_back({model.samples.frame.to_unit(set.frame.to_input(given.center)),
                     model.samples.frame.length_to_unit(set.frame.length_to_input(given.radius))});
    number.push_back(int32_t(b));
    for (int32_t s : lists[b]) {
      touched.index.push_back(s);
      if (given.radius > reach[s]) reach[s] = given.radius, pole[s] = n;
    }
    touched.offset.push_back(touched.index.size());
  }
  const std::size_t inner = balls.size(), old = model.inner;
  for (std::size_t b = old; b < model.balls.size(); ++b) {
    progress.tick(0, 1);
    balls.push_back(model.balls[b]);
    for (uint64_t k = model.ball_samples.offset[b]; k < model.ball_samples.offset[b + 1]; ++k)
      touched.index.push_back(model.ball_samples.index[k]);
    touched.offset.push_back(touched.index.size());
  }
  const auto moved = [&](int32_t b) {
    return b < int32_t(old) ? -1 : b + int32_t(inner) - int32_t(old);
  };
  for (int32_t &b : model.ball_of_cell) b = moved(b);
  for (int32_t &b : model.outer_pole) b = moved(b);
  model.balls = std::move(balls);
  model.inner = inner;
  model.ball_samples = std::move(touched);
  model.inner_pole = std::move(pole);
}

/// A model of the samples. The caller knows nothing of these, and gave balls.
Model model_of(const Surface &points, const UnionInput &set, Progress &progress) {
  vbm_build_options build{};
  build.undersampling = 0.7;
  try {
    return build_model(samples_of(points, set, progress), build, progress);
  } catch (const Error &error) {
    if (error.status != VBM_ERROR_DEGENERATE && error.status != VBM_ERROR_INPUT) throw;
    throw Error(VBM_ERROR_INPUT,
                "the balls are too small beside their distance from the origin, or beside each "
                "other, for a power crust: the points that it is made of fall together");
  }
}

} // namespace

Surface singular_crust(const UnionInput &set, const vbm_ball_surface_options &options,
                       Progress &progress) {
  UnionInput own = set; // its balls are numbered from 0
  std::iota(own.number.begin(), own.number.end(), 0);
  vbm_ball_surface_options finer = options;
  for (int attempt = 0;; ++attempt) {
    progress.part(attempt == 0 ? 0.3 : 0.9);
    const Surface points = singular_point_surface(own, finer, progress);
    progress.part(attempt == 0 ? 0.6 : 0.95);
    Model model = model_of(points, own, progress);
    std::vector<int32_t> number;
    take_balls(model, points, own, number, progress);
    progress.part(attempt == 0 ? 0.85 : 1);
    Surface surface = power_crust(model, nullptr, nullptr, progress);

    const bool same = surface.report.components == points.report.components &&
                      surface.report.euler == points.report.euler;
    if (!same && attempt + 1 < kAttempts && finer.bulge * kFiner >= kLeastBulge) {
      finer.bulge *= kFiner;
      continue;
    }
    progress.part(1);
    // Samples are vertices of the other surface, which knows the model's.
    for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
      const int32_t from = surface.vertex_input[v];
      surface.vertex_sample[v] = from < 0 ? -1 : points.vertex_sample[from];
      surface.vertex_input[v] = from < 0 ? -1 : points.vertex_input[from];
    }
    for (int32_t &b : surface.polygon_ball)
      if (b >= 0) b = number[b];
    vbm_surface_report &report = surface.report;
    report.hidden_balls = points.report.hidden_balls;
    report.singular_points = points.report.singular_points;
    report.merged_points = points.report.merged_points;
    report.offset_points = points.report.offset_points;
    report.added_points = points.report.added_points;
    progress.stage("checking", 1);
    fill_gaps(surface, own, progress);
    for (int32_t &b : surface.polygon_ball)
      if (b >= 0) b = set.number[b];
    if (!same)
      surface.notes +=
          "the crust has " + std::to_string(report.components) + " components and " +
          std::to_string(report.genus) + " handles, the union of the balls " +
          std::to_string(points.report.components) + " and " + std::to_string(points.report.genus) +
          ": its singular points are too far apart to tell; a smaller bulge gives more of them\n";
    surface.notes += points.notes;
    return surface;
  }
}

} // namespace vbm::impl
