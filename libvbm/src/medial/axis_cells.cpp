// SPDX-License-Identifier: GPL-3.0-or-later
// Faces are convex polygons, cut into fans. Two edges with the same ends, or two triangles with the
// same corners, would be one in a simplicial complex: such an edge gets a ball in its middle, such
// a face one at its centre.
#include "medial/axis_cells.h"

#include "core/progress.h"
#include "medial/cell_lists.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

using Pair = std::array<int32_t, 2>;
using Triple = std::array<int32_t, 3>;

Pair sorted(int32_t a, int32_t b) { return {std::min(a, b), std::max(a, b)}; }
Triple sorted(Triple t) { return std::sort(t.begin(), t.end()), t; }

/// Keys that are there more than once, each but its first owner's.
template <class Key>
std::vector<int32_t> repeats(std::vector<std::pair<Key, int32_t>> keys, std::size_t vertices) {
  sort_rows(keys, vertices, [](const auto &key) { return key.first[0]; });
  std::vector<int32_t> out;
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (keys[i].first == keys[i - 1].first) out.push_back(keys[i].second);
  return out;
}

class Builder {
public:
  Builder(const DualComplex &complex, const Collapsed &left, const Model &model, Progress &progress)
      : complex_(complex), left_(left), model_(model), progress_(progress) {}

  AxisCells run() {
    out_.unit = model_.samples.frame.length_to_input(1);
    take_vertices();
    mark_sides();
    take_edges();
    take_faces();
    find_hubs();
    cut_faces();
    join_edges();
    share_volume();
    find_balls();
    out_.twigs = find_twigs(complex_, left_, model_, out_.thin, progress_);
    return std::move(out_);
  }

private:
  void take_vertices() {
    number_.assign(complex_.ball.size(), -1);
    for (std::size_t v = 0; v < number_.size(); ++v) {
      if (!left_.vertex[v]) continue;
      number_[v] = int32_t(out_.ball.size());
      out_.ball.push_back(complex_.ball[v]);
    }
  }

  /// A ball at a place that is as far from a sample as from the others its cell has.
  int32_t add_vertex(const Vec3 &at, int32_t sample) {
    out_.ball.push_back({at, distance(at, model_.samples.position[sample])});
    return int32_t(out_.ball.size()) - 1;
  }

  /// Edges that a face has; the others are curves.
  void mark_sides() {
    side_.assign(complex_.edge.size(), 0);
    for (std::size_t f = 0; f < complex_.faces(); ++f) {
      progress_.tick(0, 1);
      if (!left_.face[f]) continue;
      for (uint64_t k = complex_.face_edges.offset[f]; k < complex_.face_edges.offset[f + 1]; ++k)
        side_[complex_.face_edges.index[k]] = 1;
    }
  }

  void take_edges() {
    std::vector<std::pair<Pair, int32_t>> keys;
    for (std::size_t e = 0; e < complex_.edge.size(); ++e) {
      progress_.tick(0, 1);
      if (left_.edge[e]) keys.push_back({ends(int32_t(e)), int32_t(e)});
    }
    middle_.assign(complex_.edge.size(), -1);
    for (int32_t e : repeats(keys, out_.ball.size())) {
      const Pair v = ends(e);
      middle_[e] = add_vertex((out_.ball[v[0]].center + out_.ball[v[1]].center) * 0.5,
                              complex_.edge_samples[e][0]);
    }
    for (const auto &[v, e] : keys) {
      if (middle_[e] < 0) {
        add_edge(v, e);
      } else {
        add_edge(sorted(v[0], middle_[e]), e);
        add_edge(sorted(v[1], middle_[e]), e);
      }
    }
  }

  void add_edge(const Pair &vertices, int32_t e) {
    out_.edge.push_back(vertices);
    if (left_.seam[e]) seams_.push_back(vertices);
    if (!side_[e]) curves_.push_back({vertices, narrowest(complex_.edge_samples[e])});
  }

