// SPDX-License-Identifier: GPL-3.0-or-later
// Edelsbrunner, "Deformable smooth surface design" (1999); Kruithof, Vegter, "Meshing skin surfaces
// with certified topology" (2007), whose CGAL package Skin_surface_3 cuts mixed cells into the same
// pieces, between the same points. It differs in that pieces of no size are kept apart by number,
// so that the pieces fill space whatever rounding does, and no exact arithmetic is needed.
//
// Notation: a point of the mixed cell of simplex s is x = (1 - h) a + h b, h the shrink factor, a
// in s, b in its face of the power diagram. With p any ball of s and r its radius before growth,
// the skin there is |x - p|^2 - (1 - h) |a - p|^2 = r^2. Balls in all points a of the regular
// triangulation, of square radius h w(a), fill it; w is the weight that the tetrahedron gives a.
#include "ball_surface/mixed_complex.h"

#include "ball_surface/closest_point.h"
#include "core/progress.h"
#include "core/sort_in_buckets.h"
#include "dual/orthospheres.h"
#include "surface/arrange_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vbm::impl {
namespace {

constexpr int kEdge[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Rounds in which a point is brought onto the skin, and the ratio of a last move to the radius of
/// the ball within the skin that touches it there.
constexpr int kMostRounds = 30;
constexpr double kThere = 1e-7;

double square(const Vec3 &v) { return dot(v, v); }

std::vector<Ball> grown(const std::vector<Ball> &balls, double factor, Progress &progress) {
  std::vector<Ball> larger(balls);
  for (Ball &b : larger) {
    progress.tick(0, 1);
    b.radius *= factor;
  }
  return larger;
}

} // namespace

MixedComplex::MixedComplex(const std::vector<Ball> &balls, double shrink, Progress &progress)
    : shrink_(shrink), root_(std::sqrt(shrink)), balls_(balls.size()) {
  const std::vector<Ball> larger = grown(balls, 1 / root_, progress);
  diagram_ = power_diagram(larger, 0, progress);
  diagram_.cells = arranged(diagram_.cells, balls_, progress);
  hidden_ = diagram_.hidden.size();
  site_.reserve(balls_ + 4);
  for (std::size_t b = 0; b < balls_; ++b)
    site_.push_back(changed_site(larger[b], int32_t(b), false));
  for (const Vec3 &c : diagram_.corner) site_.push_back({c.x, c.y, c.z, 0});
  number_simplices(progress);
  find_foci(progress);
  find_low_points(progress);
  find_high_points(progress);
}

void MixedComplex::number_simplices(Progress &progress) {
  of_cell_.resize(cell_count());
  simplex_.resize(site_.size());
  for (std::size_t b = 0; b < site_.size(); ++b) {
    progress.tick(0, 1);
    simplex_[b] = {{int32_t(b), -1, -1, -1}};
  }
  struct Use {
    std::array<int32_t, 3> ball; // ascending; an edge's last is -1
    uint32_t cell;
    int32_t place;
  };
  const auto number = [&](int first, int count, auto balls_of) {
    std::vector<Use> uses;
    uses.reserve(cell_count() * std::size_t(count));
    for (std::size_t c = 0; c < cell_count(); ++c) {
      progress.tick(0, 1);
      for (int i = 0; i < count; ++i)
        uses.push_back({balls_of(diagram_.cells[c].ball, i), uint32_t(c), first + i});
    }
    const std::unique_ptr<Use[]> sorted = sorted_in_buckets(
        uses, site_.size(), [](const Use &u) { return u.ball[0]; },
        [](const Use &a, const Use &b) {
          return a.ball != b.ball   ? a.ball < b.ball
                 : a.cell != b.cell ? a.cell < b.cell
                                    : a.place < b.place;
        },
        progress);
    for (std::size_t i = 0; i < uses.size(); ++i) {
      progress.tick(0, 1);
      if (i == 0 || sorted[i].ball != sorted[i - 1].ball)
        simplex_.push_back({{sorted[i].ball[0], sorted[i].ball[1], sorted[i].ball[2], -1}});
      of_cell_[sorted[i].cell][sorted[i].place] = int32_t(simplex_.size()) - 1;
    }
  };
  edges_ = int32_t(simplex_.size());
  number(0, 6, [](const std::array<int32_t, 4> &b, int i) {
    const auto [low, high] = std::minmax(b[kEdge[i][0]], b[kEdge[i][1]]);
    return std::array<int32_t, 3>{low, high, -1};
  });
  triangles_ = int32_t(simplex_.size());
  number(6, 4, [](const std::array<int32_t, 4> &b, int i) {
    std::array<int32_t, 3> t{b[kFacet[i][0]], b[kFacet[i][1]], b[kFacet[i][2]]};
    std::sort(t.begin(), t.end());
    return t;
  });
  cells_ = int32_t(simplex_.size());
  for (const PowerDiagram::Cell &c : diagram_.cells) simplex_.push_back({c.ball});
}

MixedComplex::Cell MixedComplex::cell(std::size_t c) const {
  Cell out{};
  const std::array<int32_t, 4> &ball = diagram_.cells[c].ball;
  for (int i = 0; i < 4; ++i) out.simplex[1 << i] = ball[i];
  for (int i = 0; i < 6; ++i) out.simplex[(1 << kEdge[i][0]) | (1 << kEdge[i][1])] = of_cell_[c][i];
  for (int i = 0; i < 4; ++i) out.simplex[15 ^ (1 << i)] = of_cell_[c][6 + i];
  out.simplex[15] = cells_ + int32_t(c);
  return out;
}

void MixedComplex::find_foci(Progress &progress) {
  focus_.resize(simplex_.size());
  for (std::size_t s = 0; s < simplex_.size(); ++s) {
    progress.tick(s, simplex_.size());
    const auto &b = simplex_[s].ball;
    const Site &p = site_[b[0]];
    const int d = dimension(int32_t(s));
    const Vec3 from = d == 0   ? Vec3{}
                      : d == 1 ? edge_center(p, site_[b[1]])
                      : d == 2 ? triangle_center(p, site_[b[1]], site_[b[2]])
                               : tetrahedron_center(p, site_[b[1]], site_[b[2]], site_[b[3]]);
    focus_[s] = center_of(p) + from;
    if (is_finite(focus_[s])) continue;
    // Flat to the last digit: any point keeps the pieces in order.
    focus_[s] = {};
    for (int i = 0; i <= d; ++i) focus_[s] += center(b[i]) * (1.0 / (d + 1));
  }
}

void MixedComplex::find_low_points(Progress &progress) {
  low_ = focus_;
  // Of the faces that the focus is beyond, the point that is nearest to it.
  const auto nearest = [&](int32_t s, double &best, int32_t face) {
    const double d = square(low_[face] - focus_[s]);
    if (!(d < best)) return;
    best = d;
    low_[s] = low_[face];
  };
  for (int32_t e = edges_; e < triangles_; ++e) {
    progress.tick(0, 1);
    const Vec3 a = center(simplex_[e].ball[0]), b = center(simplex_[e].ball[1]);
    if (dot(focus_[e] - a, b - a) < 0) low_[e] = a;
    if (dot(focus_[e] - b, a - b) < 0) low_[e] = b;
  }
  std::vector<uint8_t> done(std::size_t(cells_ - triangles_), 0);
  for (std::size_t c = 0; c < cell_count(); ++c) {
    progress.tick(0, 1);
    const Cell cell = this->cell(c);
    for (int i = 0; i < 4; ++i) {
      const int32_t t = cell.simplex[15 ^ (1 << i)];
      if (done[t - triangles_]) continue;
      done[t - triangles_] = 1;
      double best = kInfinity;
      for (int k : kFacet[i]) { // the edge opposite ball k
        const int32_t e = cell.simplex[15 ^ (1 << i) ^ (1 << k)];
        const Vec3 u = center(simplex_[e].ball[0]);
        const Vec3 along = unit(center(simplex_[e].ball[1]) - u);
        const Vec3 to_ball = center(cell.simplex[1 << k]) - u, to_focus = focus_[t] - u;
        if (dot(to_ball - along * dot(to_ball, along), to_focus) < 0) nearest(t, best, e);
      }
    }
    const int32_t whole = cell.simplex[15];
    double best = kInfinity;
    for (int i = 0; i < 4; ++i) {
      const int(&f)[3] = kFacet[i];
      const Vec3 u = center(cell.simplex[1 << f[0]]);
      const Vec3 outward =
          cross(center(cell.simplex[1 << f[1]]) - u, center(cell.simplex[1 << f[2]]) - u);
      if (dot(outward, focus_[whole] - u) > 0) nearest(whole, best, cell.simplex[15 ^ (1 << i)]);
    }
  }
}

double MixedComplex::power(int32_t ball, const Vec3 &x) const {
  const double d = distance(x, center(ball)), r = site_[ball].r;
  return (d - r) * (d + r);
}

void MixedComplex::find_high_points(Progress &progress) {
  high_ = focus_;
  std::vector<double> best(simplex_.size(), kInfinity);
  const auto nearest = [&](int32_t s, int32_t coface) {
    const double d = square(high_[coface] - focus_[s]);
    if (!(d < best[s])) return;
    best[s] = d;
    high_[s] = high_[coface];
  };
  // Triangles: the segment between the centres of the tetrahedra beside them.
  std::vector<int32_t> first(std::size_t(cells_ - triangles_), -1);
  for (std::size_t c = 0; c < cell_count(); ++c) {
    progress.tick(0, 1);
    for (int i = 0; i < 4; ++i) {
      const int32_t t = of_cell_[c][6 + i], whole = cells_ + int32_t(c);
      int32_t &other = first[t - triangles_];
      if (other < 0) {
        other = whole;
        continue;
      }
      if (dot(focus_[other] - focus_[t], focus_[whole] - focus_[t]) > 0) {
        nearest(t, other);
        nearest(t, whole);
      }
    }
  }
  // Edges: the polygon of the triangles about them, where one's third ball is nearer to the focus.
  std::vector<int32_t> edges_of(3 * std::size_t(cells_ - triangles_));
  std::vector<uint8_t> done(std::size_t(cells_ - triangles_), 0);
  for (std::size_t c = 0; c < cell_count(); ++c) {
    progress.tick(0, 1);
    const Cell cell = this->cell(c);
    for (int i = 0; i < 4; ++i) {
      const int32_t t = cell.simplex[15 ^ (1 << i)];
      if (done[t - triangles_]) continue;
      done[t - triangles_] = 1;
      for (int k : kFacet[i]) {
        const int32_t e = cell.simplex[15 ^ (1 << i) ^ (1 << k)];
        if (power(cell.simplex[1 << k], focus_[e]) < power(simplex_[e].ball[0], focus_[e]))
          nearest(e, t);
      }
    }
  }
  // Balls: the cell of the edges at them.
  for (int32_t e = edges_; e < triangles_; ++e) {
    progress.tick(0, 1);
    for (int i = 0; i < 2; ++i) {
      const int32_t v = simplex_[e].ball[i], q = simplex_[e].ball[1 - i];
      if (power(q, focus_[v]) < power(v, focus_[v])) nearest(v, e);
    }
  }
}

double MixedComplex::form(int32_t ball, const Vec3 &x, const Vec3 &a) const {
  const double r = radius(ball);
  const Vec3 p = center(ball);
  return square(x - p) - (1 - shrink_) * square(a - p) - r * r;
}

double MixedComplex::value(const Corner &corner) const {
  const Vec3 &a = low_[corner.low], &b = high_[corner.high];
  return form(simplex_[corner.low].ball[0], a * (1 - shrink_) + b * shrink_, a);
}

Vec3 MixedComplex::crossing(const Corner &p, const Corner &q, Vec3 &normal) const {
  // A ball of both: the form is a polynomial of degree 2 along the segment.
  const int32_t ball = simplex_[dimension(p.low) <= dimension(q.low) ? p.low : q.low].ball[0];
  const Vec3 c = center(ball);
  const auto at = [&](const Corner &v, Vec3 &a, Vec3 &x) {
    a = low_[v.low] - c;
    x = a * (1 - shrink_) + (high_[v.high] - c) * shrink_;
  };
  Vec3 a0, x0, a1, x1;
  at(p, a0, x0);
  at(q, a1, x1);
  const Vec3 da = a1 - a0, dx = x1 - x0;
  const double r = radius(ball), h = 1 - shrink_;
  const double c0 = square(x0) - h * square(a0) - r * r;
  const double c1 = dot(x0, dx) - h * dot(a0, da); // halved
  const double c2 = square(dx) - h * square(da);
  // c0 < 0 and c0 + 2 c1 + c2 >= 0: one root in (0, 1], without cancellation.
  const double root = std::sqrt(std::max(0.0, c1 * c1 - c0 * c2));
  double t = c1 > 0 ? -c0 / (c1 + root) : (root - c1) / c2;
  if (!(t >= 0 && t <= 1)) t = t > 1 ? 1 : 0; // not a number: both ends are one point
  const Vec3 x = x0 + dx * t;
  normal = unit(x - (a0 + da * t)); // from the centre of the ball within the skin that touches it
  return c + x;
}

MixedComplex::Inner MixedComplex::inner(int32_t cell, const Vec3 &x) const {
  const std::array<int32_t, 4> &ball = diagram_.cells[cell].ball;
  const Vec3 corner[4] = {center(ball[0]), center(ball[1]), center(ball[2]), center(ball[3])};
  const Vec3 &f = focus_[cells_ + cell];
  // |x - a|^2 - h w(a) is least at a = f + (x - f) / (1 - h), and grows evenly round it.
  const Vec3 a = closest_on_tetrahedron(f + (x - f) * (1 / (1 - shrink_)), corner);
  // w(a), which is |a - f|^2 up to a constant, relative to a ball: of far foci less is lost.
  const Vec3 from = a - corner[0];
  const double r = site_[ball[0]].r;
  const double weight = r * r + square(from) - 2 * dot(from, f - corner[0]);
  return {a, shrink_ * weight, square(x - a) - shrink_ * weight};
}

bool MixedComplex::project(int32_t cell, double reach, Vec3 &x, Vec3 &normal) const {
  Vec3 to = x;
  for (int round = 0; round < kMostRounds; ++round) {
    // Of this tetrahedron and those beside it, as x may have left it.
    Inner best = inner(cell, to);
    for (int32_t code : diagram_.cells[cell].neighbor) {
      if (code < 0) continue;
      const Inner other = inner(code >> 2, to);
      if (other.value < best.value) best = other;
    }
    const Vec3 out = to - best.center;
    const double size = length(out);
    if (!(best.square > 0) || !(size > 0)) return false;
    const Vec3 next = best.center + out * (std::sqrt(best.square) / size);
    if (!(distance(next, x) <= reach)) return false;
    const bool there = distance(next, to) <= kThere * size;
    to = next;
    normal = out * (1 / size);
    if (there) break;
  }
  x = to;
  return true;
}

} // namespace vbm::impl
