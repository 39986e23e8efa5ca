// SPDX-License-Identifier: GPL-3.0-or-later
// An edge ab may be contracted if Lk(a) and Lk(b) have nothing in common but Lk(ab): Dey,
// Edelsbrunner, Guha, Nekhayev, "Topology preserving edge contraction" (1999), for surfaces;
// Attali, Lieutier, Salinas, "Efficient data structure for representing and simplifying simplicial
// complexes in high dimensions" (2011), for the homotopy type of any complex. In a complex of
// triangles that says: a common neighbour of a and b makes a triangle with them, and no edge makes
// one with a and one with b. The cost is that of "Sphere-meshes" (Thiery et al. 2013): the ball
// that lies best to the planes both balls stood for; along a tube one end would slide into the
// other at no cost, so reaching farther than a ball's own radius costs too. Spikes, which "Q-MAT"
// (Li et al. 2015) finds by a ratio of stability, go first by that cost alone, as their balls'
// planes are nearly those of the balls below.
#include "medial/contract.h"

#include "core/progress.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_set>

namespace vbm::impl {
namespace {

/// Share of the planes' weight with which a contracted ball is held near the middle of its two:
/// where planes leave it free to slide, it stays.
constexpr double kAnchor = 1e-3;

/// What squared distances from the balls that went into one count, beyond its own radius, beside
/// those from planes.
constexpr double kReach = 0.03;

/// Of the balls that went into one: their weight, and its first and second moments.
struct Moments {
  double weight = 0, second = 0;
  Vec3 first;

  void operator+=(const Moments &o) {
    weight += o.weight, second += o.second;
    first += o.first;
  }
  /// Sum of weighted squared distances from p.
  double about(const Vec3 &p) const { return second - 2 * dot(first, p) + weight * dot(p, p); }
};

using Triangle3 = std::array<int32_t, 3>;

class Contractor {
public:
  Contractor(BallComplex &complex, std::vector<BallQuadric> &quadric, Progress &progress)
      : complex_(complex), quadric_(quadric), progress_(progress), left_(complex.ball.size()),
        gone_into_(complex.ball.size(), -1), version_(complex.ball.size(), 0),
        neighbors_(complex.ball.size()), triangles_(complex.ball.size()),
        mark_(complex.ball.size(), 0) {
    for (std::size_t v = 0; v < quadric.size(); ++v) {
      const double weight = quadric[v].weight();
      const Vec3 &p = complex.ball[v].center;
      moments_.push_back({weight, weight * dot(p, p), p * weight});
    }
    for (const auto &e : all_edges(complex)) {
      neighbors_[e[0]].push_back(e[1]);
      neighbors_[e[1]].push_back(e[0]);
    }
    for (std::size_t t = 0; t < complex.triangle.size(); ++t)
      for (int32_t v : complex.triangle[t]) triangles_[v].push_back(int32_t(t));
  }

  void run(std::size_t count) {
    for (std::size_t v = 0; v < neighbors_.size(); ++v) {
      progress_.tick(0, 1);
      for (int32_t u : neighbors_[v])
        if (int32_t(v) < u) offer(int32_t(v), u);
    }
    const std::size_t whole = left_;
    while (left_ > count && !queue_.empty()) {
      progress_.tick(whole - left_, whole - count);
      const Candidate c = queue_.top();
      queue_.pop();
      if (c.version != version_[c.a] + version_[c.b] || gone(c.a) || gone(c.b)) continue;
      if (allowed(c.a, c.b))
        join(c.a, c.b);
      else
        blocked_.insert(key(c.a, c.b));
    }
  }

  void finish(std::vector<int32_t> *into) {
    std::vector<int32_t> number(neighbors_.size(), -1);
    int32_t next = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (gone(int32_t(v))) continue;
      complex_.ball[next] = complex_.ball[v];
      quadric_[next] = quadric_[v];
      number[v] = next++;
    }
    BallComplex out;
    complex_.ball.resize(next);
    quadric_.resize(next);
    out.ball = std::move(complex_.ball);
    std::vector<Triangle3> &triangles = complex_.triangle;
    for (const Triangle3 &t : triangles)
      if (t[0] >= 0) out.triangle.push_back({number[t[0]], number[t[1]], number[t[2]]});
    for (std::size_t v = 0; v < number.size(); ++v)
      for (int32_t u : neighbors_[v])
        if (int32_t(v) < u && !has_triangle(int32_t(v), u))
          out.edge.push_back({number[v], number[u]});
    complex_ = std::move(out);
    if (!into) return;
    into->assign(number.size(), -1);
    for (std::size_t v = 0; v < number.size(); ++v) {
      int32_t u = int32_t(v);
      while (gone(u)) u = gone_into_[u];
      for (int32_t w = int32_t(v); gone(w);) { // shorter ways for the next
        const int32_t below = gone_into_[w];
        gone_into_[w] = u;
        w = below;
      }
      (*into)[v] = number[u];
    }
  }

private:
  struct Candidate {
    double cost;
    int32_t a, b;
    uint32_t version; // sum of both, which only grow
    bool operator>(const Candidate &o) const {
      if (cost != o.cost) return cost > o.cost;
      return a != o.a ? a > o.a : b > o.b;
    }
  };

  bool gone(int32_t v) const { return gone_into_[v] >= 0; }
  static uint64_t key(int32_t a, int32_t b) {
    return uint64_t(uint32_t(std::min(a, b))) << 32 | uint32_t(std::max(a, b));
  }
  bool has(int32_t t, int32_t v) const {
    const Triangle3 &c = complex_.triangle[t];
    return c[0] == v || c[1] == v || c[2] == v;
  }
  bool has_triangle(int32_t a, int32_t b) const {
    for (int32_t t : triangles_[a])
      if (has(t, b)) return true;
    return false;
  }

