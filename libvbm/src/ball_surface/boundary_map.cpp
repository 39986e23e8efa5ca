// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 8.3.3 and 8.3.4: singular points of the dual shape's regular and singular triangles, and
// the walk round every vertex of its hull that connects them.
//
// Where the thesis compares directions (Figure 8.5), this turns about an edge through tetrahedra
// that are not in the shape: the right neighbour of a triangle is the next triangle met, and the
// right singular point of either is the one on the side of these tetrahedra. Nothing is measured,
// so no rounding can lead the walk through the hull.
//
// 8.3.5: three balls of a triangle of the dual shape always meet. They do not where the shape is
// that of larger balls (bridged); the singular point is then the orthocentre moved by the mean
// radius.
#include "ball_surface/boundary_map.h"

#include "ball_surface/angle_sum.h"
#include "core/progress.h"
#include "core/tolerances.h"
#include "core/workers.h"
#include "dual/orthospheres.h"
#include "dual/wedges.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Radians. Nearer to none or a full turn than this, an angle between two triangles is found by
/// adding up those of the tetrahedra between, which cannot mistake one for the other.
constexpr double kCertainAngle = 1e-3;

/// Share of the square of a circle's radius: nearer to it than that an arc's end is on it.
constexpr double kOnCircle = 1e-7;

/// Share of the radius: a singular point's blur is at most that.
constexpr double kMostBlur = 1e-3;

/// Shares of a union's area: with less of wide balls than the first they are few, with more than
/// the second many.
constexpr double kFewWide = 0.3, kManyWide = 0.5;

/// Edges from which on two threads are worth it.
constexpr std::size_t kManyEdges = 4000;

class Search {
public:
  Search(const DualShape &shape, const std::vector<Ball> &balls, bool bridged, Progress &progress)
      : shape_(shape), bridged_(bridged), progress_(progress),
        parts_(shape.edges.size() < kManyEdges ? 1 : 2) {
    if (!bridged) return;
    for (std::size_t b = 0; b < balls.size(); ++b)
      true_site_.push_back(changed_site(balls[b], int32_t(b), false));
  }

  BoundaryMap run() {
    make_points();
    make_spans();
    find_patches(out_, shape_, progress_);
    find_fineness();
    return std::move(out_);
  }

private:
  using Span = BoundaryMap::Span;

  const Site &true_site(int32_t ball) const {
    return bridged_ ? true_site_[ball] : shape_.site[ball];
  }

  /// Of the triangles and of the edges, one thread's work: what it adds up by ball.
  struct alignas(kApart) Part {
    std::vector<AngleSum> corners; // of each ball's patches
    std::vector<double> bare;
    std::size_t first_point = 0, first_span = 0, offset_points = 0;
  };

  /// Part n of a list.
  std::size_t begin_of(std::size_t n, std::size_t count) const { return count * n / parts_.size(); }

  void in_parts(void (Search::*find)(std::size_t, Progress &)) {
    run_parts(int(parts_.size()), progress_,
              [&](int n, Progress &progress) { (this->*find)(std::size_t(n), progress); });
  }

  // ---- Singular points

  void make_points() {
    const std::size_t count = shape_.triangles.size(), balls = shape_.vertex.size();
    std::size_t points = 0;
    for (std::size_t n = 0; n < parts_.size(); ++n) {
      parts_[n].first_point = points;
      for (std::size_t t = begin_of(n, count); t < begin_of(n + 1, count); ++t) {
        progress_.tick(0, 1);
        points += std::size_t(shape_.triangles[t].open[0] + shape_.triangles[t].open[1]);
      }
    }
    point_.assign(2 * count, -1);
    out_.position.resize(points);
    out_.blur.resize(points);
    out_.code.resize(points);
    out_.bare.assign(balls, 0);
    in_parts(&Search::find_points);
    for (const Part &p : parts_) out_.offset_points += p.offset_points;
    start_.assign(3 * points, -1);
    end_.assign(3 * points, -1);
  }

