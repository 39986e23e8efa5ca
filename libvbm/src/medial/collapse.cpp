// SPDX-License-Identifier: GPL-3.0-or-later
// Dey and Zhao, "Approximating the medial axis from the Voronoi diagram with a convergence
// guarantee" (2004): a Voronoi face is kept if its Delaunay edge rises steeply from the surface at
// its samples, or is long beside the triangles there; both hold at any scale and density. It
// differs in that the other faces are not just left out, but taken away by elementary collapses
// only (a cell with a border cell that no other cell has, both together), least significant first,
// so that the homotopy type cannot change; those that cannot be, stay.
#include "medial/collapse.h"

#include "core/prefetch.h"
#include "core/progress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>

namespace vbm::impl {
namespace {

/// Ratio of a curve's length to its largest ball's radius, up to which it is cut off.
constexpr double kShortCurve = 2;

/// Degrees. At a seam samples are at least so far apart, whatever angle makes a face part of the
/// axis: with less, samples next to each other would be on different sides of the shape.
constexpr double kSeamAngle = 45;

/// Faces of a sheet at the border that are too few to be one.
constexpr std::size_t kFringe = 8;

/// A queue of edges by how little their only faces tell, in steps of 1 / kLevels; within a step
/// first in, first out. Which faces go does not depend on the order: an edge's only face stays its
/// only face.
class Queue {
public:
  explicit Queue(std::size_t edges) : next_(edges) { first_.fill(-1); }

  static uint8_t level(float weight) {
    return uint8_t(std::min(kLevels - 1, int(weight * kLevels)));
  }

  void push(int32_t edge, int level) {
    (first_[level] < 0 ? first_[level] : next_[last_[level]]) = edge;
    last_[level] = edge;
    next_[edge] = -1;
    least_ = std::min(least_, level);
  }
  /// -1 if there is none.
  int32_t pop() {
    while (least_ < kLevels && first_[least_] < 0) ++least_;
    if (least_ == kLevels) return -1;
    const int32_t edge = first_[least_];
    first_[least_] = next_[edge];
    return edge;
  }

private:
  static constexpr int kLevels = 16;
  std::array<int32_t, kLevels> first_{}, last_{};
  std::vector<int32_t> next_; // of each edge queued
  int least_ = kLevels;
};

class Collapser {
public:
  Collapser(const DualComplex &complex, const Model &model, const AxisOptions &options,
            Progress &progress)
      : complex_(complex), model_(model), options_(options), progress_(progress),
        queue_(complex.edge.size()) {}

  Collapsed run() {
    out_.face.assign(complex_.faces(), 1);
    out_.edge.assign(complex_.edge.size(), 1);
    out_.vertex.assign(complex_.ball.size(), 1);
    out_.parent.resize(complex_.ball.size());
    std::iota(out_.parent.begin(), out_.parent.end(), 0);
    take_samples();
    weigh_faces();
    open_solids();
    count_uses();
    offer_all();
    peel();
    cut_short_curves();
    find_seams();
    while (give_up_fringe()) {
      peel();
      cut_short_curves();
    }
    find_roots();
    return std::move(out_);
  }

private:
  /// Of the cells left at a border cell of theirs: how many, and the sum of their numbers, so that
  /// the only one is known, and of two each knows the other.
  struct Use {
    int32_t count = 0;
    uint32_t sum = 0;
    void add(int32_t cell) { ++count, sum += uint32_t(cell); }
    void take(int32_t cell) { --count, sum -= uint32_t(cell); }
    int32_t only() const { return int32_t(sum); }
    int32_t other(int32_t cell) const { return int32_t(sum - uint32_t(cell)); }
  };

  /// What is asked of a sample, all in one place.
  struct Sample {
    Vec3 position;
    double spacing; // squared
  };

  void take_samples() {
    const std::vector<double> spacing =
        options_.spacing ? *options_.spacing : sample_spacing(model_, progress_);
    sample_.reserve(spacing.size());
    for (std::size_t s = 0; s < spacing.size(); ++s)
      sample_.push_back({model_.samples.position[s], spacing[s] * spacing[s]});
  }

