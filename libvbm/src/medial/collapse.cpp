// SPDX-License-Identifier: GPL-3.0-or-later
// Dey and Zhao, "Approximating the medial axis from the Voronoi diagram with a convergence
// guarantee" (2004): a Voronoi face is kept if its Delaunay edge rises steeply from the surface at
// its samples, or is long beside the triangles there; both hold at any scale and density. It
// differs in that the other faces are not just left out, but taken away by elementary collapses
// only (a cell with a border cell that no other cell has, both together), least significant first,
// so that the homotopy type cannot change; those that cannot be, stay.
#include "medial/collapse.h"

#include "core/progress.h"
#include "medial/cell_lists.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace vbm::impl {
namespace {

/// Ratio of a curve's length to its largest ball's radius, up to which it is cut off.
constexpr double kShortCurve = 2;

/// Ratio of a face's width to the distance of samples next to its own, below which what it tells is
/// as likely noise: at the tips of corners sheets are cut off before they get tangled.
constexpr double kResolved = 2;

/// Faces of a sheet at the border that are too few to be one.
constexpr std::size_t kFringe = 8;

class Collapser {
public:
  Collapser(const DualComplex &complex, const Model &model, const AxisOptions &options,
            Progress &progress)
      : complex_(complex), model_(model), options_(options), progress_(progress),
        edge_faces_(lists_of(complex.edge.size(), complex.face_edges)),
        vertex_edges_(lists_of(complex.ball.size(), complex.edge)) {}

  Collapsed run() {
    out_.face.assign(complex_.faces(), 1);
    out_.edge.assign(complex_.edge.size(), 1);
    out_.vertex.assign(complex_.ball.size(), 1);
    out_.root.resize(complex_.ball.size());
    for (std::size_t v = 0; v < out_.root.size(); ++v) out_.root[v] = int32_t(v);
    spacing_ = options_.spacing ? *options_.spacing : sample_spacing(model_, progress_);
    weigh_faces();
    open_solids();
    count_degrees();
    do {
      peel();
      cut_short_curves();
    } while (give_up_fringe());
    find_roots();
    return std::move(out_);
  }

private:
  using Item = std::pair<double, int32_t>; // significance, cell
  using Queue = std::priority_queue<Item, std::vector<Item>, std::greater<Item>>;

  double width(int32_t a, int32_t b) const {
    return distance(model_.samples.position[a], model_.samples.position[b]);
  }

  bool apart(int32_t a, int32_t b, double radius) const {
    return width(a, b) >= 2 * radius * sine_;
  }

  /// Whether two samples of a ball of this radius are on different sides of the shape.
  bool tells(int32_t a, int32_t b, double radius) const {
    const double w = width(a, b), spacing = std::max(spacing_[a], spacing_[b]);
    return (apart(a, b, radius) && w >= kResolved * spacing) || w >= options_.ratio * spacing;
  }

  void weigh_faces() {
    sine_ = std::sin(options_.angle * (std::acos(-1.0) / 360));
    keep_face_.resize(complex_.faces());
    weight_.resize(complex_.faces());
    for (std::size_t f = 0; f < complex_.faces(); ++f) {
      progress_.tick(0, 1);
      double radius = 0;
      for (uint64_t k = complex_.face_vertices.offset[f]; k < complex_.face_vertices.offset[f + 1];
           ++k)
        radius = std::max(radius, complex_.ball[complex_.face_vertices.index[k]].radius);
      const auto [a, b] = complex_.face_samples[f];
      keep_face_[f] = tells(a, b, radius);
      weight_[f] = width(a, b) / (2 * radius);
    }
    keep_edge_.resize(complex_.edge.size());
    out_.seam.resize(complex_.edge.size());
    for (std::size_t e = 0; e < complex_.edge.size(); ++e) {
      progress_.tick(0, 1);
      const auto [u, v] = complex_.edge[e];
      const double radius = std::max(complex_.ball[u].radius, complex_.ball[v].radius);
      const auto &s = complex_.edge_samples[e];
      keep_edge_[e] =
          tells(s[0], s[1], radius) && tells(s[1], s[2], radius) && tells(s[2], s[0], radius);
      out_.seam[e] =
          apart(s[0], s[1], radius) && apart(s[1], s[2], radius) && apart(s[2], s[0], radius);
    }
  }