  /// The smallest distance of two of three samples.
  double narrowest(const Triple &samples) const {
    const std::vector<Vec3> &at = model_.samples.position;
    double least = HUGE_VAL;
    for (int i = 0; i < 3; ++i)
      least = std::min(least, distance(at[samples[i]], at[samples[(i + 1) % 3]]));
    return least;
  }

  Pair ends(int32_t e) const {
    return sorted(number_[complex_.edge[e][0]], number_[complex_.edge[e][1]]);
  }

  void take_faces() {
    for (std::size_t f = 0; f < complex_.faces(); ++f) {
      progress_.tick(0, 1);
      if (!left_.face[f]) continue;
      for (uint64_t k = complex_.face_vertices.offset[f]; k < complex_.face_vertices.offset[f + 1];
           ++k) {
        polygon_.index.push_back(number_[complex_.face_vertices.index[k]]);
        const int32_t middle = middle_[complex_.face_edges.index[k]];
        if (middle >= 0) polygon_.index.push_back(middle);
      }
      polygon_.offset.push_back(polygon_.index.size());
      samples_.push_back(complex_.face_samples[f]);
    }
  }

  /// Faces that are cut from their centre.
  void find_hubs() {
    std::vector<std::pair<Pair, int32_t>> lines; // edges (-1), then diagonals
    std::vector<std::pair<Triple, int32_t>> triangles;
    for (const Pair &e : out_.edge) lines.push_back({e, -1});
    for (std::size_t f = 0; f < samples_.size(); ++f) {
      progress_.tick(0, 1);
      const int32_t *p = polygon_.index.data() + polygon_.offset[f];
      const std::size_t n = polygon_.offset[f + 1] - polygon_.offset[f];
      for (std::size_t i = 2; i + 1 < n; ++i) lines.push_back({sorted(p[0], p[i]), int32_t(f)});
      if (n == 3) triangles.push_back({sorted(Triple{p[0], p[1], p[2]}), int32_t(f)});
    }
    hub_.assign(samples_.size(), 0);
    for (int32_t f : repeats(std::move(lines), out_.ball.size())) hub_[f] = 1;
    for (int32_t f : repeats(std::move(triangles), out_.ball.size())) hub_[f] = 1;
  }

  void add_triangle(int32_t a, int32_t b, int32_t c, std::size_t face) {
    out_.triangle.push_back({a, b, c});
    out_.triangle_samples.push_back(samples_[face]);
    out_.width.push_back(distance(model_.samples.position[samples_[face][0]],
                                  model_.samples.position[samples_[face][1]]));
  }

  void cut_faces() {
    for (std::size_t f = 0; f < samples_.size(); ++f) {
      progress_.tick(0, 1);
      const int32_t *p = polygon_.index.data() + polygon_.offset[f];
      const std::size_t n = polygon_.offset[f + 1] - polygon_.offset[f];
      if (hub_[f]) {
        Vec3 sum;
        for (std::size_t i = 0; i < n; ++i) sum += out_.ball[p[i]].center;
        const int32_t hub = add_vertex(sum * (1.0 / double(n)), samples_[f][0]);
        for (std::size_t i = 0; i < n; ++i) {
          out_.edge.push_back(sorted(p[i], hub));
          add_triangle(hub, p[i], p[(i + 1) % n], f);
        }
      } else {
        for (std::size_t i = 1; i + 1 < n; ++i) {
          if (i > 1) out_.edge.push_back(sorted(p[0], p[i]));
          add_triangle(p[0], p[i], p[i + 1], f);
        }
      }
    }
    polygon_ = Incidence();
  }