  /// Squared, as all lengths until peel().
  double width(int32_t a, int32_t b) const {
    const Vec3 between = sample_[a].position - sample_[b].position;
    return dot(between, between);
  }

  static bool apart(double width, double radius, double chord) {
    return width >= chord * radius * radius;
  }

  /// Squared chord of an angle in degrees in the unit circle.
  static double chord_of(double angle) {
    const double sine = std::sin(angle * (std::acos(-1.0) / 360));
    return 4 * sine * sine;
  }

  /// Whether two samples may be on different sides of the shape, whatever ball they are of.
  bool may_tell(int32_t a, int32_t b, double width) const {
    const double spacing = std::max(sample_[a].spacing, sample_[b].spacing);
    return width >= std::min(kResolved * kResolved, options_.ratio * options_.ratio) * spacing;
  }

  /// Whether two samples of a ball of this radius are on different sides of the shape.
  bool tells(int32_t a, int32_t b, double width, double radius) const {
    const double spacing = std::max(sample_[a].spacing, sample_[b].spacing);
    return (apart(width, radius, chord_) && width >= kResolved * kResolved * spacing) ||
           width >= options_.ratio * options_.ratio * spacing;
  }

  void weigh_faces() {
    chord_ = chord_of(options_.angle);
    face_.resize(complex_.faces());
    for (std::size_t f = 0; f < complex_.faces(); ++f) {
      progress_.tick(0, 1);
      const double radius = largest_of_face(f);
      const auto [a, b] = complex_.face_samples[f];
      const double across = width(a, b);
      const uint8_t level = Queue::level(weight(across, radius));
      face_[f] = tells(a, b, across, radius) ? level | kKeep : level;
    }
  }

  double largest_of_face(std::size_t f) const {
    double radius = 0;
    for (uint64_t k = complex_.face_vertices.offset[f]; k < complex_.face_vertices.offset[f + 1];
         ++k)
      radius = std::max(radius, complex_.ball[complex_.face_vertices.index[k]].radius);
    return radius;
  }

  static float weight(double width, double radius) {
    return radius > 0 ? float(std::sqrt(width) / (2 * radius)) : 0;
  }

  double largest(int32_t edge) const {
    const auto [u, v] = complex_.edge[edge];
    return std::max(complex_.ball[u].radius, complex_.ball[v].radius);
  }

  /// Whether an edge of no face is a curve of the axis.
  bool keep_edge(int32_t edge) const {
    const auto &s = complex_.edge_samples[edge];
    std::array<double, 3> across;
    for (int i = 0; i < 3; ++i) {
      across[i] = width(s[i], s[(i + 1) % 3]);
      if (!may_tell(s[i], s[(i + 1) % 3], across[i])) return false; // nearly all
    }
    const double radius = largest(edge);
    for (int i = 0; i < 3; ++i)
      if (!tells(s[i], s[(i + 1) % 3], across[i], radius)) return false;
    return true;
  }

