// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 8.3.3 and 8.3.4: singular points of the dual shape's regular and singular triangles, and
// the walk round every vertex of its hull that connects them.
//
// Where the thesis compares directions (Figure 8.5), this turns about an edge through tetrahedra
// that are not in the shape: the right neighbour of a triangle is the next triangle met, and the
// right singular point of either is the one on the side of these tetrahedra. Nothing is measured,
// so no rounding can lead the walk through the hull. Where the thesis takes a vertex to have one
// polygon, every component of its sphere outside the other balls is a patch of its own, with as
// many loops of arcs as there are components of the shape round it; those are found by searching
// the tetrahedra outside the shape at the vertex.
//
// 8.3.5: three balls of a triangle of the dual shape always meet. They do not where the shape is
// that of larger balls (bridged); the singular point is then the orthocentre moved by the mean
// radius.
#include "ball_surface/patch_complex.h"

#include "ball_surface/angle_sum.h"
#include "ball_surface/patch_area.h"
#include "core/disjoint_sets.h"
#include "core/progress.h"
#include "core/tolerances.h"
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

/// A circle is cut into at least so many pieces.
constexpr int kLeastPieces = 3;

/// Share of the radius: a singular point's blur is at most that.
constexpr double kMostBlur = 1e-3;

/// Shares of a union's area: with less of wide balls than the first they are few, with more than
/// the second many.
constexpr double kFewWide = 0.3, kManyWide = 0.5;

class Search {
public:
  Search(const DualShape &shape, const std::vector<Ball> &balls, const PatchOptions &options,
         Progress &progress)
      : shape_(shape), options_(options), progress_(progress) {
    if (!options.bridged) return;
    for (std::size_t b = 0; b < balls.size(); ++b)
      true_site_.push_back(changed_site(balls[b], int32_t(b), false));
  }

  PatchComplex run() {
    make_points();
    make_arcs();
    link_darts();
    make_patches();
    find_fineness();
    return std::move(out_);
  }

private:
  using Dart = PatchComplex::Dart;

  const Site &true_site(int32_t ball) const {
    return options_.bridged ? true_site_[ball] : shape_.site[ball];
  }

  // ---- Singular points

  void make_points() {
    const std::size_t count = shape_.triangles.size(), balls = shape_.vertex.size();
    point_.assign(2 * count, -1);
    for (std::size_t t = 0; t < count; ++t)
      for (int side = 0; side < 2; ++side)
        if (shape_.triangles[t].open[side]) {
          point_[2 * t + side] = int32_t(out_.code.size());
          out_.code.push_back(int32_t(2 * t) + side);
        }
    out_.singular_points = out_.code.size();
    out_.position.resize(out_.singular_points);
    out_.blur.resize(out_.singular_points);
    half_angle_chord_.resize(count);
    center_.resize(count);
    corners_.resize(balls);
    out_.bare.assign(balls, 0);
    for (std::size_t t = 0; t < count; ++t) {
      progress_.tick(t, 4 * count);
      const DualShape::Triangle &triangle = shape_.triangles[t];
      if (!triangle.open[0] && !triangle.open[1]) continue;
      const auto &b = triangle.ball;
      const Vec3 y = triangle_center(shape_.site[b[0]], shape_.site[b[1]], shape_.site[b[2]]);
      center_[t] = center_of(shape_.site[b[0]]) + y;
      half_angle_chord_[t] = chord_of(shape_.site[b[0]], y);
      add_points(t, y);
    }
    start_.assign(3 * out_.singular_points, -1);
    end_.assign(3 * out_.singular_points, -1);
  }

  static double chord_of(const Site &s, const Vec3 &y) {
    const double h = length(y);
    return std::sqrt(std::max(0.0, (s.r - h) * (s.r + h)));
  }

