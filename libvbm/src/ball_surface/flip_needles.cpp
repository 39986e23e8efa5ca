// SPDX-License-Identifier: GPL-3.0-or-later
// Lawson's flips, of needles only: every other triangle is as its ball's patch has it. Every flip
// shortens an edge, so that they come to an end.
#include "ball_surface/flip_needles.h"

#include "ball_surface/thinness.h"
#include "core/progress.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

/// Squared sine of the smallest angle of a triangle that is a needle: of 15 degrees.
constexpr double kNeedle = 0.067;

/// Share of the radius.
constexpr double kDeep = 0.02;

/// Share of a product of lengths: what it may err by, and a thousand times more.
constexpr double kUnsure = 1e-12;

class Flipping {
public:
  Flipping(const std::vector<Vec3> &position, const std::vector<Ball> &balls,
           const std::vector<uint8_t> &wide, std::vector<std::array<int32_t, 3>> &triangles,
           const std::vector<int32_t> &ball, Progress &progress)
      : position_(position), balls_(balls), wide_(wide), t_(triangles), ball_(ball),
        progress_(progress), moved_(triangles.size(), 0) {}

  std::vector<uint8_t> run() {
    std::vector<int32_t> work;
    for (std::size_t i = t_.size(); i-- > 0;) {
      progress_.tick(0, 1);
      if (is_bad(int32_t(i))) work.push_back(int32_t(i));
    }
    if (work.empty()) return std::move(moved_);
    list_sides();
    while (!work.empty()) {
      progress_.tick(1, 1);
      const int32_t i = work.back();
      work.pop_back();
      if (!is_bad(i)) continue;
      for (int k = 0; k < 3; ++k) {
        const int32_t g = twin(3 * i + k);
        if (!flip(3 * i + k, g)) continue;
        work.push_back(g / 3);
        work.push_back(i);
        break;
      }
    }
    return std::move(moved_);
  }

private:
  /// Whether it is a needle, faces its ball, or has an edge that is far from it for its size.
  bool is_bad(int32_t i) const {
    const Vec3 &a = position_[t_[i][0]], &b = position_[t_[i][1]], &c = position_[t_[i][2]];
    const Ball &ball = balls_[ball_[i]];
    if (thinness(a, b, c) < kNeedle) return true;
    // Most are seen not to face it from any corner.
    const Vec3 p = b - a, q = c - a, out = a + b + c - ball.center * 3.0;
    const double most = std::max(dot(p, p), dot(q, q)) *
                        (1 + std::fabs(out.x) + std::fabs(out.y) + std::fabs(out.z));
    if (!(dot(cross(p, q), out) > kUnsure * most) && faces_ball(i, t_[i][0], t_[i][1], t_[i][2]))
      return true;
    const double square = ball.radius * ball.radius;
    const auto is_deep = [&](const Vec3 &x) {
      const Vec3 d = x - ball.center;
      const double there = dot(d, d);
      return there < (1 - kDeep) * (1 - kDeep) * square ||
             there > (1 + kDeep) * (1 + kDeep) * square;
    };
    return is_deep((a + b) * 0.5) || is_deep((b + c) * 0.5) || is_deep((c + a) * 0.5);
  }

  int32_t from(int32_t h) const { return t_[h / 3][h % 3]; }
  static int32_t next(int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }

  /// Chains of the sides that begin at each vertex, as they are at first: twins are looked up
  /// there, as few ever are, and kept.
  void list_sides() {
    first_.assign(position_.size(), -1);
    after_.resize(3 * t_.size());
    twin_.assign(3 * t_.size(), -1);
    for (std::size_t h = 0; h < after_.size(); ++h) {
      progress_.tick(h, after_.size());
      int32_t &first = first_[from(int32_t(h))];
      after_[h] = first;
      first = int32_t(h);
    }
  }

  /// All twins of triangles that were flipped are known, so that what is looked for is where it was
  /// listed; others in the chain may not be.
  int32_t twin(int32_t h) {
    if (twin_[h] >= 0) return twin_[h];
    const int32_t u = from(h), v = from(next(h));
    int32_t g = first_[v];
    while (from(g) != v || from(next(g)) != u) g = after_[g];
    link(h, g);
    return g;
  }

