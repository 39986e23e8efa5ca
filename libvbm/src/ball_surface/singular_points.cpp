// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 8.3: dual shape, singular points, and the polygons that connect them.
//
// It differs in that the surface's topology holds by construction, whatever the balls are: the
// boundary of the union, as the dual shape gives it, is a closed surface of patches, arcs and
// singular points (patch_complex.h); points are merged by moves that keep it one (merge_points.h);
// and only then does each patch become a polygon (patch_mesh.h).
#include "ball_surface/singular_points.h"

#include "ball_surface/close_narrow.h"
#include "ball_surface/merge_points.h"
#include "ball_surface/patch_area.h"
#include "ball_surface/patch_mesh.h"
#include "ball_surface/replace_needles.h"
#include "core/error.h"
#include "core/progress.h"
#include "core/tolerances.h"
#include "dual/orthospheres.h"
#include "sampling/checks.h"
#include "surface/measure.h"
#include "surface/triangulate.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

/// What balls, shape and complex say, and the points merged.
struct Merged {
  DualShape shape;
  PatchComplex complex;
  std::vector<int32_t> sample;
  std::size_t singular = 0, merged = 0, offset = 0;
};

Merged merged_complex(const UnionInput &set, const PatchOptions &options, double bridge,
                      Progress &progress) {
  check_any(set);
  Merged m;
  if (options.bridged) {
    std::vector<Ball> larger(set.balls);
    for (Ball &b : larger) b.radius *= 1 + bridge;
    m.shape = dual_shape(larger, set.touch, progress);
  } else {
    m.shape = dual_shape(set.balls, set.touch, progress);
  }
  progress.stage("singular points", 0.8);
  m.complex = patch_complex(m.shape, set.balls, options, progress);
  m.singular = m.complex.singular_points;
  m.offset = m.complex.offset_points;
  TouchedSamples touched;
  if (set.model && !options.bridged)
    touched = {&set.model->ball_samples, &set.number, &set.model->samples.position};
  const std::vector<int32_t> sample = touched.of(m.complex, m.shape, progress);
  std::vector<double> reach;
  if (options.narrow > 0) reach = spacings(m.complex, m.shape);
  for (std::size_t b = 0; b < reach.size(); ++b)
    reach[b] = std::min(options.narrow * reach[b],
                        std::min(options.bulge, kMostNarrow) * m.shape.site[b].r);
  ComplexEditor editor(m.complex, m.shape, sample);
  m.merged = merge_points(editor, sample, options, progress);
  if (options.narrow > 0) close_narrow(editor, reach, options.bulge, progress);
  editor.split_double_arcs(progress);
  m.sample = editor.finish();
  return m;
}

/// Polygons that triangulate() put a vertex in the middle of become the triangles round it.
void split_polygons(PatchMesh &mesh, const DualShape &shape, Triangles &triangles) {
  if (triangles.cut.empty()) return;
  for (int32_t p : triangles.cut) {
    const Site &ball = shape.site[mesh.ball[p]];
    Vec3 sum;
    for (uint64_t i = mesh.polygons.offset[p]; i < mesh.polygons.offset[p + 1]; ++i)
      sum += mesh.position[mesh.polygons.index[i]];
    const Vec3 middle = sum * (1.0 / double(mesh.polygons.offset[p + 1] - mesh.polygons.offset[p]));
    const Vec3 out = unit(middle - center_of(ball));
    mesh.position.push_back(out == Vec3{} ? middle : center_of(ball) + out * ball.r);
    mesh.sample.push_back(-1);
  }
  PatchMesh split;
  std::size_t t = 0, next_cut = 0;
  for (std::size_t p = 0; p < mesh.ball.size(); ++p) {
    const bool cut = next_cut < triangles.cut.size() && triangles.cut[next_cut] == int32_t(p);
    next_cut += cut;
    const auto add = [&](const int32_t *begin, const int32_t *end) {
      split.polygons.index.insert(split.polygons.index.end(), begin, end);
      split.polygons.offset.push_back(split.polygons.index.size());
      split.ball.push_back(mesh.ball[p]);
    };
    if (!cut)
      add(mesh.polygons.index.data() + mesh.polygons.offset[p],
          mesh.polygons.index.data() + mesh.polygons.offset[p + 1]);
    for (; t < triangles.polygon.size() && triangles.polygon[t] == int32_t(p); ++t) {
      if (cut) add(triangles.corners[t].data(), triangles.corners[t].data() + 3);
      triangles.polygon[t] = int32_t(split.ball.size()) - 1;
    }
  }
  mesh.polygons = std::move(split.polygons);
  mesh.ball = std::move(split.ball);
}

