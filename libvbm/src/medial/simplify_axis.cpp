// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/progress.h"
#include "medial/contract.h"
#include "medial/medial_mesh.h"
#include "medial/mesh_errors.h"

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

} // namespace

MedialMesh simplify_axis(const Axis &axis, const vbm_simplify_options &options,
                         Progress &progress) {
  const Model &model = *axis.model;
  progress.stage("planes", 0.1);
  std::vector<int32_t> number;
  BallComplex complex = complex_of(*axis.cells, axis.state, &number);
  std::vector<BallQuadric> quadric = planes_of(axis, complex, number, progress);
  progress.stage("contracting", 0.6);
  contract(complex, quadric, std::size_t(options.count), nullptr, progress);
  if (complex.ball.size() > options.count)
    throw Error(VBM_ERROR_ARGUMENT,
                "option count is " + std::to_string(options.count) +
                    ", but the topology of this axis keeps it from having fewer than " +
                    std::to_string(complex.ball.size()) + " balls",
                "option", {}, 0);
  progress.stage("surface", 0.7);
  const Shape shape = shape_of(model, progress);
  progress.stage("errors", 1);
  return medial_mesh(complex, model, shape, progress);
}

} // namespace vbm::impl