  void find_seams() {
    out_.seam.assign(complex_.edge.size(), 0);
    const double chord = chord_of(std::max(options_.angle, kSeamAngle));
    for (std::size_t e = 0; e < complex_.edge.size(); ++e) {
      progress_.tick(0, 1);
      if (!out_.edge[e] || faces_at_[e].count == 0) continue;
      const double radius = largest(int32_t(e));
      const auto &s = complex_.edge_samples[e];
      out_.seam[e] = apart(width(s[0], s[1]), radius, chord) &&
                     apart(width(s[1], s[2]), radius, chord) &&
                     apart(width(s[2], s[0]), radius, chord);
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
    using Item = std::pair<float, int32_t>;
    std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue;
    const auto offer = [&](int32_t f) {
      const auto [a, b] = complex_.face_samples[f];
      if (solid[a] != solid[b])
        queue.push({weight(width(a, b), largest_of_face(std::size_t(f))), f});
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

  /// A cell that goes leaves no use of itself behind, and none of its border cells that go with it.
  void count_uses() {
    faces_at_.resize(complex_.edge.size());
    edges_at_.resize(complex_.ball.size());
    for (std::size_t f = 0; f < complex_.faces(); ++f) {
      progress_.tick(0, 1);
      if (!out_.face[f]) continue;
      for (uint64_t k = complex_.face_edges.offset[f]; k < complex_.face_edges.offset[f + 1]; ++k)
        faces_at_[complex_.face_edges.index[k]].add(int32_t(f));
    }
    for (std::size_t e = 0; e < complex_.edge.size(); ++e)
      for (int32_t v : complex_.edge[e]) edges_at_[v].add(int32_t(e));
  }

  void offer_edge(int32_t edge) {
    if (faces_at_[edge].count != 1) return;
    const int32_t f = faces_at_[edge].only();
    if (!(face_[f] & kKeep)) queue_.push(edge, face_[f]);
  }

  void offer_vertex(int32_t v) {
    if (edges_at_[v].count != 1) return;
    leaves_.push_back(v);
    const int32_t e = edges_at_[v].only();
    prefetch(&complex_.edge[e]);
    prefetch(&complex_.edge_samples[e]);
    prefetch(&faces_at_[e]);
  }

  void offer_all() {
    for (std::size_t e = 0; e < complex_.edge.size(); ++e) {
      progress_.tick(0, 1);
      offer_edge(int32_t(e));
    }
    for (std::size_t v = 0; v < complex_.ball.size(); ++v) offer_vertex(int32_t(v));
  }

  void peel() {
    cut_leaves();
    for (int32_t edge; (edge = queue_.pop()) >= 0;) {
      progress_.tick(0, 1);
      if (faces_at_[edge].count != 1) continue;
      const int32_t f = faces_at_[edge].only();
      out_.face[f] = 0;
      remove_edge(edge);
      for (uint64_t k = complex_.face_edges.offset[f]; k < complex_.face_edges.offset[f + 1]; ++k) {
        const int32_t e = complex_.face_edges.index[k];
        faces_at_[e].take(f);
        if (faces_at_[e].count == 1) {
          offer_edge(e);
        } else if (faces_at_[e].count == 0 && e != edge) {
          offer_vertex(complex_.edge[e][0]);
          offer_vertex(complex_.edge[e][1]);
        }
      }
      cut_leaves();
    }
  }

  void remove_edge(int32_t e) {
    out_.edge[e] = 0;
    for (int32_t v : complex_.edge[e]) {
      edges_at_[v].take(e);
      offer_vertex(v);
    }
  }

  /// Edges at which no face is left go with an end that no other edge has.
  void cut_leaves() {
    while (!leaves_.empty()) {
      const int32_t v = leaves_.back();
      leaves_.pop_back();
      if (edges_at_[v].count != 1) continue;
      const int32_t e = edges_at_[v].only();
      if (faces_at_[e].count != 0) continue;
      if (keep_edge(e)) {
        ends_.push_back(v);
        continue;
      }
      remove_leaf(v, e);
    }
  }

  void remove_leaf(int32_t v, int32_t e) {
    out_.vertex[v] = 0;
    out_.parent[v] = other_end(e, v);
    out_.gone.push_back(v);
    remove_edge(e);
  }

  /// Faces of small groups at the border are not worth keeping: whether there were any.
  bool give_up_fringe() {
    std::vector<int32_t> group;
    std::vector<std::vector<int32_t>> given_up;
    for (std::size_t e = 0; e < complex_.edge.size(); ++e) {
      progress_.tick(0, 1);
      if (faces_at_[e].count != 1 || !gather_fringe(faces_at_[e].only(), group)) continue;
      bool kept = false;
      for (int32_t f : group) {
        kept |= (face_[f] & kKeep) != 0;
        face_[f] &= uint8_t(~kKeep);
      }
      if (!kept) continue;
      gather_fringe(*std::min_element(group.begin(), group.end()), group);
      given_up.push_back(group);
    }
    std::sort(given_up.begin(), given_up.end());
    for (const std::vector<int32_t> &faces : given_up)
      for (int32_t f : faces)
        for (uint64_t k = complex_.face_edges.offset[f]; k < complex_.face_edges.offset[f + 1]; ++k)
          offer_edge(complex_.face_edges.index[k]);
    return !given_up.empty();
  }

  /// The faces that hang together with this one, if they are few.
  bool gather_fringe(int32_t first, std::vector<int32_t> &group) const {
    group.assign(1, first);
    for (std::size_t i = 0; i < group.size(); ++i) {
      const int32_t f = group[i];
      for (uint64_t k = complex_.face_edges.offset[f]; k < complex_.face_edges.offset[f + 1]; ++k) {
        const int32_t e = complex_.face_edges.index[k];
        if (faces_at_[e].count != 2 || out_.seam[e]) continue;
        const int32_t g = faces_at_[e].other(f);
        if (std::find(group.begin(), group.end(), g) != group.end()) continue;
        if (group.size() == kFringe) return false;
        group.push_back(g);
      }
    }
    return true;
  }

  /// Curves with a loose end that do not leave the balls they begin in: corners, not tubes.
  void cut_short_curves() {
    std::vector<int32_t> ends = ends_, chain;
    while (!ends.empty()) {
      progress_.tick(0, 1);
      const int32_t end = ends.back();
      ends.pop_back();
      if (edges_at_[end].count != 1) continue;
      chain.clear();
      double radius = complex_.ball[end].radius, length = 0;
      int32_t v = end;
      for (int32_t e = curve_from(v, -1); e >= 0; e = curve_from(v, e)) {
        const int32_t next = other_end(e, v);
        length += distance(complex_.ball[v].center, complex_.ball[next].center);
        radius = std::max(radius, complex_.ball[next].radius);
        chain.push_back(e);
        v = next;
        if (edges_at_[v].count != 2) break;
      }
      // A curve that is all there is of a piece of the axis stays.
      if (chain.empty() || edges_at_[v].count == 1 || length > kShortCurve * radius) continue;
      v = end;
      for (int32_t e : chain) {
        remove_leaf(v, e);
        v = out_.parent[v];
      }
      leaves_.clear();
      if (edges_at_[v].count == 1) {
        ends.push_back(v);
        ends_.push_back(v);
      }
    }
  }

  int32_t other_end(int32_t e, int32_t v) const {
    return complex_.edge[e][0] == v ? complex_.edge[e][1] : complex_.edge[e][0];
  }

  /// The edge of a curve at v that is not `from`, or -1. There are at most two edges at v.
  int32_t curve_from(int32_t v, int32_t from) const {
    if (edges_at_[v].count != (from < 0 ? 1 : 2)) return -1;
    const int32_t e = from < 0 ? edges_at_[v].only() : edges_at_[v].other(from);
    return faces_at_[e].count == 0 ? e : -1;
  }

  void find_roots() {
    out_.root = out_.parent;
    for (std::size_t i = out_.gone.size(); i-- > 0;) {
      int32_t &root = out_.root[out_.gone[i]];
      root = out_.root[root];
    }
  }

  const DualComplex &complex_;
  const Model &model_;
  const AxisOptions &options_;
  Progress &progress_;
  std::vector<Sample> sample_;
  double chord_ = 0;                       // of the options' angle
  static constexpr uint8_t kKeep = 1 << 7; // a face that is part of the axis
  std::vector<uint8_t> face_, open_;       // per face: its level in the queue, and kKeep
  std::vector<Use> faces_at_, edges_at_;   // per edge, per vertex
  Queue queue_;                            // free edges
  std::vector<int32_t> leaves_;
  std::vector<int32_t> ends_; // of curves that are kept
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
