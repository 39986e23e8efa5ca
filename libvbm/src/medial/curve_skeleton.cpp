// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/progress.h"
#include "medial/contract.h"
#include "medial/curve_chains.h"
#include "medial/curve_tree.h"
#include "medial/medial_mesh.h"
#include "medial/mesh_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vbm::impl {
namespace {

/// Vertices of curves lie beside the axis a little: their balls are the largest that fit there.
void fit_radii(BallComplex &complex, const Shape &shape, Progress &progress) {
  for (Ball &ball : complex.ball) {
    progress.tick(0, 1);
    TriangleTree::Nearest found;
    found.distance = std::numeric_limits<double>::infinity();
    if (shape.tree.nearest(ball.center, found)) ball.radius = found.distance;
  }
}

/// Balls on sheets that could not burn get as far apart as those on curves. The cost of joining two
/// is how far their places and radii are apart, so that pieces of even size become one ball.
void thin_sheets(BallComplex &complex, double spacing, Progress &progress) {
  if (complex.triangle.empty()) return;
  double balls = 0;
  std::vector<uint8_t> on_sheet(complex.ball.size(), 0);
  for (const auto &t : complex.triangle) {
    const Ball &a = complex.ball[t[0]], &b = complex.ball[t[1]], &c = complex.ball[t[2]];
    const double width = spacing * (a.radius + b.radius + c.radius) / 3;
    // An even triangle of this side has this area, and every ball two triangles.
    const double two = 2 * std::sqrt(3.0) / 4 * width * width;
    balls += two > 0 ? length(cross(b.center - a.center, c.center - a.center)) / 2 / two : 0.5;
    for (int32_t v : t) on_sheet[v] = 1;
  }
  const double curves = double(std::count(on_sheet.begin(), on_sheet.end(), 0));
  std::vector<BallQuadric> quadric(complex.ball.size());
  for (std::size_t v = 0; v < quadric.size(); ++v) quadric[v].add_anchor(complex.ball[v], 1);
  const double count = std::min(curves + balls, double(complex.ball.size()));
  contract(complex, quadric, std::size_t(count), nullptr, progress);
}

} // namespace

MedialMesh curve_skeleton(const Axis &axis, const vbm_curve_skeleton_options &options,
                          Progress &progress) {
  const Model &model = *axis.model;
  progress.stage("burning", 0.4);
  Burnt burnt = burn(*axis.cells, axis.state, progress);
  progress.stage("cutting spurs", 0.5);
  SpurLimit limit;
  limit.length = options.spur * model.samples.frame.length_to_unit(model.report.diagonal);
  limit.ratio = options.ratio;
  cut_spurs(*axis.cells, limit, burnt, progress);
  progress.stage("smoothing", 0.55);
  BallComplex complex = thin_curves(*axis.cells, burnt, options.spacing, progress);
  thin_sheets(complex, options.spacing, progress);
  progress.stage("surface", 0.7);
  const Shape shape = shape_of(model, progress);
  fit_radii(complex, shape, progress);
  progress.stage("errors", 1);
  MedialMesh out = medial_mesh(complex, model, mesh_errors(complex, shape, model, progress));
  if (const uint64_t n = out.report.triangles)
    out.notes = std::to_string(n) + (n == 1 ? " triangle" : " triangles") +
                " stayed: sheets without a border, as round a cavity, do not collapse to curves\n";
  return out;
}

} // namespace vbm::impl
