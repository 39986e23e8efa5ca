// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_surface.h"

#include <vbm/vbm.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <vector>

namespace {

/// A surface may reach this many bounding-box diagonals of its samples out of their box, however
/// few they are: the crust of a box's eight corners is a larger octahedron.
constexpr double kNeedle = 8;
/// Samples: a power crust of fewer is not held to be anywhere near them.
constexpr std::size_t kFew = 50;
/// Shares of the diagonal cubed: rounding of a volume that is nothing.
constexpr double kFlat = 1e-17;
/// Ratio to the squares of a triangle's sides: rounding of its area in doubles.
constexpr double kRounding = 1e-15;

using Edge = std::pair<int32_t, int32_t>;

class SurfaceCheck {
public:
  SurfaceCheck(const vbm_surface *surface, const vbm_model *model)
      : surface_(surface), model_(model), vertices_(get<3>(surface, vbm_surface_vertices)),
        triangles_(get<3>(surface, vbm_surface_triangles)) {
    std::memset(&report_, 0, sizeof report_);
    report_.struct_size = sizeof report_;
    problems_.require(vbm_surface_get_report(surface, &report_) == VBM_OK, "no report");
    polygons_.indices.data =
        vbm_surface_polygons(surface, &polygons_.offsets.data, &polygons_.indices.size);
    if (polygons_.offsets.data) polygons_.offsets.size = report_.polygons + 1;
  }

  Problems run(Topology *found) {
    ranges();
    if (!problems_.none()) return problems_;
    extent();
    fans();
    polygons();
    tables();
    measures();
    if (found) *found = topology_;
    return problems_;
  }

private:
  template <std::size_t Width = 1, class Handle, class T>
  static vbm::View<T, Width> get(const Handle *handle, const T *(*view)(const Handle *, size_t *)) {
    vbm::View<T, Width> out;
    out.data = view(handle, &out.size);
    return out;
  }

  void ranges() {
    if (vertices_.size < 4 || triangles_.size < 4)
      problems_.add("not even a tetrahedron: " + std::to_string(vertices_.size) + " vertices, " +
                    std::to_string(triangles_.size) + " triangles");
    problems_.require(report_.vertices == vertices_.size, "report: vertices");
    problems_.require(report_.triangles == triangles_.size, "report: triangles");
    const int32_t n = int32_t(vertices_.size);
    for (std::size_t t = 0; t < triangles_.size; ++t) {
      const int32_t *v = triangles_[t];
      for (int i = 0; i < 3; ++i)
        problems_.require(v[i] >= 0 && v[i] < n, "a vertex that is not there", t);
      problems_.require(v[0] != v[1] && v[1] != v[2] && v[2] != v[0], "a corner twice", t);
    }
    problems_.require(polygons_.size() == report_.polygons, "report: polygons");
    if (!polygons_.offsets.data) return problems_.add("no polygons");
    problems_.require(polygons_.offsets[report_.polygons] == polygons_.indices.size,
                      "polygons do not end at count");
    for (std::size_t p = 0; p < polygons_.size(); ++p)
      problems_.require(polygons_.offsets[p] + 3 <= polygons_.offsets[p + 1],
                        "a polygon of fewer than three corners", p);
    for (std::size_t i = 0; i < polygons_.indices.size; ++i)
      problems_.require(polygons_.indices[i] >= 0 && polygons_.indices[i] < n,
                        "a polygon's vertex that is not there", i);
  }