  /// Solids go first, each with a face that it does not share with another.
  void open_solids() {
    std::vector<uint8_t> &solid = open_;
    solid = complex_.solid;
    if (std::find(solid.begin(), solid.end(), 1) == solid.end()) return;
    std::vector<std::vector<int32_t>> faces_of(solid.size());
    for (std::size_t f = 0; f < complex_.faces(); ++f)
      for (int32_t s : complex_.face_samples[f])
        if (solid[s]) faces_of[s].push_back(int32_t(f));
    Queue queue;
    const auto offer = [&](int32_t f) {
      const auto [a, b] = complex_.face_samples[f];
      if (solid[a] != solid[b]) queue.push({weight_[f], f});
    };
    for (std::size_t f = 0; f < complex_.faces(); ++f) offer(int32_t(f));
    while (!queue.empty()) {
      progress_.tick(0, 1);
      const int32_t f = queue.top().second;
      queue.pop();
      const auto [a, b] = complex_.face_samples[f];
      if (!out_.face[f] || solid[a] == solid[b]) continue;
      out_.face[f] = 0;
      const int32_t s = solid[a] ? a : b;
      solid[s] = 0;
      for (int32_t g : faces_of[s])
        if (out_.face[g]) offer(g);
    }
  }

  void count_degrees() {
    faces_at_.assign(complex_.edge.size(), 0);
    edges_at_.assign(complex_.ball.size(), 0);
    for (std::size_t f = 0; f < complex_.faces(); ++f)
      if (out_.face[f])
        for (uint64_t k = complex_.face_edges.offset[f]; k < complex_.face_edges.offset[f + 1]; ++k)
          ++faces_at_[complex_.face_edges.index[k]];
    for (const auto &e : complex_.edge)
      for (int32_t v : e) ++edges_at_[v];
  }

  /// The only face left at an edge.
  int32_t face_at(int32_t edge) const {
    for (uint64_t k = edge_faces_.offset[edge]; k < edge_faces_.offset[edge + 1]; ++k)
      if (out_.face[edge_faces_.index[k]]) return edge_faces_.index[k];
    return -1;
  }

  void offer_edge(int32_t edge) {
    if (!out_.edge[edge] || faces_at_[edge] != 1) return;
    const int32_t f = face_at(edge);
    if (!keep_face_[f]) queue_.push({weight_[f], edge});
  }

  void offer_vertex(int32_t v) {
    if (out_.vertex[v] && edges_at_[v] == 1) leaves_.push_back(v);
  }

  void peel() {
    for (std::size_t e = 0; e < complex_.edge.size(); ++e) {
      progress_.tick(0, 1);
      offer_edge(int32_t(e));
    }
    for (std::size_t v = 0; v < complex_.ball.size(); ++v) offer_vertex(int32_t(v));
    cut_leaves();
    while (!queue_.empty()) {
      progress_.tick(0, 1);
      const int32_t edge = queue_.top().second;
      queue_.pop();
      if (!out_.edge[edge] || faces_at_[edge] != 1) continue;
      const int32_t f = face_at(edge);
      out_.face[f] = 0;
      remove_edge(edge);
      for (uint64_t k = complex_.face_edges.offset[f]; k < complex_.face_edges.offset[f + 1]; ++k) {
        const int32_t e = complex_.face_edges.index[k];
        if (!out_.edge[e]) continue;
        if (--faces_at_[e] == 0) {
          offer_vertex(complex_.edge[e][0]);
          offer_vertex(complex_.edge[e][1]);
        }
        offer_edge(e);
      }
      cut_leaves();
    }
  }

  void remove_edge(int32_t e) {
    out_.edge[e] = 0;
    for (int32_t v : complex_.edge[e]) {
      --edges_at_[v];
      offer_vertex(v);
    }
  }

  /// Edges at which no face is left go with an end that no other edge has.
  void cut_leaves() {
    while (!leaves_.empty()) {
      const int32_t v = leaves_.back();
      leaves_.pop_back();
      if (!out_.vertex[v] || edges_at_[v] != 1) continue;
      for (uint64_t k = vertex_edges_.offset[v]; k < vertex_edges_.offset[v + 1]; ++k) {
        const int32_t e = vertex_edges_.index[k];
        if (!out_.edge[e]) continue;
        if (faces_at_[e] != 0 || keep_edge_[e]) break;
        out_.vertex[v] = 0;
        out_.root[v] = complex_.edge[e][0] == v ? complex_.edge[e][1] : complex_.edge[e][0];
        remove_edge(e);
        break;
      }
    }
  }

  /// Faces of small groups at the border are not worth keeping: whether there were any.
  bool give_up_fringe() {
    bool any = false;
    std::vector<uint8_t> seen(complex_.faces(), 0);
    std::vector<int32_t> group;
    for (std::size_t first = 0; first < complex_.faces(); ++first) {
      progress_.tick(0, 1);
      if (!out_.face[first] || seen[first]) continue;
      seen[first] = 1;
      group.assign(1, int32_t(first));
      bool border = false, kept = false;
      for (std::size_t i = 0; i < group.size(); ++i) {
        const int32_t f = group[i];
        kept |= keep_face_[f] != 0;
        for (uint64_t k = complex_.face_edges.offset[f]; k < complex_.face_edges.offset[f + 1];
             ++k) {
          const int32_t e = complex_.face_edges.index[k];
          border |= faces_at_[e] == 1;
          if (faces_at_[e] != 2 || out_.seam[e]) continue;
          for (uint64_t j = edge_faces_.offset[e]; j < edge_faces_.offset[e + 1]; ++j) {
            const int32_t g = edge_faces_.index[j];
            if (!out_.face[g] || seen[g]) continue;
            seen[g] = 1;
            group.push_back(g);
          }
        }
      }
      if (!border || !kept || group.size() > kFringe) continue;
      for (int32_t f : group) keep_face_[f] = 0;
      any = true;
    }
    return any;
  }