  void join_edges() {
    sort_rows(out_.edge, out_.ball.size(), [](const Pair &e) { return e[0]; });
    std::vector<uint64_t> first(out_.ball.size() + 1, 0); // edge by its lower end
    for (const Pair &e : out_.edge) ++first[std::size_t(e[0]) + 1];
    for (std::size_t v = 0; v + 1 < first.size(); ++v) first[v + 1] += first[v];
    out_.triangle_edges.resize(out_.triangle.size());
    for (std::size_t t = 0; t < out_.triangle.size(); ++t) {
      progress_.tick(0, 1);
      for (int i = 0; i < 3; ++i) {
        const Pair e = sorted(out_.triangle[t][i], out_.triangle[t][(i + 1) % 3]);
        const auto begin = out_.edge.begin();
        out_.triangle_edges[t][i] =
            int32_t(std::lower_bound(begin + int64_t(first[e[0]]),
                                     begin + int64_t(first[std::size_t(e[0]) + 1]), e) -
                    begin);
      }
    }
    const auto number = [&](const Pair &e) {
      return std::lower_bound(out_.edge.begin(), out_.edge.end(), e) - out_.edge.begin();
    };
    out_.seam.assign(out_.edge.size(), 0);
    for (const Pair &e : seams_) out_.seam[number(e)] = 1;
    out_.curve_width.assign(out_.edge.size(), 0);
    for (const auto &[e, width] : curves_) out_.curve_width[number(e)] = width;
    out_.edge_triangles = lists_of(out_.edge.size(), out_.triangle_edges);
    out_.vertex_edges = lists_of(out_.ball.size(), out_.edge);
  }

  void share_volume() {
    const Cells &cells = model_.cells;
    out_.volume.assign(out_.ball.size(), 0);
    double whole = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      progress_.tick(0, 1);
      const int32_t v = complex_.vertex_of_cell[c];
      if (v < 0) continue;
      const std::vector<Vec3> &at = model_.samples.position;
      const auto &k = cells.vertex[c];
      const double volume =
          std::fabs(dot(cross(at[k[1]] - at[k[0]], at[k[2]] - at[k[0]]), at[k[3]] - at[k[0]]));
      out_.volume[number_[left_.root[v]]] += volume;
      whole += volume;
    }
    if (whole > 0)
      for (double &v : out_.volume) v /= whole;
  }

  /// A ball of several vertices is where one of them is left, if there is such.
  void find_balls() {
    out_.vertex_of_ball.assign(model_.inner, -1);
    std::vector<uint8_t> on_axis(model_.inner, 0);
    for (std::size_t c = 0; c < model_.cells.size(); ++c) {
      const int32_t b = model_.ball_of_cell[c], v = complex_.vertex_of_cell[c];
      if (b < 0 || std::size_t(b) >= model_.inner || v < 0 || on_axis[b]) continue;
      on_axis[b] = left_.vertex[v];
      if (on_axis[b] || out_.vertex_of_ball[b] < 0) out_.vertex_of_ball[b] = number_[left_.root[v]];
    }
  }

  const DualComplex &complex_;
  const Collapsed &left_;
  const Model &model_;
  Progress &progress_;
  std::vector<int32_t> number_; // per vertex of the complex: its vertex of the axis
  std::vector<int32_t> middle_; // per edge of the complex
  Incidence polygon_;           // vertices of the faces left
  std::vector<Pair> samples_;
  std::vector<uint8_t> hub_;
  std::vector<uint8_t> side_; // per edge of the complex
  std::vector<Pair> seams_;
  std::vector<std::pair<Pair, double>> curves_; // and their widths
  AxisCells out_;
};

} // namespace

double object_angle(double width, double radius) {
  if (!(width > 0)) return 0;
  return std::asin(std::min(1.0, width / (2 * radius))) * (360 / std::acos(-1.0));
}

double triangle_angle(const AxisCells &cells, std::size_t triangle) {
  const auto &v = cells.triangle[triangle];
  const double sum = cells.ball[v[0]].radius + cells.ball[v[1]].radius + cells.ball[v[2]].radius;
  return object_angle(cells.width[triangle], sum / 3);
}

double curve_angle(const AxisCells &cells, std::size_t edge) {
  const auto &v = cells.edge[edge];
  const double sum = cells.ball[v[0]].radius + cells.ball[v[1]].radius;
  return object_angle(cells.curve_width[edge], sum / 2);
}

AxisCells axis_cells(const DualComplex &complex, const Collapsed &left, const Model &model,
                     Progress &progress) {
  return Builder(complex, left, model, progress).run();
}

} // namespace vbm::impl
