// SPDX-License-Identifier: GPL-3.0-or-later
#include "medial/medial_mesh.h"

#include "core/disjoint_sets.h"
#include "medial/mesh_errors.h"

#include <algorithm>

namespace vbm::impl {
namespace {

void count_cells(const BallComplex &complex, vbm_medial_mesh_report &report) {
  const auto edges = all_edges(complex);
  report.vertices = complex.ball.size();
  report.triangles = complex.triangle.size();
  report.edges = edges.size();
  report.curve_edges = complex.edge.size();
  report.euler = int64_t(report.vertices) - int64_t(report.edges) + int64_t(report.triangles);
  DisjointSets sets(complex.ball.size());
  report.components = complex.ball.size();
  for (const auto &e : edges) report.components -= sets.unite(e[0], e[1]);
}

} // namespace

MedialMesh medial_mesh(const BallComplex &complex, const Model &model, const MeshErrors &errors) {
  MedialMesh out;
  const Frame &frame = model.samples.frame;
  for (const Ball &ball : complex.ball) {
    const Vec3 p = frame.to_input(ball.center);
    out.vertices.insert(out.vertices.end(), {p.x, p.y, p.z});
    out.radii.push_back(frame.length_to_input(ball.radius));
  }
  for (const auto &t : complex.triangle)
    out.triangles.insert(out.triangles.end(), t.begin(), t.end());
  for (const auto &e : complex.edge) out.edges.insert(out.edges.end(), e.begin(), e.end());

  vbm_medial_mesh_report &report = out.report;
  report.struct_size = sizeof report;
  count_cells(complex, report);
  report.diagonal = model.report.diagonal;
  const double unit = frame.length_to_unit(model.report.diagonal);
  const double scale = unit > 0 ? 1 / unit : 0;
  report.sample_error_max = errors.sample_max * scale;
  report.sample_error_mean = errors.sample_mean * scale;
  report.envelope_error_max = errors.envelope_max * scale;
  report.envelope_error_mean = errors.envelope_mean * scale;
  report.error_max = std::max(report.sample_error_max, report.envelope_error_max);
  report.error_mean = (report.sample_error_mean + report.envelope_error_mean) / 2;
  return out;
}

} // namespace vbm::impl