  /// Curves with a loose end that do not leave the balls they begin in: corners, not tubes.
  void cut_short_curves() {
    std::vector<int32_t> ends, chain;
    for (std::size_t v = 0; v < complex_.ball.size(); ++v)
      if (out_.vertex[v] && edges_at_[v] == 1) ends.push_back(int32_t(v));
    while (!ends.empty()) {
      progress_.tick(0, 1);
      const int32_t end = ends.back();
      ends.pop_back();
      if (!out_.vertex[end] || edges_at_[end] != 1) continue;
      chain.clear();
      double radius = complex_.ball[end].radius, length = 0;
      int32_t v = end;
      for (int32_t e = curve_from(v, -1); e >= 0; e = curve_from(v, e)) {
        const int32_t next = other_end(e, v);
        length += distance(complex_.ball[v].center, complex_.ball[next].center);
        radius = std::max(radius, complex_.ball[next].radius);
        chain.push_back(e);
        v = next;
        if (edges_at_[v] != 2) break;
      }
      // A curve that is all there is of a piece of the axis stays.
      if (chain.empty() || edges_at_[v] == 1 || length > kShortCurve * radius) continue;
      v = end;
      for (int32_t e : chain) {
        out_.vertex[v] = 0;
        out_.root[v] = other_end(e, v);
        v = out_.root[v];
        remove_edge(e);
      }
      leaves_.clear();
      if (edges_at_[v] == 1) ends.push_back(v);
    }
  }

  int32_t other_end(int32_t e, int32_t v) const {
    return complex_.edge[e][0] == v ? complex_.edge[e][1] : complex_.edge[e][0];
  }

  /// The edge of a curve at v that is not `from`, or -1.
  int32_t curve_from(int32_t v, int32_t from) const {
    for (uint64_t k = vertex_edges_.offset[v]; k < vertex_edges_.offset[v + 1]; ++k) {
      const int32_t e = vertex_edges_.index[k];
      if (e != from && out_.edge[e]) return faces_at_[e] == 0 ? e : -1;
    }
    return -1;
  }

  void find_roots() {
    out_.parent = out_.root;
    for (std::size_t v = 0; v < out_.root.size(); ++v) {
      int32_t r = int32_t(v);
      while (out_.root[r] != r) r = out_.root[r];
      for (int32_t at = int32_t(v); out_.root[at] != r;) {
        const int32_t next = out_.root[at];
        out_.root[at] = r;
        at = next;
      }
    }
  }

  const DualComplex &complex_;
  const Model &model_;
  const AxisOptions &options_;
  Progress &progress_;
  Incidence edge_faces_, vertex_edges_;
  std::vector<double> spacing_; // per sample
  double sine_ = 0;             // of half the angle
  std::vector<uint8_t> keep_face_, keep_edge_, open_;
  std::vector<double> weight_; // per face
  std::vector<int32_t> faces_at_, edges_at_;
  Queue queue_; // free edges
  std::vector<int32_t> leaves_;
  Collapsed out_;
};

} // namespace

std::vector<double> sample_spacing(const Model &model, Progress &progress) {
  const Cells &cells = model.cells;
  const std::vector<Vec3> &at = model.samples.position;
  std::vector<double> spacing(cells.samples, 0);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    progress.tick(0, 1);
    if (!model.inside[c]) continue;
    for (int i = 0; i < 4; ++i) {
      const int32_t n = cells.neighbor[c][i];
      if (n >= 0 && model.inside[n]) continue;
      int32_t v[3];
      for (int k = 0; k < 3; ++k) v[k] = cells.vertex[c][kFacet[i][k]];
      for (int k = 0; k < 3; ++k) {
        const int32_t a = v[k], b = v[(k + 1) % 3];
        if (a >= cells.samples || b >= cells.samples) continue;
        const double d = distance(at[a], at[b]);
        spacing[a] = std::max(spacing[a], d);
        spacing[b] = std::max(spacing[b], d);
      }
    }
  }
  return spacing;
}

Collapsed collapse(const DualComplex &complex, const Model &model, const AxisOptions &options,
                   Progress &progress) {
  return Collapser(complex, model, options, progress).run();
}

} // namespace vbm::impl