  void find_points(std::size_t n, Progress &progress) {
    const std::size_t count = shape_.triangles.size();
    Part &part = parts_[n];
    part.corners.resize(shape_.vertex.size());
    std::size_t point = part.first_point;
    for (std::size_t t = begin_of(n, count); t < begin_of(n + 1, count); ++t) {
      progress.tick(t, 4 * count);
      const DualShape::Triangle &triangle = shape_.triangles[t];
      if (!triangle.open[0] && !triangle.open[1]) continue;
      const auto &b = triangle.ball;
      add_points(t, triangle_center(true_site(b[0]), true_site(b[1]), true_site(b[2])), part,
                 point);
    }
  }

  static double chord_of(const Site &s, const Vec3 &y) {
    const double h = length(y);
    return std::sqrt(std::max(0.0, (s.r - h) * (s.r + h)));
  }

  /// On the open sides of a triangle, number `point` and on.
  void add_points(std::size_t t, const Vec3 &y, Part &part, std::size_t &point) {
    const auto &b = shape_.triangles[t].ball;
    const Site &p = true_site(b[0]), &q = true_site(b[1]), &r = true_site(b[2]);
    const Vec3 e = center_of(q) - center_of(p), f = center_of(r) - center_of(p), w = cross(e, f);
    const double area = length(w);
    double chord = chord_of(p, y);
    const bool offset = bridged_ && !(chord > 0);
    if (offset) chord = (p.r + q.r + r.r) / 3;
    // What the radii were changed by moves the planes between the balls: by kTouch of the radii
    // where these differ, by kPowerChange of their squares in any case.
    const double le = length(e), lf = length(f), lift = 2 * kPowerChange * p.r * p.r;
    const double flat =
        ((lift + 2 * kTouch * p.r * le) * lf + (lift + 2 * kTouch * p.r * lf) * le) / (2 * area);
    const double blur = flat * (1 + length(y) / chord) + 2 * kTouch * p.r * p.r / chord;
    const Vec3 up = area > 0 ? w * (chord / area) : Vec3{};
    for (int side = 0; side < 2; ++side) {
      if (!shape_.triangles[t].open[side]) continue;
      const Vec3 at = side ? y + up : y - up; // from p's centre
      add_corner(part.corners[b[0]], at, e, f, w);
      add_corner(part.corners[b[1]], at - e, f - e, -e, w);
      add_corner(part.corners[b[2]], at - f, -f, e - f, w);
      part.offset_points += offset;
      point_[2 * t + std::size_t(side)] = int32_t(point);
      out_.code[point] = int32_t(2 * t) + side;
      out_.position[point] = center_of(p) + at;
      out_.blur[point] = blur < kMostBlur * p.r ? blur : kMostBlur * p.r;
      ++point;
    }
  }

  /// What a corner of a ball's patch takes from its solid angle: see patch_area.h. `q` and `r` are
  /// the other balls' centres from the ball's own, `w` the vector product of any two sides.
  static void add_corner(AngleSum &sum, const Vec3 &at, const Vec3 &q, const Vec3 &r,
                         const Vec3 &w) {
    const double square = dot(at, at);
    sum.add(dot(q, r) * square - dot(at, q) * dot(at, r),
            std::fabs(dot(at, w)) * std::sqrt(square));
  }

  // ---- Arcs

  void make_spans() {
    const std::size_t count = shape_.edges.size();
    std::size_t spans = 0;
    for (std::size_t n = 0; n < parts_.size(); ++n) {
      parts_[n].first_span = spans;
      for (std::size_t e = begin_of(n, count); e < begin_of(n + 1, count); ++e) {
        progress_.tick(1, 4);
        const DualShape::Edge &edge = shape_.edges[e];
        spans += edge.begin == edge.end; // a whole circle
        for (uint32_t t = edge.begin; t < edge.end; ++t) spans += shape_.turns[t].outside();
      }
    }
    out_.spans.resize(spans);
    out_.from.resize(2 * spans);
    out_.next.resize(2 * spans);
    in_parts(&Search::find_spans);
    for (std::size_t b = 0; b < out_.bare.size(); ++b) {
      progress_.tick(2, 4);
      AngleSum corners;
      for (const Part &p : parts_) {
        out_.bare[b] += p.bare[b];
        corners.add(p.corners[b]);
      }
      out_.bare[b] -= corners.sum();
    }
    in_parts(&Search::link_sides);
  }

