// SPDX-License-Identifier: GPL-3.0-or-later
// Edelsbrunner, "Deformable smooth surface design" (1999), with the balls grown so that they are
// inside and touch it, as in CGAL's Skin_surface_3. CGAL's own is not used: it has no place for
// progress or cancelling, ends the process where GMP runs out of memory, and takes several times as
// long (vbm_bench_balls --skin).
#include "ball_surface/skin.h"

#include "ball_surface/boundary_map.h"
#include "ball_surface/skin_mesh.h"
#include "core/error.h"
#include "core/progress.h"
#include "surface/measure.h"

#include <algorithm>

namespace vbm::impl {
namespace {

/// Ratios of the longest edge that is contracted to the bulge. Where balls overlap much, edges as
/// long as the bulge may be far from a ball's sphere in the creases, which bend more; wide balls'
/// patches are larger than that.
constexpr double kShort = 1.0 / 3, kShortWide = 0.6;

/// How often slivers are flipped, after which more edges may be contracted.
constexpr int kMostRounds = 4;

/// Finer where balls are wide, as for singular points.
SkinDetail detail_of(const UnionInput &set, const MixedComplex &mixed, double bulge,
                     Progress &progress) {
  const DualShape shape = dual_shape(set.balls, set.touch, progress);
  const BoundaryMap map = boundary_map(shape, set.balls, false, progress);
  const double fine = fine_bulge(bulge, map.finer);
  SkinDetail detail; // far corners are no balls
  detail.least.assign(set.balls.size() + 4, 0);
  detail.shortest.assign(set.balls.size() + 4, 0);
  for (std::size_t b = 0; b < set.balls.size(); ++b) {
    const bool wide = map.wide(int32_t(b));
    const double r = mixed.radius(int32_t(b));
    detail.least[b] = (wide ? fine : bulge) * r;
    detail.shortest[b] = (wide ? kShortWide : kShort) * bulge * r;
  }
  return detail;
}

void fill_tables(Surface &surface, const SkinMesh &mesh, const UnionInput &set,
                 Progress &progress) {
  const std::size_t count = mesh.position.size();
  surface.vertices.resize(count);
  surface.vertex_sample.assign(count, -1);
  surface.vertex_input.assign(count, -1);
  surface.vertex_radius.assign(count, 0);
  for (std::size_t v = 0; v < count; ++v) {
    progress.tick(v, count);
    surface.vertices[v] = set.frame.to_input(mesh.position[v]);
  }
  const std::size_t triangles = mesh.triangles.size();
  surface.triangles.reserve(triangles);
  for (const SkinMesh::Triangle &t : mesh.triangles) {
    progress.tick(0, 1);
    surface.triangle_polygon.push_back(int32_t(surface.triangles.size()));
    surface.triangles.push_back(t.vertex);
    const bool real = std::size_t(t.ball) < set.balls.size();
    surface.polygon_ball.push_back(real ? t.ball : -1);
    for (int32_t v : t.vertex) {
      surface.polygons.index.push_back(v);
      if (real)
        surface.vertex_radius[v] = std::max(surface.vertex_radius[v], set.balls[t.ball].radius);
    }
    surface.polygons.offset.push_back(surface.polygons.index.size());
  }
  for (double &r : surface.vertex_radius) r = set.frame.length_to_input(r);
}

} // namespace

Surface skin_surface(const UnionInput &set, const vbm_ball_surface_options &options,
                     Progress &progress) {
  check_any(set);
  progress.stage("mixed complex", 0.35);
  const MixedComplex mixed(set.balls, options.shrink, progress);
  progress.stage("sizes of faces", 0.4);
  const SkinDetail detail = detail_of(set, mixed, options.bulge, progress);
  progress.stage("skin", 0.65);
  SkinMesh mesh = march(mixed, progress);
  progress.stage("triangles", 0.95);
  refine(mesh, mixed, detail, progress); // first: each triangle is in its mixed cell yet
  contract(mesh, detail, progress);
  for (int round = 0; round < kMostRounds; ++round) {
    const std::size_t turned = flip_slivers(mesh, detail, progress);
    if (turned + unfold(mesh, detail, progress) == 0) break;
    contract(mesh, detail, progress);
  }
  if (mesh.triangles.empty())
    throw Error(VBM_ERROR_NO_INTERIOR,
                "the balls are too small beside each other's distances for a skin surface");

  Surface surface;
  progress.stage("checking", 1);
  fill_tables(surface, mesh, set, progress);
  fill_gaps(surface, set, progress);
  surface.report.hidden_balls = set.points + mixed.hidden();
  surface.report.added_points = mesh.position.size();
  for (int32_t &b : surface.polygon_ball)
    if (b >= 0) b = set.number[b];
  surface.notes += "the skin has the components and handles of the balls with their radii "
                   "divided by the square root of the shrink factor, not of the balls as they "
                   "are\n";
  surface.notes += note_on_points(set);
  measure(surface, progress);
  return surface;
}

} // namespace vbm::impl
