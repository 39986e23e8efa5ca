// SPDX-License-Identifier: GPL-3.0-or-later
// Amenta, Kolluri, "The medial axis of a union of balls" (2001), as thesis 7.3.1 and 7.4 have it:
// power shape, singular points, their Voronoi diagram, no duplicates. It differs in that
// - what of the Voronoi diagram is inside is taken as a complex dual to tetrahedra, so that it has
// a
//   known homotopy type, whatever rounding does; of the fins by which the faces between neighbours
//   on one side of the shape stick out of the axis, none are in it;
// - that type is compared with the solid's. Thin sampling can make the union of polar balls another
//   shape; then the singular points where the sampling is too thin are left out, and only samples
//   are sites there; if that is not enough, everywhere: that is the other construction, whose
//   diagram has the solid's type whatever the sampling;
// - cells that tell nothing about the shape are then collapsed, by the same measures as in the
// other
//   construction.
#include "medial/power_shape_axis.h"

#include "core/disjoint_sets.h"
#include "core/progress.h"
#include "medial/power_shape.h"
#include "medial/singular_voronoi.h"
#include "surface/boundary.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace vbm::impl {
namespace {

/// Ratios to the local feature size, one for each attempt: singular points farther than that from a
/// sample are left out. Only where balls of an r-sample with a small r meet is it sure that they do
/// so near the surface. After the last attempt there are samples only.
constexpr double kReach[] = {HUGE_VAL, 0.25, 0.1, 0.025};
constexpr int kAttempts = int(std::size(kReach));

/// What tells solids of different homotopy types apart.
struct Topology {
  uint64_t components, cavities_and_components;
  int64_t euler;

  bool operator==(const Topology &other) const {
    return components == other.components &&
           cavities_and_components == other.cavities_and_components && euler == other.euler;
  }
};

Topology topology(const DualComplex &complex, const Model &solid, Progress &progress) {
  Topology out;
  DisjointSets sets(complex.ball.size());
  out.components = complex.ball.size();
  for (const auto &[u, v] : complex.edge) out.components -= sets.unite(u, v);
  out.cavities_and_components =
      find_boundary(solid.cells, solid.inside, progress).components(progress);
  out.euler = int64_t(complex.ball.size()) - int64_t(complex.edge.size()) +
              int64_t(complex.faces()) -
              int64_t(std::count(complex.solid.begin(), complex.solid.end(), 1));
  return out;
}

/// Whether the complex has no closed sheet in it: all its faces can be collapsed away.
bool erodes(const DualComplex &complex, const SingularVoronoi &voronoi, Progress &progress) {
  const std::vector<double> spacing(voronoi.near_sample.size(), HUGE_VAL);
  AxisOptions nothing; // is kept where samples are that far apart
  nothing.spacing = &spacing;
  const Collapsed left = collapse(complex, voronoi.solid, nothing, progress);
  return std::find(left.face.begin(), left.face.end(), 1) == left.face.end();
}

/// Which singular points are near enough to a sample.
std::vector<uint8_t> choose(const Model &model, const PowerShape &shape, double reach,
                            Progress &progress) {
  std::vector<uint8_t> take(shape.points.size());
  for (std::size_t i = 0; i < take.size(); ++i) {
    progress.tick(0, 1);
    const SingularPoint &point = shape.points[i];
    const int32_t s = point.near_sample;
    double feature = HUGE_VAL;
    for (int32_t pole : {model.inner_pole[s], model.outer_pole[s]})
      feature = pole < 0 ? 0 : std::min(feature, model.balls[pole].radius);
    // Not "<=": everything is near enough at first, also where no ball tells the feature size.
    take[i] = !(distance(model.samples.position[s], point.position) > reach * feature);
  }
  return take;
}

std::string describe(const PowerShape &shape, uint64_t left_out) {
  const auto at_samples = std::count_if(shape.points.begin(), shape.points.end(),
                                        [](const SingularPoint &p) { return p.sample >= 0; });
  std::string out = "power shape: " + std::to_string(shape.tetrahedra) + " tetrahedra, " +
                    std::to_string(shape.regular) + " regular and " +
                    std::to_string(shape.singular) + " singular triangles; " +
                    std::to_string(shape.points.size()) + " singular points, " +
                    std::to_string(at_samples) + " of them at samples\n";
  if (left_out)
    out +=
        "the union of the balls has another topology than the shape: " + std::to_string(left_out) +
        " singular points were left out where the sampling is too thin\n";
  return out;
}

/// The widest gap between samples next to each site, as the other construction measures it.
std::vector<double> site_spacing(const Model &model, const SingularVoronoi &voronoi,
                                 Progress &progress) {
  const std::vector<double> at_samples = sample_spacing(model, progress);
  std::vector<double> out;
  for (int32_t s : voronoi.near_sample) out.push_back(at_samples[s]);
  return out;
}

/// The axis's vertex of each vertex of the complex that is left.
std::vector<int32_t> numbers(const Collapsed &left) {
  std::vector<int32_t> out(left.vertex.size(), -1);
  int32_t next = 0;
  for (std::size_t v = 0; v < out.size(); ++v)
    if (left.vertex[v]) out[v] = next++;
  return out;
}

/// Balls that have no tetrahedron of their own go with the vertex of one at a sample they touch.
void place_balls(const Model &model, const SingularVoronoi &voronoi, const DualComplex &complex,
                 const Collapsed &left, AxisCells &cells, Progress &progress) {
  const std::vector<int32_t> number = numbers(left);
  std::vector<int32_t> vertex_of_site(voronoi.near_sample.size(), -1);
  std::vector<double> radius(vertex_of_site.size(), -1);
  for (std::size_t c = 0; c < voronoi.solid.cells.size(); ++c) {
    progress.tick(0, 1);
    const int32_t v = complex.vertex_of_cell[c];
    if (v < 0) continue;
    for (int32_t s : voronoi.solid.cells.vertex[c])
      if (complex.ball[v].radius > radius[s]) {
        radius[s] = complex.ball[v].radius;
        vertex_of_site[s] = number[left.root[v]];
      }
  }
  for (std::size_t b = 0; b < model.inner; ++b)
    for (uint64_t k = model.ball_samples.offset[b];
         cells.vertex_of_ball[b] < 0 && k < model.ball_samples.offset[b + 1]; ++k)
      cells.vertex_of_ball[b] = vertex_of_site[model.ball_samples.index[k]];
}

/// The sites of every triangle, and the samples next to them; two different ones.
void name_samples(const SingularVoronoi &voronoi, AxisCells &cells) {
  const std::vector<Vec3> &site = voronoi.solid.samples.position;
  for (auto &[a, b] : cells.triangle_samples) {
    cells.triangle_points.push_back({site[a], site[b]});
    const int32_t first = voronoi.near_sample[a], second = voronoi.near_sample[b];
    if (first != second) {
      a = first, b = second;
    } else if (voronoi.next_sample[b] >= 0) {
      a = first, b = voronoi.next_sample[b];
    } else {
      a = voronoi.next_sample[a], b = second;
    }
  }
}

} // namespace