  void find_spans(std::size_t n, Progress &progress) {
    const std::size_t count = shape_.edges.size();
    Part &part = parts_[n];
    part.bare.assign(out_.bare.size(), 0);
    std::size_t span = part.first_span;
    for (std::size_t e = begin_of(n, count); e < begin_of(n + 1, count); ++e) {
      progress.tick(count + e, 4 * count);
      const DualShape::Edge &edge = shape_.edges[e];
      bool any = edge.begin == edge.end; // a whole circle
      for (uint32_t t = edge.begin; t < edge.end; ++t) any |= shape_.turns[t].outside();
      if (!any) continue;
      const Axis3 axis(shape_.site[edge.a], shape_.site[edge.b]);
      if (edge.begin == edge.end) add_circle(uint32_t(e), axis, part, span++);
      for (uint32_t t = edge.begin; t < edge.end; ++t)
        if (shape_.turns[t].outside()) add_arc(uint32_t(e), axis, t, part, span++);
    }
  }

  void link_sides(std::size_t n, Progress &progress) {
    const std::size_t count = start_.size();
    for (std::size_t c = begin_of(n, count); c < begin_of(n + 1, count); ++c) {
      progress.tick(1, 1);
      out_.next[end_[c]] = start_[c];
    }
  }

  void add_circle(uint32_t e, const Axis3 &axis, Part &part, std::size_t number) {
    add_span({e, shape_.edges[e].end, 0, 2 * kPi, false}, axis, -1, -1, part, number);
    out_.next[2 * number] = int32_t(2 * number);
    out_.next[2 * number + 1] = int32_t(2 * number + 1);
  }

  void add_arc(uint32_t e, const Axis3 &axis, uint32_t turn, Part &part, std::size_t number) {
    const DualShape::Edge &edge = shape_.edges[e];
    const uint32_t next = next_turn(edge, turn);
    // From the triangle's singular point on the side of the wedge to the next one's; that side of
    // the next is the other one than the one its own wedge is on.
    const DualShape::Turn t = shape_.turns[turn], u = shape_.turns[next];
    const int32_t first = point_[2 * t.triangle() + t.side()],
                  last = point_[2 * u.triangle() + 1 - u.side()];
    Span span{e, turn, 0, 0, true};
    if (!find_by_ends(span, axis, first, last)) find_by_halves(span, axis);
    add_span(span, axis, first, last, part, number);
    const int32_t side = int32_t(2 * number);
    start_[corner(t.triangle(), first, edge.b)] = side + 1;
    end_[corner(u.triangle(), last, edge.b)] = side + 1;
    start_[corner(u.triangle(), last, edge.a)] = side;
    end_[corner(t.triangle(), first, edge.a)] = side;
  }

  void add_span(const Span &span, const Axis3 &axis, int32_t first, int32_t last, Part &part,
                std::size_t number) {
    const DualShape::Edge &edge = shape_.edges[span.edge];
    part.bare[edge.a] += axis.height_a / shape_.site[edge.a].r * span.angle;
    part.bare[edge.b] += axis.height_b / shape_.site[edge.b].r * span.angle;
    out_.spans[number] = span;
    out_.from[2 * number] = last;
    out_.from[2 * number + 1] = first;
  }

  std::size_t corner(int32_t triangle, int32_t point, int32_t ball) const {
    const auto &b = shape_.triangles[triangle].ball;
    return 3 * std::size_t(point) + (b[1] == ball) + 2 * (b[2] == ball);
  }

