// SPDX-License-Identifier: GPL-3.0-or-later
// Amenta, Choi, Kolluri, "The power crust, unions of balls, and the medial axis transform" (2001):
// the faces between inner and outer cells in the power diagram of the polar balls. It differs in
// that vertices are merged, where the surface stays what it is, until few are left that are no
// samples; and in that a crust of all balls whose topology is not that of the inside tetrahedra is
// made again with more balls, in the end with all Voronoi balls: their power cells are the Delaunay
// tetrahedra (see crust_selection.cpp), so that crust is the interpolating surface.
#include "surface/power_crust.h"

#include "core/error.h"
#include "surface/boundary.h"
#include "surface/crust_complex.h"
#include "surface/crust_merge.h"
#include "surface/crust_selection.h"
#include "surface/crust_vertices.h"
#include "surface/interpolating.h"
#include "surface/measure.h"
#include "surface/power_diagram.h"
#include "surface/triangulate.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace vbm::impl {
namespace {

/// Attempts at a crust with the topology of the inside tetrahedra: the model's balls alone, and
/// with Voronoi balls where the sampling is thin.
constexpr int kAttempts = 2;

/// Part of the diagonal of the samples' box. A crust that reaches farther beyond the box is not of
/// the shape they are on: spheres and round ends of as few samples as have an inside stand out by
/// half of this.
constexpr double kFarBeyond = 0.1;
/// Ratio of volumes: a crust that holds so much more than the inside tetrahedra is not near them.
constexpr double kFarMore = 1.2;

/// Whether the crust has the components and handles of the solid. Sampled thinly, even balls with
/// the right labels can meet across a gap or miss each other across a neck.
bool same_topology(const CrustComplex &crust, const Boundary &boundary, Progress &progress) {
  return crust.euler() == boundary.euler() && crust.components == boundary.components(progress);
}

/// How far the crust reaches beyond the samples' bounding box, in parts of the box's diagonal.
/// Where balls are right they stand out by little; where samples lie on a shape's ends alone, a
/// ball through them holds its sides.
double beyond_samples(const std::vector<Vec3> &position, const std::vector<Vec3> &samples) {
  Vec3 low = samples[0], high = low;
  for (const Vec3 &p : samples)
    for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
  double most = 0;
  for (const Vec3 &p : position)
    for (int a = 0; a < 3; ++a) most = std::max({most, low[a] - p[a], p[a] - high[a]});
  return most / distance(low, high);
}

double volume_within(const CrustMesh &mesh) {
  double sum = 0;
  const Vec3 origin = mesh.position.empty() ? Vec3{} : mesh.position[0];
  for (std::size_t p = 0; p + 1 < mesh.polygons.offset.size(); ++p) {
    const int32_t *v = mesh.polygons.index.data();
    const Vec3 a = mesh.position[v[mesh.polygons.offset[p]]] - origin;
    for (uint64_t i = mesh.polygons.offset[p] + 2; i < mesh.polygons.offset[p + 1]; ++i)
      sum += dot(a, cross(mesh.position[v[i - 1]] - origin, mesh.position[v[i]] - origin));
  }
  return std::fabs(sum) / 6;
}

double volume_of_tetrahedra(const Model &model, Progress &progress) {
  const std::vector<Vec3> &at = model.samples.position;
  double sum = 0;
  for (std::size_t c = 0; c < model.cells.size(); ++c) {
    progress.tick(0, 1);
    if (!model.inside[c]) continue;
    const auto &k = model.cells.vertex[c];
    sum += std::fabs(dot(cross(at[k[1]] - at[k[0]], at[k[2]] - at[k[0]]), at[k[3]] - at[k[0]]));
  }
  return sum / 6;
}

/// Give polygons in `cut` a vertex in their middle, and make them triangles.
void split_polygons(CrustMesh &mesh, Triangles &triangles) {
  if (triangles.cut.empty()) return;
  CrustMesh old;
  std::swap(old.polygons, mesh.polygons);
  std::swap(old.inner, mesh.inner);
  const std::size_t count = old.inner.size();
  std::vector<int32_t> number(count); // of each polygon, or of the first of its triangles
  std::size_t next_cut = 0;
  for (std::size_t p = 0; p < count; ++p) {
    const int32_t *begin = old.polygons.index.data() + old.polygons.offset[p];
    const int32_t *end = old.polygons.index.data() + old.polygons.offset[p + 1];
    number[p] = int32_t(mesh.inner.size());
    if (next_cut < triangles.cut.size() && std::size_t(triangles.cut[next_cut]) == p) {
      ++next_cut;
      const int32_t middle = int32_t(mesh.position.size());
      Vec3 sum;
      for (const int32_t *v = begin; v != end; ++v) sum += mesh.position[*v];
      mesh.position.push_back(sum * (1.0 / double(end - begin)));
      mesh.sample.push_back(-1);
      for (const int32_t *v = begin; v != end; ++v) {
        mesh.polygons.index.insert(mesh.polygons.index.end(),
                                   {v == begin ? end[-1] : v[-1], *v, middle});
        mesh.polygons.offset.push_back(mesh.polygons.index.size());
        mesh.inner.push_back(old.inner[p]);
      }
    } else {
      mesh.polygons.index.insert(mesh.polygons.index.end(), begin, end);
      mesh.polygons.offset.push_back(mesh.polygons.index.size());
      mesh.inner.push_back(old.inner[p]);
    }
  }
  std::vector<uint8_t> is_cut(count, 0);
  for (int32_t p : triangles.cut) is_cut[p] = 1;
  int32_t k = 0; // of the triangles of one polygon
  int32_t last = -1;
  for (int32_t &polygon : triangles.polygon) {
    const int32_t p = polygon;
    k = p == last ? k + 1 : 0;
    last = p;
    polygon = number[p] + (is_cut[p] ? k : 0);
  }
}

void fill_vertices(Surface &surface, const CrustMesh &mesh, const Model &model,
                   const Selection &selected, Progress &progress) {
  const Samples &samples = model.samples;
  const std::size_t count = mesh.position.size();
  surface.vertices.resize(count);
  surface.vertex_sample = mesh.sample;
  surface.vertex_input.assign(count, -1);
  surface.vertex_radius.assign(count, 0);
  for (std::size_t p = 0; p < mesh.inner.size(); ++p) {
    progress.tick(p, mesh.inner.size());
    for (uint64_t i = mesh.polygons.offset[p]; i < mesh.polygons.offset[p + 1]; ++i) {
      double &r = surface.vertex_radius[mesh.polygons.index[i]];
      r = std::max(r, selected.balls[mesh.inner[p]].radius);
    }
  }
  std::vector<uint8_t> kept(model.inner, 0);
  for (std::size_t b = 0; b < selected.inner; ++b)
    if (const std::size_t o = std::size_t(selected.origin[b]); o < model.inner) kept[o] = 1;
  std::vector<uint8_t> used(samples.position.size(), 0);
  for (std::size_t v = 0; v < count; ++v) {
    progress.tick(v, count);
    const int32_t s = mesh.sample[v];
    if (s < 0) {
      surface.vertices[v] = samples.frame.to_input(mesh.position[v]);
    } else {
      surface.vertices[v] = samples.input_position[s];
      surface.vertex_input[v] = samples.input[s];
      surface.report.split_vertices += used[s];
      used[s] = 1;
      const int32_t pole = model.inner_pole[s];
      if (pole >= 0 && kept[pole]) surface.vertex_radius[v] = model.balls[pole].radius;
    }
    surface.vertex_radius[v] = samples.frame.length_to_input(surface.vertex_radius[v]);
  }
}

Surface crust_of_voronoi_balls(const Model &model, const char *why, Progress &progress) {
  progress.stage("interpolating surface", 1);
  Surface surface = interpolating_surface(model, progress);
  for (std::size_t p = 0; p < surface.polygon_ball.size(); ++p)
    for (uint64_t i = surface.polygons.offset[p]; i < surface.polygons.offset[p + 1]; ++i)
      if (const int32_t s = surface.vertex_sample[surface.polygons.index[i]];
          s >= 0 && surface.polygon_ball[p] < 0)
        surface.polygon_ball[p] = model.inner_pole[s];
  surface.notes += std::string("the sampling is too thin for a power crust of polar balls ") + why +
                   "; this is the crust of all Voronoi balls, which is the interpolating surface\n";
  return surface;
}

} // namespace

