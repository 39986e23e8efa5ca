// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball_surface/patch_complex.h"

#include "core/progress.h"
#include "dual/wedges.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A circle is cut into at least so many pieces.
constexpr int kLeastPieces = 3;

class Building {
public:
  Building(const BoundaryMap &map, const DualShape &shape, const std::vector<uint8_t> &contracted,
           const PatchOptions &options, MergedPoints &points, Progress &progress)
      : map_(map), shape_(shape), contracted_(contracted), options_(options), points_(points),
        progress_(progress) {}

  PatchComplex run() {
    out_.bare = map_.bare;
    out_.finer = map_.finer;
    const std::size_t left =
        std::size_t(std::count(contracted_.begin(), contracted_.end(), uint8_t(0)));
    out_.circles.reserve(left);
    out_.arcs.reserve(2 * left); // some will be cut in two
    out_.darts.reserve(4 * left);
    out_.patches.reserve(map_.patches.size());
    for (const BoundaryMap::Patch &p : map_.patches)
      out_.patches.push_back({p.ball, p.loops, 0, p.wraps});
    // Darts begin where their corners are now, so that it takes no search to tell.
    name_.reserve(map_.position.size());
    for (std::size_t v = 0; v < map_.position.size(); ++v) {
      progress_.tick(v, 4 * map_.position.size());
      name_.push_back(points_.find(int32_t(v)));
    }
    begin_.reserve(map_.spans.size() + 1);
    for (std::size_t s = 0; s < map_.spans.size(); ++s) {
      progress_.tick(s, 2 * map_.spans.size());
      begin_.push_back(int32_t(out_.darts.size()));
      if (!contracted_[s]) add_span(s);
    }
    begin_.push_back(int32_t(out_.darts.size()));
    link();
    return std::move(out_);
  }

private:
  using Circle = PatchComplex::Circle;

  void add_span(std::size_t s) {
    const BoundaryMap::Span &span = map_.spans[s];
    const DualShape::Edge &edge = shape_.edges[span.edge];
    const Axis3 axis(shape_.site[edge.a], shape_.site[edge.b]);
    out_.circles.push_back({span.edge, axis.center, {}, axis.direction});
    Circle &circle = out_.circles.back();
    int32_t first = map_.from[2 * s + 1], last = map_.from[2 * s];
    int pieces;
    if (first < 0) {
      // Any direction: across the axis's smallest coordinate.
      const Vec3 &d = axis.direction;
      const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
      const Vec3 u = x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
      circle.u = unit(axis.perpendicular(u)) * axis.radius;
      pieces = std::max(kLeastPieces, pieces_of(edge, axis, 2 * kPi));
      first = last = add_vertex(PatchComplex::point(circle, 0));
    } else {
      circle.u = span.by_end ? map_.position[first] - axis.center
                             : turn_direction(shape_, edge, axis, span.turn) * axis.radius;
      pieces = pieces_of(edge, axis, span.angle);
    }
    add_pieces(span, pieces, first, last, s);
  }

  int pieces_of(const DualShape::Edge &edge, const Axis3 &axis, double angle) const {
    const double r = std::min(shape_.site[edge.a].r, shape_.site[edge.b].r);
    const double sagitta = options_.bulge * r;
    // 1 - cos x is x x / 2 at most.
    if (angle < 2 * kPi / kLeastPieces && (axis.radius * angle * angle <= 8 * sagitta ||
                                           axis.radius * (1 - std::cos(angle / 2)) <= sagitta))
      return 1;
    const double most =
        std::min(2 * std::acos(std::max(-1.0, 1 - sagitta / axis.radius)), 2 * kPi / kLeastPieces);
    return std::max(1, int(std::ceil(angle / most - 1e-9)));
  }

  int32_t add_vertex(const Vec3 &p) {
    out_.position.push_back(p);
    return points_.add(p);
  }

  void add_pieces(const BoundaryMap::Span &span, int pieces, int32_t first, int32_t last,
                  std::size_t s) {
    const int32_t number = int32_t(out_.circles.size()) - 1;
    const int32_t against = map_.patch_of[2 * s], along = map_.patch_of[2 * s + 1];
    out_.patches[against].darts += pieces;
    out_.patches[along].darts += pieces;
    int32_t at = first;
    for (int k = 0; k < pieces; ++k) {
      const double from = span.begin + span.angle * k / pieces,
                   to = span.begin + span.angle * (k + 1) / pieces;
      const int32_t arc = int32_t(out_.arcs.size()), dart = int32_t(out_.darts.size());
      const int32_t there =
          k + 1 == pieces ? last : add_vertex(PatchComplex::point(out_.circles[number], to));
      out_.arcs.push_back({number, at, there, from, to});
      out_.darts.push_back({name(there), -1, -1, dart + 1, against, arc, false});
      out_.darts.push_back({name(at), -1, -1, dart, along, arc, true});
      if (k > 0) {
        set_next(dart - 1, dart + 1);
        set_next(dart, dart - 2);
      }
      at = there;
    }
  }

  int32_t name(int32_t v) const { return std::size_t(v) < name_.size() ? name_[v] : v; }

  void set_next(int32_t dart, int32_t next) {
    out_.darts[dart].next = next;
    out_.darts[next].previous = dart;
  }

  /// Of a side's darts. Those against the arc come before their twins, the last of them first.
  int32_t first_of(int32_t side) const {
    return side & 1 ? begin_[side / 2] + 1 : begin_[side / 2 + 1] - 2;
  }
  int32_t last_of(int32_t side) const {
    return side & 1 ? begin_[side / 2 + 1] - 1 : begin_[side / 2];
  }

  /// Each side's last piece to the first of the next side that is left.
  void link() {
    for (std::size_t side = 0; side < map_.next.size(); ++side) {
      progress_.tick(map_.next.size() + side, 2 * map_.next.size());
      if (contracted_[side / 2]) continue;
      int32_t next = map_.next[side];
      while (contracted_[next / 2]) next = map_.next[next];
      set_next(last_of(int32_t(side)), first_of(next));
    }
  }

  const BoundaryMap &map_;
  const DualShape &shape_;
  const std::vector<uint8_t> &contracted_;
  const PatchOptions &options_;
  MergedPoints &points_;
  Progress &progress_;
  PatchComplex out_;
  std::vector<int32_t> name_;  // by point: that of all that became one with it
  std::vector<int32_t> begin_; // by span: its first dart, or that of the next that has any
};

} // namespace

PatchComplex patch_complex(const BoundaryMap &map, const DualShape &shape,
                           const std::vector<uint8_t> &contracted, const PatchOptions &options,
                           MergedPoints &points, Progress &progress) {
  return Building(map, shape, contracted, options, points, progress).run();
}

} // namespace vbm::impl
