// SPDX-License-Identifier: GPL-3.0-or-later
// Burn times follow Yan, Sykes, Chambers, Letscher, Ju, "Erosion thickness on medial axes of 3D
// shapes" (2016): fire starts at each ball of the border when its radius is over, runs along the
// sheets at unit speed, and where several sheets meet goes on when all but one have burnt. They
// subdivide the axis into a graph and burn that; here the front crosses whole triangles as in
// Kimmel and Sethian, "Computing geodesic paths on manifolds" (1998), and each triangle that burns
// is an elementary collapse through an edge that has no other triangle left.
#include "medial/burn.h"

#include "core/progress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <tuple>

namespace vbm::impl {
namespace {

/// When a straight front that passes a and b at ta and tb reaches c; along the edges, if it would
/// not come through ab.
double arrival(const Vec3 &a, const Vec3 &b, const Vec3 &c, double ta, double tb) {
  const double along_edges = std::min(ta + distance(a, c), tb + distance(b, c));
  const Vec3 ab = b - a, ac = c - a;
  const double l = length(ab);
  if (!(l > 0)) return along_edges;
  const double slope = (tb - ta) / l; // of the time along ab
  if (!(std::fabs(slope) < 1)) return along_edges;
  const double x = dot(ac, ab) / l, y = std::sqrt(std::max(0.0, dot(ac, ac) - x * x));
  const double rise = std::sqrt(1 - slope * slope);
  const double from = x - y * slope / rise; // where on ab the way to c begins
  if (from < 0 || from > l) return along_edges;
  return std::min(along_edges, ta + slope * x + rise * y);
}

class Burner {
public:
  Burner(const AxisCells &cells, const AxisState &state, Progress &progress)
      : cells_(cells), progress_(progress), end_(cells.edge.size()), count_(cells.edge.size(), 0) {
    out_.left = state;
    for (const Ball &ball : cells.ball) out_.time.push_back(ball.radius);
  }

  Burnt run() {
    for (std::size_t t = 0; t < cells_.triangle.size(); ++t)
      if (out_.left.triangle[t])
        for (int32_t e : cells_.triangle_edges[t]) ++count_[e];
    for (std::size_t e = 0; e < cells_.edge.size(); ++e) {
      for (int i = 0; i < 2; ++i) end_[e][i] = cells_.ball[cells_.edge[e][i]].radius;
      offer(int32_t(e));
    }
    std::size_t burnt = 0;
    while (!queue_.empty()) {
      progress_.tick(burnt++, cells_.triangle.size());
      const int32_t e = std::get<1>(queue_.top());
      queue_.pop();
      if (out_.left.edge[e] && count_[e] == 1) burn_through(e);
    }
    return std::move(out_);
  }

private:
  struct Front {
    int32_t triangle;
    int32_t corner; // opposite the edge
    double time;    // when it is reached
  };

  Front front(int32_t e) const {
    Front out{-1, -1, 0};
    for (uint64_t k = cells_.edge_triangles.offset[e]; k < cells_.edge_triangles.offset[e + 1]; ++k)
      if (out_.left.triangle[cells_.edge_triangles.index[k]])
        out.triangle = cells_.edge_triangles.index[k];
    const auto &ends = cells_.edge[e];
    for (int32_t v : cells_.triangle[out.triangle])
      if (v != ends[0] && v != ends[1]) out.corner = v;
    out.time = arrival(cells_.ball[ends[0]].center, cells_.ball[ends[1]].center,
                       cells_.ball[out.corner].center, end_[e][0], end_[e][1]);
    return out;
  }

  void offer(int32_t e) {
    if (!out_.left.edge[e] || count_[e] != 1) return;
    queue_.push({(end_[e][0] + end_[e][1] + front(e).time) / 3, e});
  }

  void burn_through(int32_t e) {
    const Front f = front(e);
    out_.left.triangle[f.triangle] = 0;
    out_.left.edge[e] = 0;
    count_[e] = 0;
    out_.time[f.corner] = std::max(out_.time[f.corner], f.time);
    for (int32_t other : cells_.triangle_edges[f.triangle]) {
      if (other == e) continue;
      for (int i = 0; i < 2; ++i) {
        const int32_t v = cells_.edge[other][i];
        const double t = v == f.corner ? f.time : end_[e][v == cells_.edge[e][0] ? 0 : 1];
        end_[other][i] = std::max(end_[other][i], t);
      }
      --count_[other];
      offer(other);
    }
  }

  const AxisCells &cells_;
  Progress &progress_;
  std::vector<std::array<double, 2>> end_; // per edge: when fire is at its ends
  std::vector<int32_t> count_;             // per edge: triangles left
  using Entry = std::pair<double, int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
  Burnt out_;
};

} // namespace

Burnt burn(const AxisCells &cells, const AxisState &state, Progress &progress) {
  return Burner(cells, state, progress).run();
}

} // namespace vbm::impl
