// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 7.4 and 8.3.3: where four balls or more meet in one point, several triangles give the same
// singular point, and they are told to be the same by incidence: their balls touch one sample. Of
// bare lists of balls nothing is known but their numbers; there an arc that is shorter than what
// the balls' changed radii can have moved its ends by is one point.
//
// It differs in that nothing is merged that would change the surface: arcs are contracted one by
// one, none that ends where it begins, so that the surface stays what it is. What stands at one
// place and hangs together in no such way are two vertices: that is how places where the surface
// touches itself are kept apart.
#include "ball_surface/merge_points.h"

#include "core/progress.h"
#include "core/sort_in_buckets.h"
#include "dual/orthospheres.h"

#include <algorithm>

namespace vbm::impl {

int32_t TouchedSamples::common(const DualShape &shape, int32_t code) const {
  if (!lists) return -1;
  const DualShape::Triangle &t = shape.triangles[code / 2];
  const int32_t *at[3], *end[3];
  for (int i = 0; i < 3; ++i) {
    const int32_t b = (*ball)[t.ball[i]];
    at[i] = lists->index.data() + lists->offset[b];
    end[i] = lists->index.data() + lists->offset[b + 1];
  }
  while (at[0] != end[0] && at[1] != end[1] && at[2] != end[2]) {
    const int32_t most = std::max({*at[0], *at[1], *at[2]});
    if (*at[0] == most && *at[1] == most && *at[2] == most) {
      const Vec3 a = center_of(shape.site[t.ball[0]]), b = center_of(shape.site[t.ball[1]]),
                 c = center_of(shape.site[t.ball[2]]);
      const double over = dot(cross(b - a, c - a), (*position)[most] - a);
      if (code & 1 ? over >= 0 : over <= 0) return most;
      ++at[0];
      continue;
    }
    for (int i = 0; i < 3; ++i)
      while (at[i] != end[i] && *at[i] < most) ++at[i];
  }
  return -1;
}

std::vector<int32_t> TouchedSamples::of(const BoundaryMap &map, const DualShape &shape,
                                        Progress &progress) const {
  std::vector<int32_t> sample(map.position.size(), -1);
  if (!lists) return sample;
  for (std::size_t v = 0; v < sample.size(); ++v) {
    progress.tick(v, sample.size());
    sample[v] = common(shape, map.code[v]);
  }
  return sample;
}

namespace {

class Contraction {
public:
  Contraction(const BoundaryMap &map, const DualShape &shape, MergedPoints &points,
              Progress &progress)
      : map_(map), shape_(shape), points_(points), progress_(progress) {
    out_.contracted.assign(map.spans.size(), 0);
  }

  /// Arcs that are nothing but two names for their place.
  void null_arcs() {
    const bool samples = points_.has_samples();
    for (double b : map_.blur) most_blur_ = std::max(most_blur_, 2 * b);
    for (std::size_t s = 0; s < map_.spans.size(); ++s) {
      progress_.tick(s, map_.spans.size());
      const int32_t u = map_.from[2 * s], v = map_.from[2 * s + 1];
      if (u >= 0 && map_.spans[s].angle < kRound && is_null(u, v, samples))
        out_.merged += contract(s, points_.find(u), points_.find(v));
    }
  }

  /// Arcs that are no longer than what is narrow at both their balls, the shortest first.
  void short_arcs(const std::vector<double> &reach) {
    std::vector<Short> arcs;
    double longest = 0;
    for (std::size_t s = 0; s < map_.spans.size(); ++s) {
      progress_.tick(s, map_.spans.size());
      if (map_.from[2 * s] < 0) continue;
      const int32_t u = points_.find(map_.from[2 * s]), v = points_.find(map_.from[2 * s + 1]);
      const BoundaryMap::Span &span = map_.spans[s];
      const DualShape::Edge &edge = shape_.edges[span.edge];
      if (reach[edge.a] == 0) points_.fix(u);
      if (reach[edge.b] == 0) points_.fix(v);
      const double most = std::min(reach[edge.a], reach[edge.b]);
      if (out_.contracted[s] || span.angle > kRound) continue;
      const double l = distance(points_.at(u), points_.at(v));
      if (!(l <= most)) continue;
      arcs.push_back({l, most, uint32_t(s)});
      longest = std::max(longest, l);
    }
    if (longest == 0) longest = 1;
    const double many = double(arcs.size());
    const auto sorted = sorted_in_buckets(
        arcs, arcs.size() + 1, [&](const Short &a) { return a.length / longest * many; },
        [](const Short &a, const Short &b) {
          return a.length != b.length ? a.length < b.length : a.span < b.span;
        },
        progress_);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      progress_.tick(1, 1);
      const Short &a = sorted[i];
      const int32_t u = points_.find(map_.from[2 * a.span]),
                    v = points_.find(map_.from[2 * a.span + 1]);
      if (u == v || (points_.stays(u) && points_.stays(v))) continue;
      const double far = points_.reach_of(u, v);
      if (!(far <= kDrift * a.reach)) continue;
      points_.unite(u, v, far);
      out_.contracted[a.span] = 1;
    }
  }

  ContractedArcs take() { return std::move(out_); }

private:
  struct Short {
    double length, reach;
    uint32_t span;
  };

  bool is_null(int32_t u, int32_t v, bool samples) {
    if (samples) {
      const int32_t p = points_.sample(points_.find(u)), q = points_.sample(points_.find(v));
      if (p >= 0 && q >= 0) return p == q;
    }
    const double gap = distance(map_.position[u], map_.position[v]);
    return gap <= most_blur_ && gap <= map_.blur[u] + map_.blur[v]; // the first tells of most
  }

  bool contract(std::size_t s, int32_t u, int32_t v) {
    if (u == v) return false;
    points_.unite(u, v);
    out_.contracted[s] = 1;
    return true;
  }

  const BoundaryMap &map_;
  const DualShape &shape_;
  MergedPoints &points_;
  Progress &progress_;
  ContractedArcs out_;
  double most_blur_ = 0; // of two points together
};

} // namespace

ContractedArcs contract_arcs(const BoundaryMap &map, const DualShape &shape,
                             const std::vector<double> &reach, MergedPoints &points,
                             Progress &progress) {
  Contraction contraction(map, shape, points, progress);
  contraction.null_arcs();
  if (!reach.empty()) contraction.short_arcs(reach);
  return contraction.take();
}

} // namespace vbm::impl
