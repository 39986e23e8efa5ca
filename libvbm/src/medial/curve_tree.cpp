// SPDX-License-Identifier: GPL-3.0-or-later
// Curves burn on from their loose ends. When fire comes to a vertex along a curve later than it
// came over the sheets, by what Yan et al. (2016) call the curve's erosion thickness, the shape
// goes on there for longer than it is wide. Every vertex off the core has one edge towards the
// core: they form trees, as rivers do, of which the main channels stay. A channel begins where its
// thickness passes a small share of the limit, so that limbs keep their length, but only if it
// passes the limit farther down.
#include "medial/curve_tree.h"

#include "core/progress.h"
#include "medial/cell_lists.h"

#include <algorithm>
#include <queue>

namespace vbm::impl {
namespace {

/// Share of the limit's ratio from which on a branch that passes both limits is kept. Less would
/// let curves bend into one of several corners that they end between.
constexpr double kBeginning = 0.6;

/// Half widths of the shape. Ways along edges are jagged: their length is measured straight over
/// stretches of about this.
constexpr double kStretch = 1;

class Cutter {
public:
  Cutter(const AxisCells &cells, const SpurLimit &limit, Burnt &burnt, Progress &progress)
      : cells_(cells), limit_(limit), left_(burnt.left), time_(burnt.time), progress_(progress) {}

  void run() {
    count();
    grow_trees();
    cut();
  }

private:
  void count() {
    edges_at_.assign(cells_.ball.size(), 0);
    held_.assign(cells_.ball.size(), 0);
    for (std::size_t e = 0; e < cells_.edge.size(); ++e)
      if (left_.edge[e])
        for (int32_t v : cells_.edge[e]) ++edges_at_[v];
    for (std::size_t t = 0; t < cells_.triangle.size(); ++t)
      if (left_.triangle[t])
        for (int32_t v : cells_.triangle[t]) held_[v] = 1;
  }

  bool loose(int32_t v) const { return left_.vertex[v] && edges_at_[v] == 1 && !held_[v]; }

  /// Burn from the loose ends; a vertex that burns points down the only edge it has left.
  void grow_trees() {
    down_.assign(cells_.ball.size(), -1);
    arrival_ = time_;
    start_.resize(cells_.ball.size());
    start_time_ = time_;
    for (std::size_t v = 0; v < start_.size(); ++v) start_[v] = int32_t(v);
    std::vector<uint8_t> gone(cells_.ball.size(), 0);
    std::priority_queue<std::pair<double, int32_t>, std::vector<std::pair<double, int32_t>>,
                        std::greater<std::pair<double, int32_t>>>
        queue;
    for (std::size_t v = 0; v < cells_.ball.size(); ++v)
      if (loose(int32_t(v))) queue.push({arrival_[v], int32_t(v)});
    while (!queue.empty()) {
      progress_.tick(order_.size(), cells_.ball.size());
      const int32_t v = queue.top().second;
      queue.pop();
      if (edges_at_[v] != 1) continue; // the last of its tree
      for (uint64_t k = cells_.vertex_edges.offset[v]; k < cells_.vertex_edges.offset[v + 1]; ++k) {
        const int32_t e = cells_.vertex_edges.index[k];
        if (left_.edge[e] && !gone[other_end(e, v)]) down_[v] = e;
      }
      const int32_t u = other_end(down_[v], v);
      gone[v] = 1;
      order_.push_back(v);
      edges_at_[v] = 0;
      --edges_at_[u];
      const double there = arrival_at(u, v);
      if (there > arrival_[u]) {
        arrival_[u] = there;
        start_[u] = start_[v];
        start_time_[u] = start_time_[v];
        if (span(start_[u], u) > kStretch * time_[u]) {
          start_[u] = u;
          start_time_[u] = there;
        }
      }
      if (loose(u)) queue.push({arrival_[u], u});
    }
  }

  int32_t other_end(int32_t e, int32_t v) const {
    return cells_.edge[e][0] == v ? cells_.edge[e][1] : cells_.edge[e][0];
  }
  double span(int32_t a, int32_t b) const {
    return distance(cells_.ball[a].center, cells_.ball[b].center);
  }
  /// When fire that comes from v is at u, below it.
  double arrival_at(int32_t u, int32_t v) const { return start_time_[v] + span(start_[v], u); }
  bool passes(int32_t v) const {
    const double thickness = arrival_[v] - time_[v];
    return thickness > limit_.length && thickness > limit_.ratio * time_[v];
  }
  bool begins(int32_t v) const {
    return arrival_[v] - time_[v] > kBeginning * limit_.ratio * time_[v];
  }

  void cut() {
    std::vector<uint8_t> keep(cells_.ball.size(), 0);
    for (int32_t v : order_) { // from the ends down
      if (passes(v)) keep[v] = 1;
      if (keep[v]) keep[other_end(down_[v], v)] = 1;
    }
    // Up again from where the limit is passed, along the longest way.
    std::vector<int32_t> longest(cells_.ball.size(), -1);
    for (int32_t v : order_) {
      const int32_t u = other_end(down_[v], v);
      int32_t &best = longest[u];
      if (best < 0 || arrival_at(u, v) > arrival_at(u, best)) best = v;
    }
    for (std::size_t i = order_.size(); i-- > 0;) {
      const int32_t v = order_[i], u = other_end(down_[v], v);
      if (keep[u] && longest[u] == v && begins(v)) keep[v] = 1;
    }
    for (int32_t v : order_) {
      if (keep[v]) continue;
      left_.vertex[v] = 0;
      left_.edge[down_[v]] = 0;
    }
  }

  const AxisCells &cells_;
  const SpurLimit &limit_;
  AxisState &left_;
  const std::vector<double> &time_;
  Progress &progress_;
  std::vector<int32_t> edges_at_;  // per vertex: not burnt yet
  std::vector<uint8_t> held_;      // has a triangle
  std::vector<double> arrival_;    // of the fire along curves
  std::vector<int32_t> start_;     // of the stretch it is on, a vertex
  std::vector<double> start_time_; // when it was there
  std::vector<int32_t> down_;      // the edge towards the core
  std::vector<int32_t> order_;     // vertices as they burn
};

} // namespace

void cut_spurs(const AxisCells &cells, const SpurLimit &limit, Burnt &burnt, Progress &progress) {
  Cutter(cells, limit, burnt, progress).run();
}

} // namespace vbm::impl
