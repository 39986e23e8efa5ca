// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/progress.h"
#include "medial/contract.h"
#include "medial/fit_balls.h"
#include "medial/medial_mesh.h"
#include "medial/mesh_errors.h"
#include "medial/split_edges.h"

#include <algorithm>
#include <array>
#include <string>

namespace vbm::impl {
namespace {

/// The tangent planes at the samples that each ball of the axis stands for: those its triangles are
/// equidistant from, and those whose polar ball went into it.
std::vector<BallQuadric> planes_of(const Axis &axis, const BallComplex &complex,
                                   const std::vector<int32_t> &number, Progress &progress) {
  const AxisCells &cells = *axis.cells;
  const Model &model = *axis.model;
  std::vector<std::array<int32_t, 2>> touch; // ball, sample
  for (std::size_t t = 0; t < cells.triangle.size(); ++t) {
    progress.tick(0, 1);
    if (!axis.state.triangle[t]) continue;
    for (int32_t v : cells.triangle[t])
      for (int32_t s : cells.triangle_samples[t]) touch.push_back({number[v], s});
  }
  for (std::size_t s = 0; s < model.inner_pole.size(); ++s) {
    const int32_t pole = model.inner_pole[s];
    if (pole < 0 || std::size_t(pole) >= cells.vertex_of_ball.size()) continue;
    const int32_t v = cells.vertex_of_ball[pole];
    if (v >= 0 && number[v] >= 0) touch.push_back({number[v], int32_t(s)});
  }
  std::sort(touch.begin(), touch.end());
  touch.erase(std::unique(touch.begin(), touch.end()), touch.end());
  std::vector<BallQuadric> out(complex.ball.size());
  for (const auto &[v, s] : touch) {
    const Vec3 &p = model.samples.position[s];
    const Vec3 n = unit(p - complex.ball[v].center);
    if (dot(n, n) > 0) out[v].add_plane(p, n, 1);
  }
  return out;
}

/// Triangles of the surface are covered with points where they are longer than this many times the
/// square root of the mean area of a sample: where the sampling has a hole.
constexpr double kLongTriangle = 4;

/// Points in one triangle, at most, along a side.
constexpr int kMostRows = 64;

/// Points the envelope should pass: the samples whose balls are left, and more on large triangles
/// of the surface, which balls would bulge out of.
std::vector<Ball> points_to_pass(const Axis &axis, const Shape &shape,
                                 const std::vector<int32_t> &number, Progress &progress) {
  const AxisCells &cells = *axis.cells;
  const Model &model = *axis.model;
  std::vector<uint8_t> stays(model.samples.position.size(), 0);
  std::vector<Ball> out;
  for (int32_t s : shape.sample) {
    const int32_t pole = model.inner_pole[s];
    const int32_t v = pole < 0 || std::size_t(pole) >= cells.vertex_of_ball.size()
                          ? -1
                          : cells.vertex_of_ball[pole];
    if (v < 0 || number[v] < 0) continue;
    stays[s] = 1;
    out.push_back({model.samples.position[s], model.balls[pole].radius});
  }
  const double area = shape.area / double(std::max<std::size_t>(1, shape.sample.size()));
  const double spacing = std::sqrt(area);
  if (!(spacing > 0)) return out;
  for (const auto &t : shape.triangle) {
    progress.tick(0, 1);
    if (!stays[t[0]] || !stays[t[1]] || !stays[t[2]]) continue;
    const Vec3 &a = model.samples.position[t[0]], &b = model.samples.position[t[1]],
               &c = model.samples.position[t[2]];
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    if (longest <= kLongTriangle * spacing) continue;
    const int rows = int(std::min(std::ceil(longest / spacing), double(kMostRows)));
    for (int i = 1; i < rows; ++i)
      for (int j = 1; i + j < rows; ++j)
        out.push_back({a + (b - a) * (double(i) / rows) + (c - a) * (double(j) / rows), 0});
  }
  return out;
}

/// A mesh of so many times fewer balls, split to the count asked for, is the other candidate where
/// there are no more points to a ball than the second: where few tell a ball where to be, balls
/// that were fitted when they were fewer are better off. There are some of these.
constexpr std::size_t kFewer = 4, kFewPoints = 16, kLeastFine = 64;

/// The candidate of a complex that is contracted but not fitted yet.
BallComplex refined(const BallComplex &contracted, const std::vector<BallQuadric> &planes,
                    const std::vector<Ball> &points, std::size_t count, int iterations,
                    Progress &progress) {
  BallComplex complex = contracted;
  std::vector<BallQuadric> quadric = planes;
  contract(complex, quadric, count / kFewer, nullptr, progress);
  fit_balls(complex, points, iterations, progress);
  split_edges(complex, points, count, progress);
  fit_balls(complex, points, iterations, progress);
  return complex;
}

/// Largest and mean errors, both ways, weigh alike.
double badness(const MeshErrors &e) {
  return std::max(e.sample_max, e.envelope_max) * (e.sample_mean + e.envelope_mean);
}

} // namespace

MedialMesh simplify_axis(const Axis &axis, const vbm_simplify_options &options,
                         Progress &progress) {
  const Model &model = *axis.model;
  progress.stage("planes", 0.1);
  std::vector<int32_t> number;
  BallComplex complex = complex_of(*axis.cells, axis.state, &number);
  std::vector<BallQuadric> quadric = planes_of(axis, complex, number, progress);
  progress.stage("contracting", 0.4);
  contract(complex, quadric, std::size_t(options.count), nullptr, progress);
  if (complex.ball.size() > options.count)
    throw Error(VBM_ERROR_ARGUMENT,
                "option count is " + std::to_string(options.count) +
                    ", but the topology of this axis keeps it from having fewer than " +
                    std::to_string(complex.ball.size()) + " balls",
                "option", {}, 0);
  progress.stage("surface", 0.5);
  const Shape shape = shape_of(model, progress);
  progress.stage("fitting", 0.65);
  const std::vector<Ball> points = points_to_pass(axis, shape, number, progress);
  const BallComplex contracted = complex;
  fit_balls(complex, points, options.iterations, progress);
  MeshErrors errors = mesh_errors(complex, shape, model, progress);
  if (options.iterations > 0 && options.count >= kLeastFine &&
      points.size() <= kFewPoints * options.count && complex.ball.size() == options.count) {
    progress.stage("refining", 1);
    BallComplex other =
        refined(contracted, quadric, points, options.count, options.iterations, progress);
    const MeshErrors others = mesh_errors(other, shape, model, progress);
    if (other.ball.size() == options.count && badness(others) < badness(errors)) {
      complex = std::move(other);
      errors = others;
    }
  }
  return medial_mesh(complex, model, errors);
}

} // namespace vbm::impl