  void link(int32_t h, int32_t g) {
    twin_[h] = g;
    twin_[g] = h;
  }

  bool are_joined(int32_t h, int32_t v) { // h begins at the other
    int32_t at = h;
    do {
      if (from(next(at)) == v || from(next(next(at))) == v) return true;
      at = next(twin(at));
    } while (at != h);
    return false;
  }

  /// How far a place is from the surface of two balls.
  double depth(const Vec3 &x, int32_t i, int32_t j) const {
    const Ball &a = balls_[ball_[i]], &b = balls_[ball_[j]];
    return std::fabs(std::max(a.radius - distance(x, a.center), b.radius - distance(x, b.center)));
  }

  /// Computed from the same corner whichever way it is asked, so that it is the same always.
  bool faces_ball(int32_t i, int32_t a, int32_t b, int32_t c) const {
    while (a > b || a > c) {
      std::swap(a, b);
      std::swap(b, c);
    }
    const Vec3 &p = position_[a], &q = position_[b], &r = position_[c];
    return dot(cross(q - p, r - p), p + q + r - balls_[ball_[i]].center * 3.0) < 0;
  }

  bool flip(int32_t h, int32_t g) {
    const int32_t i = h / 3, j = g / 3;
    const int32_t h1 = next(h), h2 = next(h1), g1 = next(g), g2 = next(g1);
    const int32_t a = from(h), b = from(g), c = from(h2), d = from(g2);
    if (c == d) return false;
    if (ball_[i] != ball_[j] && (wide_[ball_[i]] || wide_[ball_[j]])) return false;
    const Vec3 &pa = position_[a], &pb = position_[b], &pc = position_[c], &pd = position_[d];
    // Triangles that face their ball are wrong whatever else they are.
    const int wrong = faces_ball(i, a, b, c) + faces_ball(j, b, a, d),
              left = faces_ball(i, c, a, d) + faces_ball(j, d, b, c);
    if (left > wrong) return false;
    if (left == wrong) {
      if (distance(pc, pd) >= distance(pa, pb)) return false;
      const double thin = std::min(thinness(pa, pb, pc), thinness(pb, pa, pd)),
                   new_thin = std::min(thinness(pc, pa, pd), thinness(pd, pb, pc)),
                   deep = depth((pa + pb) * 0.5, i, j), new_deep = depth((pc + pd) * 0.5, i, j);
      if (new_deep > deep) return false;
      const bool flatter = 2 * new_deep < deep && new_thin > std::min(thin, kNeedle);
      if (!flatter && (thin >= kNeedle || new_thin <= thin)) return false;
    }
    if (are_joined(h2, d)) return false;
    // i: c a d, j: d b c.
    const int32_t ca = twin(h2), ad = twin(g1), db = twin(g2), bc = twin(h1);
    t_[i] = {c, a, d};
    t_[j] = {d, b, c};
    link(3 * i, ca);
    link(3 * i + 1, ad);
    link(3 * j, db);
    link(3 * j + 1, bc);
    link(3 * i + 2, 3 * j + 2);
    moved_[i] = moved_[j] = 1;
    return true;
  }

  const std::vector<Vec3> &position_;
  const std::vector<Ball> &balls_;
  const std::vector<uint8_t> &wide_;
  std::vector<std::array<int32_t, 3>> &t_;
  const std::vector<int32_t> &ball_;
  Progress &progress_;
  std::vector<uint8_t> moved_;
  std::vector<int32_t> first_; // by vertex: a side 3 * triangle + corner, -1 for none
  std::vector<int32_t> after_; // by side: the next of its vertex
  std::vector<int32_t> twin_;  // by side, -1 where nobody asked
};

} // namespace

std::vector<uint8_t> flip_needles(const std::vector<Vec3> &position, const std::vector<Ball> &balls,
                                  const std::vector<uint8_t> &wide,
                                  std::vector<std::array<int32_t, 3>> &triangles,
                                  const std::vector<int32_t> &ball, Progress &progress) {
  return Flipping(position, balls, wide, triangles, ball, progress).run();
}

} // namespace vbm::impl