/// Counts vertices that stand where another stands.
uint64_t count_doubles(const std::vector<Vec3> &position, Progress &progress) {
  std::vector<Vec3> sorted(position);
  progress.tick_slow(0, 1);
  std::sort(sorted.begin(), sorted.end(), [](const Vec3 &a, const Vec3 &b) {
    if (a.x != b.x) return a.x < b.x;
    return a.y != b.y ? a.y < b.y : a.z < b.z;
  });
  uint64_t doubles = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) doubles += sorted[i] == sorted[i - 1];
  return doubles;
}

void fill_vertices(Surface &surface, const PatchMesh &mesh, const UnionInput &set,
                   Progress &progress) {
  const std::size_t count = mesh.position.size();
  surface.vertices.resize(count);
  surface.vertex_sample = mesh.sample;
  surface.vertex_input.assign(count, -1);
  surface.vertex_radius.assign(count, 0);
  for (std::size_t v = 0; v < count; ++v) {
    progress.tick(v, count);
    const int32_t s = mesh.sample[v];
    if (s < 0) {
      surface.vertices[v] = set.frame.to_input(mesh.position[v]);
    } else {
      surface.vertices[v] = set.model->samples.input_position[s];
      surface.vertex_input[v] = set.model->samples.input[s];
    }
  }
  for (std::size_t p = 0; p < mesh.ball.size(); ++p) {
    progress.tick(p, mesh.ball.size());
    for (uint64_t i = mesh.polygons.offset[p]; i < mesh.polygons.offset[p + 1]; ++i) {
      double &r = surface.vertex_radius[mesh.polygons.index[i]];
      r = std::max(r, set.balls[mesh.ball[p]].radius);
    }
  }
  for (double &r : surface.vertex_radius) r = set.frame.length_to_input(r);
}

} // namespace

Surface singular_point_surface(const UnionInput &set, const vbm_ball_surface_options &options,
                               Progress &progress) {
  PatchOptions o;
  o.bulge = options.bulge;
  o.bridged = options.bridge > 0;
  o.narrow = options.narrow;
  progress.stage("dual shape", 0.6);
  Merged m = merged_complex(set, o, options.bridge, progress);
  progress.stage("polygons", 0.9);
  const std::size_t before = m.complex.position.size();
  PatchMesh mesh = patch_mesh(m.complex, m.shape, std::move(m.sample), o, progress);
  Triangles triangles = triangulate(mesh.position, mesh.polygons, progress);
  split_polygons(mesh, m.shape, triangles);
  if (options.narrow > 0) replace_needles(mesh, triangles, set.balls, progress);

  Surface surface;
  progress.stage("checking", 1);
  fill_vertices(surface, mesh, set, progress);
  vbm_surface_report &report = surface.report;
  report.split_vertices = count_doubles(surface.vertices, progress);
  report.hidden_balls = set.points;
  for (uint8_t in : m.shape.vertex) report.hidden_balls += !in;
  report.singular_points = m.singular;
  report.merged_points = m.merged;
  report.offset_points = m.offset;
  report.added_points = mesh.position.size() - std::min(before, m.singular - m.merged);
  surface.triangles = std::move(triangles.corners);
  surface.triangle_polygon = std::move(triangles.polygon);
  surface.polygons = std::move(mesh.polygons);
  surface.polygon_ball = std::move(mesh.ball);
  fill_gaps(surface, set, progress);
  for (int32_t &b : surface.polygon_ball) b = set.number[b];
  if (report.offset_points)
    surface.notes += counted(report.offset_points, "singular point is", "singular points are") +
                     " where three balls do not meet: they are offset by the mean radius.\n";
  surface.notes += note_on_points(set);
  measure(surface, progress);
  return surface;
}

} // namespace vbm::impl
