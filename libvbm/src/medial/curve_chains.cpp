// SPDX-License-Identifier: GPL-3.0-or-later
// A curve that runs along edges of the axis is jagged: its new vertices are means over a stretch of
// it, weighted by its length, and nodes are drawn towards their neighbours. Subdividing an edge and
// undoing a subdivision are homeomorphisms, so the topology stays as long as the result is a
// simplicial complex: a loop keeps three edges, and of curves with the same ends all but one keep
// two.
#include "medial/curve_chains.h"

#include "core/progress.h"
#include "medial/cell_lists.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace vbm::impl {
namespace {

/// Points that a mean over a stretch of curve is made of.
constexpr int kMeanOf = 9;

/// How often all vertices with two neighbours or more are drawn towards their neighbours' mean.
constexpr int kSmoothings = 2;

/// Edges of one curve, at most: spacing is coarser than that on any shape.
constexpr double kMostEdges = 1e5;

class Thinner {
public:
  Thinner(const AxisCells &cells, const Burnt &burnt, double spacing, Progress &progress)
      : cells_(cells), left_(burnt.left), time_(burnt.time), spacing_(spacing),
        progress_(progress) {}

  BallComplex run() {
    count();
    for (std::size_t v = 0; v < cells_.ball.size(); ++v)
      if (left_.vertex[v] && (degree_[v] != 2 || held_[v])) {
        number(int32_t(v));
        walk_from(int32_t(v));
      }
    for (std::size_t v = 0; v < cells_.ball.size(); ++v) // loops without a node
      if (left_.vertex[v] && number_[v] < 0 && degree_[v] == 2 && !passed_[v]) {
        number(int32_t(v));
        walk_from(int32_t(v));
      }
    smooth();
    return std::move(out_);
  }

private:
  void count() {
    degree_.assign(cells_.ball.size(), 0);
    held_.assign(cells_.ball.size(), 0);
    passed_.assign(cells_.ball.size(), 0);
    number_.assign(cells_.ball.size(), -1);
    curve_ = left_.edge;
    for (std::size_t t = 0; t < cells_.triangle.size(); ++t) {
      if (!left_.triangle[t]) continue;
      for (int32_t e : cells_.triangle_edges[t]) curve_[e] = 0;
      std::array<int32_t, 3> corners;
      for (int i = 0; i < 3; ++i) {
        const int32_t v = cells_.triangle[t][i];
        held_[v] = 1;
        corners[i] = number(v);
      }
      out_.triangle.push_back(corners);
      for (int i = 0; i < 3; ++i) take(corners[i], corners[(i + 1) % 3]);
    }
    for (std::size_t e = 0; e < cells_.edge.size(); ++e)
      if (curve_[e])
        for (int32_t v : cells_.edge[e]) ++degree_[v];
  }

  int32_t number(int32_t v) {
    if (number_[v] < 0) {
      number_[v] = int32_t(out_.ball.size());
      out_.ball.push_back(cells_.ball[v]);
      fixed_.push_back(held_[v]);
    }
    return number_[v];
  }

  bool take(int32_t a, int32_t b) { return ends_.insert({std::min(a, b), std::max(a, b)}).second; }

  void walk_from(int32_t node) {
    for (uint64_t k = cells_.vertex_edges.offset[node]; k < cells_.vertex_edges.offset[node + 1];
         ++k) {
      int32_t e = cells_.vertex_edges.index[k];
      if (!curve_[e]) continue;
      chain_.assign(1, node);
      for (int32_t v = node; e >= 0;) {
        progress_.tick(0, 1);
        curve_[e] = 0;
        v = cells_.edge[e][0] == v ? cells_.edge[e][1] : cells_.edge[e][0];
        chain_.push_back(v);
        e = -1;
        if (v == node || degree_[v] != 2 || held_[v]) break;
        passed_[v] = 1;
        for (uint64_t j = cells_.vertex_edges.offset[v]; j < cells_.vertex_edges.offset[v + 1]; ++j)
          if (curve_[cells_.vertex_edges.index[j]]) e = cells_.vertex_edges.index[j];
      }
      resample();
    }
  }