  /// Finite, and no needle out of the samples' box.
  void extent() {
    const auto samples = get<3>(model_, vbm_model_samples);
    vbm_model_report model;
    model.struct_size = sizeof model;
    vbm_model_get_report(model_, &model);
    const double inf = std::numeric_limits<double>::infinity();
    double low[3] = {inf, inf, inf}, high[3] = {-inf, -inf, -inf};
    for (std::size_t s = 0; s < samples.size; ++s)
      for (int a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], samples[s][a]);
        high[a] = std::max(high[a], samples[s][a]);
      }
    for (int a = 0; a < 3; ++a) origin_[a] = low[a];
    topology_.diagonal = model.diagonal;
    const double reach = kNeedle * model.diagonal;
    const auto sample = get(surface_, vbm_surface_vertex_sample);
    const bool crust = std::any_of(sample.begin(), sample.end(), [](int32_t s) { return s < 0; });
    hopeless_ = crust && (model.samples < kFew || 4 * model.undersampled >= model.samples);
    for (std::size_t v = 0; v < vertices_.size; ++v)
      for (int a = 0; a < 3; ++a) {
        const double x = vertices_[v][a];
        problems_.require(std::isfinite(x), "a vertex is not finite", v);
        const double beyond = std::max(low[a] - x, x - high[a]);
        problems_.require(beyond <= reach || hopeless_, "a needle at vertex", v);
        topology_.reach = std::max(topology_.reach, beyond / model.diagonal);
      }
  }

  /// Every edge in two triangles, one each way, and the triangles round a vertex one cycle.
  void fans() {
    std::vector<std::pair<Edge, std::size_t>> half; // edge as its triangle runs along it
    for (std::size_t t = 0; t < triangles_.size; ++t)
      for (int i = 0; i < 3; ++i)
        half.push_back({{triangles_[t][i], triangles_[t][(i + 1) % 3]}, t});
    std::sort(half.begin(), half.end());
    const auto triangle_at = [&](int32_t a, int32_t b) { // triangles_.size: none
      const auto at =
          std::lower_bound(half.begin(), half.end(), std::make_pair(Edge{a, b}, std::size_t(0)));
      return at != half.end() && at->first == Edge{a, b} ? at->second : triangles_.size;
    };
    for (std::size_t h = 0; h < half.size(); ++h) {
      const auto &[edge, t] = half[h];
      problems_.require(h == 0 || half[h - 1].first != edge,
                        "an edge twice in one direction, at triangle", t);
      problems_.require(triangle_at(edge.second, edge.first) < triangles_.size,
                        "an open edge at triangle", t);
    }
    if (!problems_.none()) return;
    std::vector<std::size_t> corners(vertices_.size, 0);
    std::vector<int32_t> start(vertices_.size, -1);
    for (std::size_t t = 0; t < triangles_.size; ++t)
      for (int i = 0; i < 3; ++i) {
        ++corners[std::size_t(triangles_[t][i])];
        start[std::size_t(triangles_[t][i])] = triangles_[t][(i + 1) % 3];
      }
    for (std::size_t v = 0; v < vertices_.size; ++v) {
      problems_.require(corners[v] > 0, "a vertex in no triangle", v);
      if (!problems_.none()) return;
      std::size_t steps = 0;
      int32_t w = start[v];
      do { // the triangle (v, w, x), then the one beyond its edge (x, v)
        const int32_t *t = triangles_[triangle_at(int32_t(v), w)];
        const int i = t[0] == int32_t(v) ? 0 : t[1] == int32_t(v) ? 1 : 2;
        w = t[(i + 2) % 3];
        ++steps;
      } while (w != start[v] && steps <= corners[v]);
      problems_.require(steps == corners[v], "more than one fan at vertex", v);
    }
    topology_.vertices = vertices_.size;
    topology_.triangles = triangles_.size;
    topology_.euler = int64_t(vertices_.size) - int64_t(half.size() / 2) + int64_t(triangles_.size);
    components();
  }

  void components() {
    std::vector<int32_t> parent(vertices_.size);
    std::iota(parent.begin(), parent.end(), 0);
    const auto find = [&](int32_t v) {
      while (parent[std::size_t(v)] != v)
        v = parent[std::size_t(v)] = parent[std::size_t(parent[std::size_t(v)])];
      return v;
    };
    for (std::size_t t = 0; t < triangles_.size; ++t)
      for (int i = 0; i < 3; ++i)
        parent[std::size_t(find(triangles_[t][i]))] = find(triangles_[t][(i + 1) % 3]);
    for (int32_t v = 0; v < int32_t(vertices_.size); ++v) topology_.components += find(v) == v;
    topology_.genus = int64_t(topology_.components) - topology_.euler / 2;
    problems_.require(report_.components == topology_.components, "report: components");
    problems_.require(report_.euler == topology_.euler, "report: euler");
    problems_.require(report_.genus == topology_.genus, "report: genus");
  }

  /// The triangles of a polygon have its edges, once all edges between them are taken away.
  void polygons() {
    const auto polygon_of = get(surface_, vbm_surface_triangle_polygon);
    problems_.require(polygon_of.size == triangles_.size, "a polygon for every triangle");
    if (!problems_.none()) return;
    std::vector<std::vector<std::size_t>> parts(polygons_.size());
    for (std::size_t t = 0; t < triangles_.size; ++t) {
      if (polygon_of[t] < 0 || std::size_t(polygon_of[t]) >= parts.size())
        return problems_.add("a polygon that is not there");
      parts[std::size_t(polygon_of[t])].push_back(t);
    }
    std::vector<Edge> outline, edges;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const auto ring = polygons_[p];
      problems_.require(parts[p].size() == ring.size - 2, "a polygon not cut into corners - 2", p);
      outline.clear(), edges.clear();
      for (std::size_t i = 0; i < ring.size; ++i)
        outline.push_back({ring[i], ring[(i + 1) % ring.size]});
      for (std::size_t t : parts[p])
        for (int i = 0; i < 3; ++i) edges.push_back({triangles_[t][i], triangles_[t][(i + 1) % 3]});
      std::sort(edges.begin(), edges.end());
      std::vector<Edge> open;
      for (const Edge &e : edges)
        if (!std::binary_search(edges.begin(), edges.end(), Edge{e.second, e.first}))
          open.push_back(e);
      std::sort(outline.begin(), outline.end());
      problems_.require(open == outline, "a polygon's triangles have another outline", p);
    }
  }

  void tables() {
    const auto ball = get(surface_, vbm_surface_polygon_ball);
    const auto sample = get(surface_, vbm_surface_vertex_sample);
    const auto input = get(surface_, vbm_surface_vertex_input);
    const auto radius = get(surface_, vbm_surface_vertex_radius);
    const auto samples = get<3>(model_, vbm_model_samples);
    const auto sample_input = get(model_, vbm_model_sample_input);
    problems_.require(ball.size == polygons_.size(), "a ball for every polygon");
    problems_.require(sample.size == vertices_.size && input.size == vertices_.size &&
                          radius.size == vertices_.size,
                      "tables as long as the vertices");
    if (!problems_.none()) return;
    for (std::size_t p = 0; p < ball.size; ++p)
      problems_.require(ball[p] >= -1 && ball[p] < int64_t(vbm_model_inner_count(model_)),
                        "a ball that is not an inner one", p);
    for (std::size_t v = 0; v < vertices_.size; ++v) {
      problems_.require(std::isfinite(radius[v]) && radius[v] >= 0, "a vertex's radius", v);
      if (sample[v] < 0) {
        problems_.require(sample[v] == -1 && input[v] == -1, "an input without a sample", v);
        continue;
      }
      if (std::size_t(sample[v]) >= samples.size) return problems_.add("no such sample");
      problems_.require(std::equal(vertices_[v], vertices_[v] + 3, samples[std::size_t(sample[v])]),
                        "a vertex that is not where its sample is", v);
      problems_.require(input[v] == sample_input[std::size_t(sample[v])], "a vertex's input", v);
    }
  }

  void measures() {
    if (!problems_.none()) return;
    long double volume = 0, area = 0, squares = 0; // of the triangles' sides
    const double unit = topology_.diagonal;
    for (std::size_t t = 0; t < triangles_.size; ++t) {
      long double p[3][3];
      for (int i = 0; i < 3; ++i)
        for (int a = 0; a < 3; ++a)
          p[i][a] =
              ((long double)(vertices_[std::size_t(triangles_[t][i])][a]) - origin_[a]) / unit;
      long double n[3];
      for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        n[a] =
            (p[1][b] - p[0][b]) * (p[2][c] - p[0][c]) - (p[1][c] - p[0][c]) * (p[2][b] - p[0][b]);
      }
      volume += (p[0][0] * n[0] + p[0][1] * n[1] + p[0][2] * n[2]) / 6;
      area += std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
      for (int i = 1; i < 3; ++i)
        for (int a = 0; a < 3; ++a) squares += (p[i][a] - p[0][a]) * (p[i][a] - p[0][a]);
    }
    topology_.volume = double(volume);
    topology_.area = double(area);
    // Slivers between coordinates of very different magnitude may have no volume that shows.
    problems_.require(volume >= -kFlat || hopeless_, "the surface is inside out");
    // Not beyond the range of doubles, where the report's own are infinite or zero.
    const double cube = unit * unit * unit;
    if (cube > 1e-280 && cube < 1e280) {
      const double rounding = kRounding * double(squares); // slivers lose digits
      problems_.require(std::fabs(report_.volume / cube - topology_.volume) <=
                            1e-9 * (topology_.volume + topology_.area) + rounding,
                        "report: volume");
      problems_.require(std::fabs(report_.area / unit / unit - topology_.area) <=
                            1e-9 * topology_.area + rounding,
                        "report: area");
    }
  }

  const vbm_surface *surface_;
  const vbm_model *model_;
  vbm::View<double, 3> vertices_;
  vbm::View<int32_t, 3> triangles_;
  vbm::Lists polygons_;
  vbm_surface_report report_;
  double origin_[3] = {0, 0, 0};
  bool hopeless_ = false; // too few samples for a power crust that is where they are
  Topology topology_;
  Problems problems_;
};

} // namespace

Problems check_surface(const vbm_surface *surface, const vbm_model *model, Topology *found) {
  return SurfaceCheck(surface, model).run(found);
}
