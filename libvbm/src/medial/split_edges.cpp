// SPDX-License-Identifier: GPL-3.0-or-later
// Rivara, "Algorithms for refining triangular grids" (1984): triangles are halved across their
// longest edge. It differs in the order, which is that of the squared distances of the points that
// lie nearest to a primitive, and in that a curve's edges are primitives too.
#include "medial/split_edges.h"

#include "core/progress.h"
#include "medial/envelope.h"

#include <algorithm>
#include <queue>

namespace vbm::impl {
namespace {

/// What the square of a primitive's longest edge counts beside squared distances, in shares of
/// their sum: where all points are met, long edges are split first.
constexpr double kLong = 1e-2;

class Splitting {
public:
  Splitting(BallComplex &complex, const std::vector<Ball> &points, Progress &progress)
      : complex_(complex), progress_(progress), triangles_(complex.ball.size()) {
    for (std::size_t t = 0; t < complex.triangle.size(); ++t)
      for (int32_t v : complex.triangle[t]) triangles_[v].push_back(int32_t(t));
    find_scores(points);
  }

  void run(std::size_t count) {
    const std::size_t first = complex_.ball.size();
    while (complex_.ball.size() < count && !queue_.empty()) {
      progress_.tick(complex_.ball.size() - first, count - first);
      const Candidate c = queue_.top();
      queue_.pop();
      if (c.version != version_[c.primitive]) continue;
      if (is_triangle(c.primitive))
        halve_triangle(c.primitive);
      else
        halve_curve(c.primitive);
    }
  }

private:
  // Primitives are numbered as they come: numbers of triangles are >= 0, those of curves' edges ~.
  struct Candidate {
    double score;
    uint32_t primitive, version;
    bool operator<(const Candidate &o) const {
      return score != o.score ? score < o.score : primitive > o.primitive;
    }
  };

  bool is_triangle(uint32_t p) const { return place_[p] >= 0; }
  double length2(int32_t a, int32_t b) const {
    const Vec3 e = complex_.ball[a].center - complex_.ball[b].center;
    return dot(e, e);
  }

  void find_scores(const std::vector<Ball> &points) {
    const Envelope envelope(complex_, progress_);
    const std::size_t triangles = complex_.triangle.size();
    score_.assign(triangles + complex_.edge.size(), 0);
    double distances = 0, lengths = 0;
    for (const Ball &point : points) {
      progress_.tick(0, 1);
      const EnvelopeHit hit = envelope.nearest(point.center);
      const double d2 = hit.distance * hit.distance;
      if (std::size_t(hit.primitive) < score_.size()) score_[hit.primitive] += d2;
      distances += d2;
    }
    for (std::size_t p = 0; p < score_.size(); ++p) {
      place_.push_back(p < triangles ? int32_t(p) : ~int32_t(p - triangles));
      lengths += longest2(uint32_t(p));
    }
    for (std::size_t t = 0; t < triangles; ++t) number_.push_back(uint32_t(t));
    const double share = lengths > 0 ? kLong * std::max(distances, 1e-300) / lengths : 0;
    version_.assign(score_.size(), 0);
    for (std::size_t p = 0; p < score_.size(); ++p) {
      score_[p] += share * longest2(uint32_t(p));
      queue_.push({score_[p], uint32_t(p), 0});
    }
  }

  double longest2(uint32_t p) const {
    if (!is_triangle(p)) {
      const auto &e = complex_.edge[~place_[p]];
      return length2(e[0], e[1]);
    }
    const auto &t = complex_.triangle[place_[p]];
    return std::max({length2(t[0], t[1]), length2(t[1], t[2]), length2(t[2], t[0])});
  }

  int32_t middle(int32_t a, int32_t b) {
    const Ball &x = complex_.ball[a], &y = complex_.ball[b];
    complex_.ball.push_back({(x.center + y.center) * 0.5, (x.radius + y.radius) * 0.5});
    triangles_.emplace_back();
    return int32_t(complex_.ball.size()) - 1;
  }

  /// A primitive is half of what it was, and so is the new one at `place`.
  void push_halves(uint32_t p, int32_t place) {
    score_[p] *= 0.5;
    queue_.push({score_[p], p, ++version_[p]});
    const uint32_t fresh = uint32_t(score_.size());
    score_.push_back(score_[p]);
    version_.push_back(0);
    place_.push_back(place);
    if (place >= 0) number_.push_back(fresh);
    queue_.push({score_[p], fresh, 0});
  }

  void halve_curve(uint32_t p) {
    const int32_t e = ~place_[p];
    const int32_t b = complex_.edge[e][1], m = middle(complex_.edge[e][0], b);
    complex_.edge[e][1] = m;
    complex_.edge.push_back({m, b});
    push_halves(p, ~int32_t(complex_.edge.size() - 1));
  }

  void halve_triangle(uint32_t p) {
    const auto corner = complex_.triangle[place_[p]];
    int32_t a = corner[2], b = corner[0];
    for (int i = 0; i < 2; ++i)
      if (length2(corner[i], corner[i + 1]) > length2(a, b)) a = corner[i], b = corner[i + 1];
    const int32_t m = middle(a, b);
    const std::vector<int32_t> at_b = triangles_[b];
    for (int32_t t : at_b) {
      std::array<int32_t, 3> &old = complex_.triangle[t];
      if (std::find(old.begin(), old.end(), a) == old.end()) continue;
      std::array<int32_t, 3> fresh = old;
      std::replace(old.begin(), old.end(), b, m);
      std::replace(fresh.begin(), fresh.end(), a, m);
      const int32_t number = int32_t(complex_.triangle.size());
      complex_.triangle.push_back(fresh);
      *std::find(triangles_[b].begin(), triangles_[b].end(), t) = number;
      for (int32_t v : fresh)
        if (v != b) triangles_[v].push_back(number);
      triangles_[m].push_back(t);
      push_halves(number_[t], number);
    }
  }

  BallComplex &complex_;
  Progress &progress_;
  std::vector<std::vector<int32_t>> triangles_; // per ball
  std::vector<double> score_;                   // per primitive
  std::vector<uint32_t> version_;
  std::vector<int32_t> place_;   // per primitive: its triangle, or ~ its curve's edge
  std::vector<uint32_t> number_; // per triangle: its primitive
  std::priority_queue<Candidate> queue_;
};

} // namespace

void split_edges(BallComplex &complex, const std::vector<Ball> &points, std::size_t count,
                 Progress &progress) {
  if (complex.ball.size() >= count) return;
  Splitting(complex, points, progress).run(count);
}

} // namespace vbm::impl