  /// On the open sides of a triangle.
  void add_points(std::size_t t, Vec3 y) {
    const auto &b = shape_.triangles[t].ball;
    const Site &p = true_site(b[0]), &q = true_site(b[1]), &r = true_site(b[2]);
    const Vec3 e = center_of(q) - center_of(p), f = center_of(r) - center_of(p), w = cross(e, f);
    const double area = length(w);
    double chord = half_angle_chord_[t];
    bool offset = false;
    if (options_.bridged) {
      y = triangle_center(p, q, r);
      chord = chord_of(p, y);
      offset = !(chord > 0);
      if (offset) chord = (p.r + q.r + r.r) / 3;
    }
    // What the radii were changed by moves the planes between the balls: by kTouch of the radii
    // where these differ, by kPowerChange of their squares in any case.
    const double le = length(e), lf = length(f), lift = 2 * kPowerChange * p.r * p.r;
    const double flat =
        ((lift + 2 * kTouch * p.r * le) * lf + (lift + 2 * kTouch * p.r * lf) * le) / (2 * area);
    const double blur = flat * (1 + length(y) / chord) + 2 * kTouch * p.r * p.r / chord;
    const Vec3 up = area > 0 ? w * (chord / area) : Vec3{};
    for (int side = 0; side < 2; ++side) {
      const int32_t number = point_[2 * t + side];
      if (number < 0) continue;
      const Vec3 at = side ? y + up : y - up; // from p's centre
      add_corner(corners_[b[0]], at, e, f, w);
      add_corner(corners_[b[1]], at - e, f - e, -e, w);
      add_corner(corners_[b[2]], at - f, -f, e - f, w);
      out_.offset_points += offset;
      out_.position[number] = center_of(p) + at;
      out_.blur[number] = blur < kMostBlur * p.r ? blur : kMostBlur * p.r;
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

  /// What is known of an arc before it has a place among the others.
  struct Span {
    uint32_t edge, turn;
    double begin, angle;
    int32_t pieces;
  };

  void make_arcs() {
    const std::size_t count = shape_.edges.size();
    std::vector<Span> spans;
    spans.reserve(out_.singular_points * 3 / 2); // three arcs meet in every singular point
    for (std::size_t e = 0; e < count; ++e) {
      const DualShape::Edge &edge = shape_.edges[e];
      if (edge.begin == edge.end) spans.push_back({uint32_t(e), edge.end, 0, 2 * kPi, 0});
      for (uint32_t t = edge.begin; t < edge.end; ++t)
        if (shape_.turns[t].outside) spans.push_back({uint32_t(e), t, 0, 0, 0});
    }
    out_.circles.resize(spans.size());
    const std::size_t total = 4 * spans.size();
    std::size_t pieces = 0;
    for (std::size_t i = 0; i < spans.size(); ++i) {
      progress_.tick(spans.size() + i, total);
      find_span(spans[i], out_.circles[i]);
      pieces += std::size_t(spans[i].pieces);
    }
    out_.arcs.reserve(2 * pieces); // some will be cut in two
    out_.darts.reserve(3 * pieces);
    for (std::size_t i = 0; i < spans.size(); ++i) {
      progress_.tick(2 * spans.size() + i, total);
      add_span(spans[i], int32_t(i));
    }
    for (std::size_t b = 0; b < out_.bare.size(); ++b) out_.bare[b] -= corners_[b].sum();
  }

  void find_span(Span &span, PatchComplex::Circle &circle) const {
    const DualShape::Edge &edge = shape_.edges[span.edge];
    const Axis3 axis(shape_.site[edge.a], shape_.site[edge.b]);
    circle = {span.edge, span.turn, axis.center, {}, {}, axis.direction, axis.height_a,
              axis.height_b};
    if (edge.begin == edge.end) {
      // Any direction: across the axis's smallest coordinate.
      const Vec3 &d = axis.direction;
      const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
      const Vec3 u = x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
      circle.u = unit(axis.perpendicular(u)) * axis.radius;
      span.pieces = std::max(kLeastPieces, pieces(edge, axis, 2 * kPi));
    } else if (!find_by_ends(span, circle, edge, axis)) {
      find_by_halves(span, circle, edge, axis);
    }
    circle.v = cross(axis.direction, circle.u);
    if (edge.begin != edge.end) span.pieces = pieces(edge, axis, span.angle);
  }

  /// The angle from one end to the other. False if it might be none as well as a full turn, or the
  /// ends are not known to be on the circle.
  bool find_by_ends(Span &span, PatchComplex::Circle &circle, const DualShape::Edge &edge,
                    const Axis3 &axis) const {
    if (options_.bridged) return false;
    const uint32_t next = next_turn(edge, span.turn);
    const Vec3 from = out_.position[first_point(span.turn)] - axis.center,
               to = out_.position[last_point(next)] - axis.center;
    const double square = axis.radius * axis.radius, most = kOnCircle * square;
    if (!(std::fabs(dot(from, from) - square) < most && std::fabs(dot(to, to) - square) < most))
      return false;
    double angle = std::atan2(dot(axis.direction, cross(from, to)), dot(from, to));
    if (std::fabs(angle) < kCertainAngle) {
      // Between balls less than a half turn apart there is none of more than that.
      const Vec3 a = shape_.position(edge.a);
      const Vec3 p = shape_.position(shape_.turns[span.turn].ball) - a,
                 q = shape_.position(shape_.turns[next].ball) - a;
      if (!(dot(axis.direction, cross(p, q)) > kCertainAngle * length(p) * length(q))) return false;
      angle = std::max(angle, 0.0);
    }
    span.angle = angle < 0 ? angle + 2 * kPi : angle;
    circle.u = from;
    return true;
  }

  /// The angle between the balls of its turns, without what is inside them.
  void find_by_halves(Span &span, PatchComplex::Circle &circle, const DualShape::Edge &edge,
                      const Axis3 &axis) const {
    const uint32_t turn = span.turn, next = next_turn(edge, turn);
    const Vec3 from = direction_of(edge, axis, turn), to = direction_of(edge, axis, next);
    double wedge =
        turn == next ? 2 * kPi : std::atan2(dot(axis.direction, cross(from, to)), dot(from, to));
    if (turn != next && std::fabs(wedge) < kCertainAngle)
      wedge = outside_angle(shape_, edge, axis, turn);
    else if (wedge < 0)
      wedge += 2 * kPi;
    span.begin = half_angle(axis, turn, from);
    span.angle = std::max(0.0, wedge - span.begin - half_angle(axis, next, to));
    circle.u = from * axis.radius;
  }

  /// The ends of the arc after a turn, and of the one before it: the triangle's singular point on
  /// the side of the wedge, and the one on its other side.
  int32_t first_point(uint32_t turn) const {
    const DualShape::Turn &t = shape_.turns[turn];
    return point_[2 * t.triangle + t.side];
  }
  int32_t last_point(uint32_t turn) const {
    const DualShape::Turn &t = shape_.turns[turn];
    return point_[2 * t.triangle + 1 - t.side];
  }

  int pieces(const DualShape::Edge &edge, const Axis3 &axis, double angle) const {
    const double r = std::min(shape_.site[edge.a].r, shape_.site[edge.b].r);
    const double sagitta = options_.bulge * r;
    // 1 - cos x is x x / 2 at most.
    if (angle < 2 * kPi / kLeastPieces &&
        (axis.radius * angle * angle <= 8 * sagitta ||
         axis.radius * (1 - std::cos(angle / 2)) <= sagitta))
      return 1;
    const double most =
        std::min(2 * std::acos(std::max(-1.0, 1 - sagitta / axis.radius)), 2 * kPi / kLeastPieces);
    return std::max(1, int(std::ceil(angle / most - 1e-9)));
  }

  Vec3 direction_of(const DualShape::Edge &edge, const Axis3 &axis, uint32_t turn) const {
    return unit(
        axis.perpendicular(shape_.position(shape_.turns[turn].ball) - shape_.position(edge.a)));
  }

  /// Half the angle of the circle that is inside the turn's ball.
  double half_angle(const Axis3 &axis, uint32_t turn, const Vec3 &direction) const {
    const int32_t t = shape_.turns[turn].triangle;
    return std::atan2(half_angle_chord_[t], dot(center_[t] - axis.center, direction));
  }

  void add_span(const Span &span, int32_t circle) {
    const DualShape::Edge &edge = shape_.edges[span.edge];
    const PatchComplex::Circle &c = out_.circles[circle];
    out_.bare[edge.a] += c.height_a / shape_.site[edge.a].r * span.angle;
    out_.bare[edge.b] += c.height_b / shape_.site[edge.b].r * span.angle;
    const int32_t dart = int32_t(out_.darts.size());
    if (edge.begin == edge.end) {
      const int32_t first = add_vertex(PatchComplex::point(c, 0));
      add_pieces(span, circle, first, first);
      const int32_t last = int32_t(out_.darts.size()) - 2;
      set_next(last + 1, dart + 1);
      set_next(dart, last);
      return;
    }
    const uint32_t next = next_turn(edge, span.turn);
    const int32_t first = first_point(span.turn), last = last_point(next);
    add_pieces(span, circle, first, last);
    const int32_t final_dart = int32_t(out_.darts.size()) - 2;
    const int32_t t = shape_.turns[span.turn].triangle, u = shape_.turns[next].triangle;
    // Ball b's darts run along the arc, a's against it.
    start_[corner(t, first, edge.b)] = dart + 1;
    end_[corner(u, last, edge.b)] = final_dart + 1;
    start_[corner(u, last, edge.a)] = final_dart;
    end_[corner(t, first, edge.a)] = dart;
  }

  std::size_t corner(int32_t triangle, int32_t point, int32_t ball) const {
    const auto &b = shape_.triangles[triangle].ball;
    return 3 * std::size_t(point) + (b[1] == ball) + 2 * (b[2] == ball);
  }

  int32_t add_vertex(const Vec3 &p) {
    out_.position.push_back(p);
    out_.blur.push_back(0);
    return int32_t(out_.position.size()) - 1;
  }

  void add_pieces(const Span &span, int32_t number, int32_t first, int32_t last) {
    const PatchComplex::Circle &circle = out_.circles[number];
    const double begin = span.begin, angle = span.angle;
    int32_t at = first;
    for (int32_t k = 0; k < span.pieces; ++k) {
      const double from = begin + angle * k / span.pieces,
                   to = begin + angle * (k + 1) / span.pieces;
      const int32_t arc = int32_t(out_.arcs.size()), dart = int32_t(out_.darts.size());
      const int32_t there =
          k + 1 == span.pieces ? last : add_vertex(PatchComplex::point(circle, to));
      out_.arcs.push_back({number, from, to, out_.position[at], out_.position[there]});
      out_.darts.push_back({there, -1, -1, dart + 1, -1, arc, false});
      out_.darts.push_back({at, -1, -1, dart, -1, arc, true});
      if (k > 0) {
        set_next(dart - 1, dart + 1);
        set_next(dart, dart - 2);
      }
      at = there;
    }
  }

  void set_next(int32_t dart, int32_t next) {
    out_.darts[dart].next = next;
    out_.darts[next].previous = dart;
  }

  void link_darts() {
    for (std::size_t c = 0; c < start_.size(); ++c) set_next(end_[c], start_[c]);
  }

  // ---- Patches

  int32_t ball_of(const Dart &d) const {
    const DualShape::Edge &edge = shape_.edges[out_.circle(d).edge];
    return d.forward ? edge.b : edge.a;
  }

  void make_patches() {
    std::vector<int32_t> loops(shape_.vertex.size(), 0);
    for (std::size_t d = 0; d < out_.darts.size(); ++d) {
      progress_.tick(3 * out_.darts.size() + d, 4 * out_.darts.size());
      if (out_.darts[d].patch >= 0) continue;
      const int32_t ball = ball_of(out_.darts[d]), patch = int32_t(out_.patches.size());
      int32_t darts = 0;
      for (int32_t at = int32_t(d); out_.darts[at].patch < 0; at = out_.darts[at].next, ++darts)
        out_.darts[at].patch = patch;
      out_.patches.push_back({ball, 1, darts, false});
      first_dart_.push_back(int32_t(d));
      out_.bare[ball] += 2 * kPi;
      ++loops[ball];
    }
    join_split_links(loops);
    find_wrapping();
    drop_joined();
    std::vector<uint8_t> has_edge(shape_.vertex.size(), 0);
    for (const DualShape::Edge &e : shape_.edges) has_edge[e.a] = has_edge[e.b] = 1;
    for (std::size_t b = 0; b < has_edge.size(); ++b)
      if (shape_.vertex[b] && !has_edge[b]) {
        out_.patches.push_back({int32_t(b), 0, 0, true});
        out_.bare[b] = 4 * kPi;
      }
  }

  /// Balls round which the shape is not connected: only these can have patches of several loops.
  /// Round a ball that is not hidden, a thickened shape has as many borders, which are the loops,
  /// as it has components and, together, independent cycles; and the difference of these is its
  /// Euler characteristic.
  void join_split_links(const std::vector<int32_t> &loops) {
    std::vector<int32_t> sum(loops);
    for (const DualShape::Edge &e : shape_.edges) ++sum[e.a], ++sum[e.b];
    for (const DualShape::Triangle &t : shape_.triangles)
      for (int32_t b : t.ball) --sum[b];
    for (std::size_t c = 0; c < shape_.cells.size(); ++c)
      if (shape_.cell_in[c])
        for (int32_t b : shape_.cells[c].ball) ++sum[b];
    std::vector<std::vector<int32_t>> loops_of;
    std::vector<int32_t> number(sum.size(), -1);
    for (std::size_t p = 0; p < out_.patches.size(); ++p) {
      const int32_t b = out_.patches[p].ball;
      if (sum[b] <= 2 || loops[b] < 2) continue;
      if (number[b] < 0) {
        number[b] = int32_t(loops_of.size());
        loops_of.emplace_back();
      }
      loops_of[number[b]].push_back(first_dart_[p]);
    }
    for (const std::vector<int32_t> &l : loops_of) {
      progress_.tick(1, 1);
      join_loops(l);
    }
  }

  /// Loops of one ball that are of one patch: between them there are only tetrahedra outside.
  void join_loops(const std::vector<int32_t> &loops) {
    const int32_t ball = out_.patches[out_.darts[loops[0]].patch].ball;
    mark_.resize(shape_.cells.size(), -1);
    std::vector<int32_t> stack, seen;
    for (int32_t loop : loops) {
      const PatchComplex::Circle &circle = out_.circle(out_.darts[loop]);
      const DualShape::Edge &edge = shape_.edges[circle.edge];
      const int32_t cell = circle.turn == edge.end ? edge.cell : shape_.turns[circle.turn].cell;
      const int32_t patch = out_.darts[loop].patch;
      if (mark_[cell] >= 0) {
        join(loop, mark_[cell]);
        continue;
      }
      stack.assign(1, cell);
      mark_[cell] = patch;
      seen.push_back(cell);
      while (!stack.empty()) {
        const int32_t at = stack.back();
        stack.pop_back();
        const PowerDiagram::Cell &c = shape_.cells[at];
        for (int k = 0; k < 4; ++k) {
          if (c.ball[k] == ball || (shape_.facet_in[at] >> k & 1)) continue;
          const int32_t there = c.neighbor[k] >> 2;
          if (mark_[there] >= 0) continue;
          mark_[there] = patch;
          seen.push_back(there);
          stack.push_back(there);
        }
      }
    }
    for (int32_t cell : seen) mark_[cell] = -1;
  }

  void join(int32_t loop, int32_t patch) {
    PatchComplex::Patch &gone = out_.patches[out_.darts[loop].patch], &kept = out_.patches[patch];
    out_.bare[kept.ball] -= 4 * kPi;
    ++kept.loops;
    kept.darts += gone.darts;
    gone.loops = -1;
    for (int32_t at = loop; out_.darts[at].patch != patch; at = out_.darts[at].next)
      out_.darts[at].patch = patch;
  }

  /// A loop that turns the wrong way is that of a large patch, or of one that is thinner than
  /// rounding.
  void find_wrapping() {
    for (std::size_t p = 0; p < out_.patches.size(); ++p) {
      PatchComplex::Patch &patch = out_.patches[p];
      if (patch.loops != 1) continue;
      const int32_t d = first_dart_[p];
      const Vec3 c = center_of(shape_.site[patch.ball]), origin = out_.position[out_.darts[d].from];
      Vec3 normal, sum;
      for (int32_t at = out_.darts[d].next; at != d; at = out_.darts[at].next) {
        const Vec3 p = out_.position[out_.darts[at].from];
        normal += cross(p - origin, out_.position[out_.to(out_.darts[at])] - origin);
        sum += p - c;
      }
      if (dot(normal, sum + (origin - c)) > 0) continue;
      patch.wraps = loop_angle(out_, shape_, d) > kWraps;
    }
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
    out_.finer = PatchComplex::kMostFiner *
                 std::clamp((wide - kFewWide * all) / ((kManyWide - kFewWide) * all), 0.0, 1.0);
  }

  void drop_joined() {
    std::vector<int32_t> number(out_.patches.size());
    std::size_t kept = 0;
    for (std::size_t p = 0; p < out_.patches.size(); ++p) {
      number[p] = int32_t(kept);
      if (out_.patches[p].loops > 0) out_.patches[kept++] = out_.patches[p];
    }
    out_.patches.resize(kept);
    for (Dart &d : out_.darts) d.patch = number[d.patch];
  }

  const DualShape &shape_;
  PatchOptions options_;
  Progress &progress_;
  std::vector<Site> true_site_;
  PatchComplex out_;
  std::vector<int32_t> point_;           // by triangle and side
  std::vector<double> half_angle_chord_; // per triangle: from its orthocentre to where three meet
  std::vector<Vec3> center_;             // per triangle: its orthocentre
  std::vector<int32_t> start_,
      end_;                   // by singular point and ball of its triangle: the patch's darts
  std::vector<int32_t> first_dart_; // of each patch, of each of its loops before they are joined
  std::vector<AngleSum> corners_;   // of each ball's patches, by part and ball
  std::vector<int32_t> mark_; // per cell: the patch that is searched from
};

} // namespace

PatchComplex patch_complex(const DualShape &shape, const std::vector<Ball> &balls,
                           const PatchOptions &options, Progress &progress) {
  return Search(shape, balls, options, progress).run();
}

} // namespace vbm::impl