Surface power_crust(const Model &model, const uint8_t *keep, const uint8_t *keep_outer,
                    Progress &progress) {
  if (keep && std::count(keep, keep + model.inner, 0) == 0) keep = nullptr;
  Selection selected;
  CrustMesh mesh;
  uint64_t clamped = 0;
  progress.stage("power diagram", 0.02);
  const Boundary boundary = keep ? Boundary{} : find_boundary(model.cells, model.inside, progress);
  const char *failure = "";
  double beyond = 0;
  for (int attempt = 0;; ++attempt) {
    if (attempt == kAttempts) return crust_of_voronoi_balls(model, failure, progress);
    progress.stage("power diagram", attempt ? 0.86 : 0.7);
    selected =
        attempt ? select_with_support(model, progress) : select_balls(model, keep, keep_outer);
    PowerDiagram diagram = power_diagram(selected.balls, selected.inner, progress);
    progress.stage("power crust", attempt ? 0.88 : 0.85);
    const CrustComplex crust =
        crust_complex(std::move(diagram), selected.balls.size(), selected.inner, progress);
    failure = "with the solid's components and handles";
    if (!keep && !same_topology(crust, boundary, progress)) continue;
    const CrustVertices vertices = crust_vertices(crust, model, selected, progress);
    clamped = vertices.clamped;
    mesh = merge_crust(crust, vertices, selected.balls, model, progress);
    beyond = beyond_samples(mesh.position, model.samples.position);
    failure = "that stays near the samples";
    if (keep || (beyond <= kFarBeyond &&
                 volume_within(mesh) <= kFarMore * volume_of_tetrahedra(model, progress)))
      break;
  }
  progress.stage("triangles", 0.95);
  Triangles triangles = triangulate(mesh.position, mesh.polygons, progress);
  split_polygons(mesh, triangles);

  Surface surface;
  fill_vertices(surface, mesh, model, selected, progress);
  surface.triangles = std::move(triangles.corners);
  surface.triangle_polygon = std::move(triangles.polygon);
  surface.polygons = std::move(mesh.polygons);
  surface.polygon_ball = std::move(mesh.inner);
  for (int32_t &b : surface.polygon_ball) b = selected.model_ball(model, b);
  progress.stage("checking", 1);
  measure(surface, progress);
  if (clamped)
    surface.notes +=
        std::to_string(clamped) + (clamped == 1 ? " corner" : " corners") +
        " of the power crust's faces would lie far off the balls, and were drawn back to "
        "them\n";
  const uint64_t thin = model.undersampled.size(), samples = model.samples.position.size();
  if (2 * thin > samples)
    surface.notes += "the sampling is too thin to trust the surface at " + std::to_string(thin) +
                     " of " + std::to_string(samples) + " samples\n";
  if (beyond > kFarBeyond)
    surface.notes += "the surface reaches beyond the samples by " +
                     std::to_string(std::lround(100 * beyond)) +
                     " % of their box's diagonal: the sampling is too thin for these balls\n";
  return surface;
}

} // namespace vbm::impl