  /// The angle from one end to the other. False if it might be none as well as a full turn, or the
  /// ends are not known to be on the circle.
  bool find_by_ends(Span &span, const Axis3 &axis, int32_t first, int32_t last) const {
    if (bridged_) return false;
    const DualShape::Edge &edge = shape_.edges[span.edge];
    const Vec3 from = out_.position[first] - axis.center, to = out_.position[last] - axis.center;
    const double square = axis.radius * axis.radius, most = kOnCircle * square;
    if (!(std::fabs(dot(from, from) - square) < most && std::fabs(dot(to, to) - square) < most))
      return false;
    double angle = std::atan2(dot(axis.direction, cross(from, to)), dot(from, to));
    if (std::fabs(angle) < kCertainAngle) {
      // Between balls less than a half turn apart there is none of more than that.
      const Vec3 a = shape_.position(edge.a);
      const Vec3 p = shape_.position(shape_.ball_of(edge, span.turn)) - a,
                 q = shape_.position(shape_.ball_of(edge, next_turn(edge, span.turn))) - a;
      if (!(dot(axis.direction, cross(p, q)) > kCertainAngle * length(p) * length(q))) return false;
      angle = std::max(angle, 0.0);
    }
    span.angle = angle < 0 ? angle + 2 * kPi : angle;
    return true;
  }

  /// The angle between the balls of its turns, without what is inside them.
  void find_by_halves(Span &span, const Axis3 &axis) const {
    const DualShape::Edge &edge = shape_.edges[span.edge];
    const uint32_t turn = span.turn, next = next_turn(edge, turn);
    const Vec3 from = turn_direction(shape_, edge, axis, turn),
               to = turn_direction(shape_, edge, axis, next);
    double wedge =
        turn == next ? 2 * kPi : std::atan2(dot(axis.direction, cross(from, to)), dot(from, to));
    if (turn != next && std::fabs(wedge) < kCertainAngle)
      wedge = outside_angle(shape_, edge, axis, turn);
    else if (wedge < 0)
      wedge += 2 * kPi;
    span.by_end = false;
    span.begin = half_angle(axis, turn, from);
    span.angle = std::max(0.0, wedge - span.begin - half_angle(axis, next, to));
  }

  /// Half the angle of the circle that is inside the turn's ball.
  double half_angle(const Axis3 &axis, uint32_t turn, const Vec3 &direction) const {
    const auto &b = shape_.triangles[shape_.turns[turn].triangle()].ball;
    const Site &p = shape_.site[b[0]];
    const Vec3 y = triangle_center(p, shape_.site[b[1]], shape_.site[b[2]]);
    return std::atan2(chord_of(p, y), dot(center_of(p) + y - axis.center, direction));
  }

  /// Where most of a union is of wide balls, its volume is theirs, and they are made five times as
  /// fine at the default bulge and above (hardly finer at small ones); where few are, they are
  /// details of something else.
  void find_fineness() {
    double wide = 0, all = 0;
    for (std::size_t b = 0; b < out_.bare.size(); ++b) {
      const double r = shape_.site[b].r, area = std::max(0.0, out_.bare[b]) * r * r;
      all += area;
      if (out_.wide(int32_t(b))) wide += area;
    }
    const double share = all > 0 ? wide / all : 0;
    out_.finer =
        BoundaryMap::kMostFiner * std::clamp((share - kFewWide) / (kManyWide - kFewWide), 0.0, 1.0);
  }

  const DualShape &shape_;
  const bool bridged_;
  Progress &progress_;
  std::vector<Site> true_site_;
  BoundaryMap out_;
  std::vector<int32_t> point_;       // by triangle and side
  std::vector<int32_t> start_, end_; // by singular point and ball of its triangle: sides
  std::vector<Part> parts_;
};

} // namespace

BoundaryMap boundary_map(const DualShape &shape, const std::vector<Ball> &balls, bool bridged,
                         Progress &progress) {
  return Search(shape, balls, bridged, progress).run();
}

} // namespace vbm::impl
