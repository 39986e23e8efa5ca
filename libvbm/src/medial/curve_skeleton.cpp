// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/progress.h"
#include "medial/curve_chains.h"
#include "medial/curve_tree.h"
#include "medial/medial_mesh.h"
#include "medial/mesh_errors.h"

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
  progress.stage("surface", 0.7);
  const Shape shape = shape_of(model, progress);
  fit_radii(complex, shape, progress);
  progress.stage("errors", 1);
  MedialMesh out = medial_mesh(complex, model, shape, progress);
  if (const uint64_t n = out.report.triangles)
    out.notes = std::to_string(n) + (n == 1 ? " triangle" : " triangles") +
                " stayed: sheets without a border, as round a cavity, do not collapse to curves\n";
  return out;
}

} // namespace vbm::impl
