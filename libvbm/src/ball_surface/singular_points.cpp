// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 8.3: dual shape, singular points, and the polygons that connect them.
//
// It differs in that the surface's topology holds by construction, whatever the balls are: the
// boundary of the union, as the dual shape gives it, is a closed surface of patches, arcs and
// singular points (boundary_map.h); points are merged by moves that keep it one (merge_points.h,
// complex_editor.h); and only then does each patch become a polygon (patch_mesh.h).
#include "ball_surface/singular_points.h"

#include "ball_surface/close_narrow.h"
#include "ball_surface/fine_arcs.h"
#include "ball_surface/merge_points.h"
#include "ball_surface/patch_area.h"
#include "ball_surface/patch_mesh.h"
#include "ball_surface/replace_needles.h"
#include "ball_surface/turn_outwards.h"
#include "core/error.h"
#include "core/progress.h"
#include "dual/orthospheres.h"
#include "sampling/checks.h"
#include "sampling/point_table.h"
#include "surface/measure.h"
#include "surface/triangulate.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

/// Steradians: where a ball is more bare, there is nothing closed; it is no strip between others.
constexpr double kMostBare = 1;

/// How often a surface that is folded is made again: with less closed there, or, where nothing was,
/// with so much of its bulge.
constexpr int kAttempts = 2;
constexpr double kFiner = 0.25;

/// What balls, shape and complex say, and the points merged.
struct Merged {
  DualShape shape;
  BoundaryMap map;
  PatchComplex complex;
  std::vector<int32_t> sample;
  bool closed = false; // whether points may have been moved
  std::size_t merged = 0;
};

/// What is narrow at each ball, in unit lengths; empty where nothing is to be closed. Of a union of
/// wide balls every patch is a part of its shape, and its faces are many anyway.
std::vector<double> reaches(const Merged &m, const PatchOptions &options,
                            const std::vector<uint8_t> &keep) {
  const double narrow = options.narrow * (1 - m.map.finer / BoundaryMap::kMostFiner);
  if (!(narrow > 0)) return {};
  std::vector<double> reach = spacings(m.map, m.shape);
  const double most = std::min(options.bulge, kMostNarrow);
  for (std::size_t b = 0; b < reach.size(); ++b) {
    const bool closes = m.map.bare[b] < kMostBare && (keep.empty() || !keep[b]);
    reach[b] = closes ? std::min(narrow * reach[b], most * m.shape.site[b].r) : 0;
  }
  return reach;
}

/// Fills what of it is the shape's.
void find_shape(Merged &m, const UnionInput &set, const PatchOptions &options, double bridge,
                Progress &progress) {
  check_any(set);
  if (options.bridged) {
    std::vector<Ball> larger(set.balls);
    for (Ball &b : larger) b.radius *= 1 + bridge;
    m.shape = dual_shape(larger, set.touch, progress);
  } else {
    m.shape = dual_shape(set.balls, set.touch, progress);
  }
  progress.stage("singular points", 0.8);
  m.map = boundary_map(m.shape, set.balls, options.bridged, progress);
  // Only the map is made of tetrahedra: what they take is the complex's from here on.
  LargeList<PowerDiagram::Cell>().swap(m.shape.cells);
  std::vector<uint8_t>().swap(m.shape.cell_in);
  std::vector<uint8_t>().swap(m.shape.facet_in);
}

/// And the rest. At balls to be kept, where there are any, nothing is closed.
void merge_complex(Merged &m, const UnionInput &set, const PatchOptions &options,
                   const std::vector<uint8_t> &keep, Progress &progress) {
  TouchedSamples touched;
  if (set.model && !options.bridged)
    touched = {&set.model->ball_samples, &set.number, &set.model->samples.position};
  MergedPoints points(m.map.position, m.map.blur, touched.of(m.map, m.shape, progress));
  const std::vector<double> reach = reaches(m, options, keep);
  m.closed = !reach.empty();
  const ContractedArcs gone = contract_arcs(m.map, m.shape, reach, points, progress);
  m.merged = gone.merged;
  m.complex = patch_complex(m.map, m.shape, gone.contracted, options, points, progress);
  ComplexEditor editor(m.complex, m.shape, m.map, std::move(points));
  for (std::size_t p = 0; p < m.complex.patches.size(); ++p) editor.look_at(int32_t(p));
  editor.close(options.bulge, progress);
  if (m.closed) close_narrow(editor, reach, options.bulge, progress);
  refine_arcs(editor, options, progress);
  editor.split_double_arcs(progress);
  uncross_chords(editor, progress);
  m.sample = editor.finish();
}