  void resample() {
    const std::size_t n = chain_.size();
    std::vector<double> at(n, 0); // steps from the start
    for (std::size_t i = 1; i < n; ++i) {
      const int32_t a = chain_[i - 1], b = chain_[i];
      const double width = spacing_ * (time_[a] + time_[b]) / 2;
      const double l = distance(cells_.ball[a].center, cells_.ball[b].center);
      at[i] = at[i - 1] + (width > 0 ? l / width : 1);
    }
    const int32_t first = number(chain_.front()), last = number(chain_.back());
    int edges = int(std::clamp(std::round(at.back()), 1.0, kMostEdges));
    if (first == last)
      edges = std::max(edges, 3);
    else if (edges == 1 && !take(first, last))
      edges = 2;
    int32_t before = first;
    for (int k = 1; k < edges; ++k) {
      const int32_t v = int32_t(out_.ball.size());
      out_.ball.push_back(mean(at, at.back() * k / edges, at.back() / edges));
      fixed_.push_back(0);
      out_.edge.push_back({before, v});
      before = v;
    }
    out_.edge.push_back({before, last});
  }

  /// Over the stretch `reach` before and behind a place.
  Ball mean(const std::vector<double> &at, double place, double reach) const {
    reach = std::min({reach, place, at.back() - place});
    Ball out;
    for (int k = 0; k < kMeanOf; ++k) {
      const double s = place + reach * (2.0 * k / (kMeanOf - 1) - 1);
      const std::size_t i = std::clamp<std::size_t>(
          std::upper_bound(at.begin(), at.end(), s) - at.begin(), 1, at.size() - 1);
      const double step = at[i] - at[i - 1];
      const double t = step > 0 ? std::clamp((s - at[i - 1]) / step, 0.0, 1.0) : 0;
      const Ball &a = cells_.ball[chain_[i - 1]], &b = cells_.ball[chain_[i]];
      out.center += (a.center * (1 - t) + b.center * t) * (1.0 / kMeanOf);
      out.radius += (a.radius * (1 - t) + b.radius * t) / kMeanOf;
    }
    return out;
  }

  void smooth() {
    const Incidence at = lists_of(out_.ball.size(), out_.edge);
    for (int round = 0; round < kSmoothings; ++round) {
      std::vector<Ball> next = out_.ball;
      for (std::size_t v = 0; v < next.size(); ++v) {
        progress_.tick(0, 1);
        const uint64_t begin = at.offset[v], end = at.offset[v + 1];
        if (fixed_[v] || end - begin < 2) continue;
        Ball sum;
        for (uint64_t k = begin; k < end; ++k) {
          const auto &e = out_.edge[at.index[k]];
          const Ball &other = out_.ball[e[0] == int32_t(v) ? e[1] : e[0]];
          sum.center += other.center;
          sum.radius += other.radius;
        }
        const double share = 0.5 / double(end - begin);
        next[v].center = out_.ball[v].center * 0.5 + sum.center * share;
        next[v].radius = out_.ball[v].radius * 0.5 + sum.radius * share;
      }
      out_.ball.swap(next);
    }
  }

  const AxisCells &cells_;
  const AxisState &left_;
  const std::vector<double> &time_;
  double spacing_;
  Progress &progress_;
  std::vector<uint8_t> curve_; // per edge: of a curve not walked yet
  std::vector<int32_t> degree_, number_;
  std::vector<uint8_t> held_, passed_;
  std::vector<int32_t> chain_;
  std::set<std::array<int32_t, 2>> ends_; // of edges there are
  std::vector<uint8_t> fixed_;            // per ball of out_
  BallComplex out_;
};

} // namespace

BallComplex thin_curves(const AxisCells &cells, const Burnt &burnt, double spacing,
                        Progress &progress) {
  return Thinner(cells, burnt, spacing, progress).run();
}

} // namespace vbm::impl