AxisCells power_shape_axis(const Model &model, const AxisOptions &options, std::string &notes,
                           Progress &progress) {
  progress.stage("Voronoi diagram inside", 0.1);
  const DualComplex of_samples = dual_complex(model, progress);
  const Topology wanted = topology(of_samples, model, progress);
  progress.stage("power shape", 0.4);
  const PowerShape shape = power_shape(model, progress);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    progress.stage("Voronoi diagram of singular points", 0.7 + 0.03 * attempt);
    const std::vector<uint8_t> take = choose(model, shape, kReach[attempt], progress);
    const SingularVoronoi voronoi = singular_voronoi(model, shape, take, progress);
    const DualComplex complex = dual_complex(voronoi.solid, progress, &voronoi.balls);
    if (!(topology(complex, voronoi.solid, progress) == wanted)) continue;
    // Where near duplicates make balls of no account, cells of one ball may enclose others.
    if (wanted.cavities_and_components == wanted.components && !erodes(complex, voronoi, progress))
      continue;
    notes += describe(shape, uint64_t(std::count(take.begin(), take.end(), 0)));
    progress.stage("collapsing", 0.85);
    const std::vector<double> spacing = site_spacing(model, voronoi, progress);
    AxisOptions what = options;
    what.spacing = &spacing;
    const Collapsed left = collapse(complex, voronoi.solid, what, progress);
    progress.stage("medial axis", 0.9);
    AxisCells cells = axis_cells(complex, left, voronoi.solid, progress);
    place_balls(model, voronoi, complex, left, cells, progress);
    name_samples(voronoi, cells);
    return cells;
  }
  notes += describe(shape, shape.points.size());
  progress.stage("collapsing", 0.85);
  const Collapsed left = collapse(of_samples, model, options, progress);
  progress.stage("medial axis", 0.9);
  return axis_cells(of_samples, left, model, progress);
}

} // namespace vbm::impl
