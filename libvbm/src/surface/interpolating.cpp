// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/interpolating.h"

#include "core/error.h"
#include "surface/boundary.h"
#include "surface/measure.h"

#include <algorithm>

namespace vbm::impl {

namespace {

class Extraction {
public:
  Extraction(const Model &model, Progress &progress) : model_(model), progress_(progress) {}

  Surface run() {
    boundary_ = find_boundary(model_.cells, model_.inside, progress_);
    if (boundary_.triangle.empty())
      throw Error(VBM_ERROR_NO_INTERIOR,
                  "no Delaunay tetrahedron is inside, so there is no surface");
    surface_.triangles = boundary_.triangle;
    surface_.vertex_sample = std::move(boundary_.sample);
    surface_.vertices.reserve(surface_.vertex_sample.size());
    progress_.tick_slow(1, 1);
    for (int32_t s : surface_.vertex_sample)
      surface_.vertices.push_back(model_.samples.input_position[s]);
    split_shared_edges();
    fill_tables();
    surface_.report.split_vertices = boundary_.split;
    measure(surface_, progress_);
    return std::move(surface_);
  }

private:
  /// Two sheets that touch along an edge can still have both its ends in common, joined elsewhere
  /// round. Named by vertices alone the edge would then lie in four triangles, so every pair of
  /// triangles there but the first gets a vertex of its own in the middle of the edge.
  void split_shared_edges() {
    struct Pair {
      int32_t low, high, f, e;
    };
    std::vector<Pair> pairs;
    for (int32_t f = 0; f < int32_t(boundary_.mate.size()); ++f) {
      progress_.tick(1, 1);
      for (int e = 0; e < 3; ++e)
        if (boundary_.mate[f][e] > f) {
          const int32_t a = surface_.triangles[f][e], b = surface_.triangles[f][(e + 1) % 3];
          pairs.push_back({std::min(a, b), std::max(a, b), f, e});
        }
    }
    std::vector<uint32_t> first(surface_.vertices.size() + 1, 0), order(pairs.size());
    for (const Pair &p : pairs) ++first[p.low + 1];
    for (std::size_t v = 0; v + 1 < first.size(); ++v) first[v + 1] += first[v];
    std::vector<uint32_t> next(first.begin(), first.end() - 1);
    progress_.tick_slow(1, 1);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      progress_.tick(1, 1);
      order[next[pairs[i].low]++] = uint32_t(i);
    }
    std::vector<Pair> shared;
    for (std::size_t v = 0; v + 1 < first.size(); ++v) {
      progress_.tick(1, 1);
      for (uint32_t i = first[v]; i < first[v + 1]; ++i)
        for (uint32_t j = first[v]; j < i; ++j)
          if (pairs[order[i]].high == pairs[order[j]].high) {
            shared.push_back(pairs[order[i]]);
            break;
          }
    }
    if (shared.empty()) return;
    // Middles per triangle edge, then each triangle that has any is cut at them.
    std::vector<int32_t> middle(3 * boundary_.mate.size(), -1);
    for (const Pair &p : shared) {
      const int32_t m = int32_t(surface_.vertices.size());
      middle_of_.push_back({p.low, p.high});
      surface_.vertices.push_back(surface_.vertices[p.low] * 0.5 + surface_.vertices[p.high] * 0.5);
      surface_.vertex_sample.push_back(-1);
      const int32_t g = boundary_.mate[p.f][p.e];
      middle[3 * p.f + p.e] = m;
      middle[3 * g + edge_of(g, p.f)] = m;
      ++boundary_.split;
    }
    const std::size_t whole = boundary_.mate.size();
    for (std::size_t f = 0; f < whole; ++f) cut(int32_t(f), &middle[3 * f]);
  }

  /// The edge of triangle t across which triangle f lies, by its own mates: a triangle is never
  /// joined to the same one across two edges.
  int edge_of(int32_t t, int32_t f) const {
    const auto &mates = boundary_.mate[t];
    return mates[0] == f ? 0 : mates[1] == f ? 1 : 2;
  }

  void cut(int32_t f, const int32_t *middle) {
    std::vector<int32_t> ring;
    for (int i = 0; i < 3; ++i) {
      ring.push_back(surface_.triangles[f][i]);
      if (middle[i] >= 0) ring.push_back(middle[i]);
    }
    if (ring.size() == 3) return;
    // A fan about a middle vertex never folds: start at the first one.
    const int start = middle[0] >= 0 ? 1 : middle[1] >= 0 ? 2 : 3;
    std::rotate(ring.begin(), ring.begin() + start, ring.end());
    surface_.triangles[f] = {ring[0], ring[1], ring[2]};
    for (std::size_t i = 2; i + 1 < ring.size(); ++i) {
      surface_.triangles.push_back({ring[0], ring[i], ring[i + 1]});
      boundary_.cell.push_back(boundary_.cell[f]);
    }
  }

  void fill_tables() {
    const std::size_t n = surface_.vertices.size(), m = surface_.triangles.size();
    surface_.vertex_input.resize(n);
    surface_.vertex_radius.assign(n, 0);
    surface_.triangle_polygon.resize(m);
    surface_.polygon_ball.resize(m);
    surface_.polygons.offset.resize(m + 1);
    surface_.polygons.index.reserve(3 * m);
    for (std::size_t v = 0; v < n; ++v) {
      progress_.tick(1, 1);
      const int32_t s = surface_.vertex_sample[v];
      surface_.vertex_input[v] = s < 0 ? -1 : model_.samples.input[s];
      if (s >= 0 && model_.inner_pole[s] >= 0)
        surface_.vertex_radius[v] = model_.radii[model_.inner_pole[s]];
    }
    for (std::size_t i = 0; i < middle_of_.size(); ++i)
      surface_.vertex_radius[n - middle_of_.size() + i] = std::min(
          surface_.vertex_radius[middle_of_[i][0]], surface_.vertex_radius[middle_of_[i][1]]);
    for (std::size_t t = 0; t < m; ++t) {
      progress_.tick(1, 1);
      surface_.triangle_polygon[t] = int32_t(t);
      surface_.polygons.offset[t + 1] = 3 * (t + 1);
      for (int32_t v : surface_.triangles[t]) surface_.polygons.index.push_back(v);
      surface_.polygon_ball[t] = model_.ball_of_cell[boundary_.cell[t]];
    }
  }

  const Model &model_;
  Progress &progress_;
  Boundary boundary_; // triangles cut later are appended to its `cell` alone
  std::vector<std::array<int32_t, 2>> middle_of_; // ends of the edges that the last vertices halve
  Surface surface_;
};

} // namespace

Surface interpolating_surface(const Model &model, Progress &progress) {
  return Extraction(model, progress).run();
}

} // namespace vbm::impl