  Ball joined(int32_t a, int32_t b, BallQuadric &sum) const {
    sum = quadric_[a];
    sum += quadric_[b];
    const Ball &x = complex_.ball[a], &y = complex_.ball[b];
    const double wa = quadric_[a].weight(), wb = quadric_[b].weight();
    const double share = wa + wb > 0 ? wb / (wa + wb) : 0.5;
    const Ball middle{x.center * (1 - share) + y.center * share,
                      x.radius * (1 - share) + y.radius * share};
    BallQuadric held = sum;
    held.add_anchor(middle, kAnchor * (wa + wb));
    Ball out;
    if (held.least(out) && out.radius > 0) return out;
    return middle;
  }

  void offer(int32_t a, int32_t b) {
    BallQuadric sum;
    const Ball ball = joined(a, b, sum);
    Moments moments = moments_[a];
    moments += moments_[b];
    const double reach = moments.about(ball.center) - moments.weight * ball.radius * ball.radius;
    const double cost = sum.at(ball) + kReach * std::max(0.0, reach);
    if (a > b) std::swap(a, b);
    queue_.push({cost, a, b, version_[a] + version_[b]});
  }

  /// The link condition.
  bool allowed(int32_t a, int32_t b) {
    ++stamp_;
    for (int32_t u : neighbors_[a]) mark_[u] = stamp_;
    std::size_t common = 0, triangles = 0;
    for (int32_t u : neighbors_[b]) common += mark_[u] == stamp_;
    for (int32_t t : triangles_[b]) triangles += has(t, a);
    if (common != triangles) return false;
    across_.clear(); // edges in the link of b that may be in a's
    for (int32_t t : triangles_[b]) {
      if (has(t, a)) continue;
      const auto [c, d] = others(t, b);
      if (mark_[c] == stamp_ && mark_[d] == stamp_) across_.push_back(key(c, d));
    }
    if (across_.empty()) return true;
    for (int32_t t : triangles_[a]) {
      if (has(t, b)) continue;
      const auto [c, d] = others(t, a);
      if (std::find(across_.begin(), across_.end(), key(c, d)) != across_.end()) return false;
    }
    return true;
  }

  std::array<int32_t, 2> others(int32_t t, int32_t v) const {
    const Triangle3 &c = complex_.triangle[t];
    return c[0] == v ? std::array<int32_t, 2>{c[1], c[2]}
                     : std::array<int32_t, 2>{c[0], c[1] == v ? c[2] : c[1]};
  }

  static void drop(std::vector<int32_t> &list, int32_t item) {
    *std::find(list.begin(), list.end(), item) = list.back();
    list.pop_back();
  }

  /// b goes into a.
  void join(int32_t a, int32_t b) {
    BallQuadric sum;
    complex_.ball[a] = joined(a, b, sum);
    quadric_[a] = sum;
    moments_[a] += moments_[b];
    for (int32_t t : triangles_[b]) {
      Triangle3 &corners = complex_.triangle[t];
      if (has(t, a)) {
        for (int32_t v : corners)
          if (v != b) drop(triangles_[v], t);
        corners = {-1, -1, -1};
        continue;
      }
      for (int32_t &v : corners)
        if (v == b) v = a;
      triangles_[a].push_back(t);
    }
    ++stamp_;
    for (int32_t u : neighbors_[a]) mark_[u] = stamp_;
    for (int32_t u : neighbors_[b]) {
      if (u == a) continue;
      if (mark_[u] == stamp_) {
        drop(neighbors_[u], b);
      } else {
        *std::find(neighbors_[u].begin(), neighbors_[u].end(), b) = a;
        neighbors_[a].push_back(u);
      }
    }
    drop(neighbors_[a], b);
    std::vector<int32_t>().swap(neighbors_[b]);
    std::vector<int32_t>().swap(triangles_[b]);
    gone_into_[b] = a;
    version_[a] += version_[b] + 1; // larger than any sum seen with either
    --left_;
    for (int32_t u : neighbors_[a]) {
      if (!blocked_.empty()) blocked_.erase(key(a, u));
      offer(a, u);
    }
    if (blocked_.empty()) return;
    // Links of a's neighbours have changed too. An edge between two of them that makes no triangle
    // with a is still blocked by a.
    for (int32_t t : triangles_[a]) {
      const auto [c, d] = others(t, a);
      if (blocked_.erase(key(c, d))) offer(c, d);
    }
  }

  BallComplex &complex_;
  std::vector<BallQuadric> &quadric_;
  std::vector<Moments> moments_;
  Progress &progress_;
  std::size_t left_;
  std::vector<int32_t> gone_into_; // per ball, -1 while it is there
  std::vector<uint32_t> version_;
  std::vector<std::vector<int32_t>> neighbors_, triangles_; // per ball
  std::vector<uint32_t> mark_;
  uint32_t stamp_ = 0;
  std::vector<uint64_t> across_;
  std::unordered_set<uint64_t> blocked_; // edges that had their turn but were not allowed
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> queue_;
};

} // namespace

void contract(BallComplex &complex, std::vector<BallQuadric> &quadric, std::size_t count,
              std::vector<int32_t> *into, Progress &progress) {
  Contractor contractor(complex, quadric, progress);
  contractor.run(count);
  contractor.finish(into);
}

} // namespace vbm::impl