std::vector<uint8_t> wide_balls(const PatchComplex &complex) {
  std::vector<uint8_t> wide(complex.bare.size());
  for (std::size_t b = 0; b < wide.size(); ++b) wide[b] = complex.wide(int32_t(b));
  return wide;
}

/// Marks the balls of these triangles and of those round them.
void keep_balls(const PatchMesh &mesh, const Triangles &triangles,
                const std::vector<std::size_t> &folded, std::size_t balls,
                std::vector<uint8_t> &keep) {
  keep.resize(balls, 0);
  std::vector<uint8_t> near(mesh.position.size(), 0);
  for (std::size_t t : folded)
    for (int32_t v : triangles.corners[t]) near[v] = 1;
  for (std::size_t t = 0; t < triangles.corners.size(); ++t) {
    const auto &c = triangles.corners[t];
    if (near[c[0]] || near[c[1]] || near[c[2]]) keep[mesh.ball[triangles.polygon[t]]] = 1;
  }
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
  PointTable table(position.size());
  uint64_t doubles = 0;
  for (std::size_t v = 0; v < position.size(); ++v) {
    progress.tick(v, position.size());
    doubles += table.find_or_add(position, position[v], int32_t(v)) != int32_t(v);
  }
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
  Merged m;
  find_shape(m, set, o, options.bridge, progress);
  PatchMesh mesh;
  Triangles triangles;
  std::size_t before = 0, folds = 0;
  std::vector<uint8_t> keep;
  for (int attempt = 0;; ++attempt) {
    merge_complex(m, set, o, keep, progress);
    if (attempt == 0) progress.stage("polygons", 0.9);
    before = m.complex.position.size();
    mesh = patch_mesh(m.complex, m.shape, std::move(m.sample), o, progress);
    triangles = triangulate(mesh.position, mesh.polygons, progress);
    turn_outwards(mesh, m.shape, triangles, progress);
    split_polygons(mesh, m.shape, triangles);
    if (m.closed) replace_needles(mesh, triangles, set.balls, wide_balls(m.complex), progress);
    const std::vector<std::size_t> folded = folded_triangles(mesh, triangles, set.balls, progress);
    folds = folded.size();
    if (folds == 0 || attempt == kAttempts) break;
    if (m.closed)
      keep_balls(mesh, triangles, folded, set.balls.size(), keep);
    else
      o.bulge *= kFiner;
  }

  Surface surface;
  progress.stage("checking", 1);
  fill_vertices(surface, mesh, set, progress);
  vbm_surface_report &report = surface.report;
  report.split_vertices = count_doubles(surface.vertices, progress);
  report.hidden_balls = set.points;
  for (uint8_t in : m.shape.vertex) report.hidden_balls += !in;
  report.singular_points = m.map.position.size();
  report.merged_points = m.merged;
  report.offset_points = m.map.offset_points;
  report.added_points = mesh.position.size() - std::min(before, m.map.position.size() - m.merged);
  surface.triangles = std::move(triangles.corners);
  surface.triangle_polygon = std::move(triangles.polygon);
  surface.polygons = std::move(mesh.polygons);
  surface.polygon_ball = std::move(mesh.ball);
  fill_gaps(surface, set, progress);
  for (int32_t &b : surface.polygon_ball) b = set.number[b];
  if (report.offset_points)
    surface.notes += counted(report.offset_points, "singular point is", "singular points are") +
                     " where three balls do not meet: they are offset by the mean radius.\n";
  if (folds)
    surface.notes += counted(folds, "triangle faces", "triangles face") +
                     " inwards: the surface may cross itself there.\n";
  surface.notes += note_on_points(set);
  measure(surface, progress);
  return surface;
}

} // namespace vbm::impl
