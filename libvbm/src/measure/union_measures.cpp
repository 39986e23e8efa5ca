// SPDX-License-Identifier: GPL-3.0-or-later
// Edelsbrunner, "The union of balls and its dual shape" (1995), in the form with angles that needs
// no intersection of more than three balls; shares as in Edelsbrunner, Koehl, "The weighted-volume
// derivative of a space-filling diagram" (2003).
//
// It differs in working ball by ball instead of summing signed intersections of the whole: on a
// ball's sphere, the theorem of Gauss and Bonnet gives the area A that is bare from angles of the
// dual shape and of its arcs; the ball's part of the union is the cones from its centre over that
// area and over the discs F that other cells cut it off with, so that its volume is
// (r A + sum of h F) / 3. Every term is bounded by the ball's own size, whatever the balls are.
//
// All that is computed for the dual shape's radii, which are a little too large (kTouch). Moving
// spheres and planes back is a correction of first order, which is known exactly: the area times
// the difference, and for planes the discs and arcs on them. What is left is of the order of the
// square of kTouch.
#include "measure/union_measures.h"

#include "core/progress.h"
#include "dual/dual_shape.h"
#include "dual/orthospheres.h"
#include "dual/wedges.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Share of a ball's radius: planes between balls of nearly the same centre move farther than that
/// when the radii change by next to nothing, and are left where they are.
constexpr double kMostShift = 1e-4;

/// Solid angle at the origin of three directions: van Oosterom, Strackee (1983). 0 to 2 pi, as
/// they are counter-clockwise seen from outside.
double solid_angle(const Vec3 &p, const Vec3 &q, const Vec3 &r) {
  const Vec3 a = unit(p), b = unit(q), c = unit(r);
  return 2 * std::atan2(std::max(0.0, dot(a, cross(b, c))), 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

class Sums {
public:
  Sums(const DualShape &shape, const std::vector<Ball> &balls, Progress &progress)
      : shape_(shape), balls_(balls), progress_(progress), angle_(balls.size(), 0),
        arcs_(balls.size(), 0), discs_(balls.size(), 0), area_shift_(balls.size(), 0),
        volume_shift_(balls.size(), 0) {
    work_ = shape.cells.size() + shape.triangles.size() + shape.edges.size();
  }

  UnionMeasures run() {
    for (std::size_t b = 0; b < balls_.size(); ++b)
      if (shape_.vertex[b]) angle_[b] = 4 * kPi;
    add_tetrahedra();
    add_triangles();
    for (const DualShape::Edge &e : shape_.edges) {
      progress_.tick(done_++, work_);
      add_edge(e);
    }
    UnionMeasures m;
    m.ball_volume.assign(balls_.size(), 0);
    m.ball_area.assign(balls_.size(), 0);
    for (std::size_t b = 0; b < balls_.size(); ++b) {
      if (!shape_.vertex[b]) {
        ++m.hidden;
        continue;
      }
      const double r = shape_.site[b].r, grown = r - balls_[b].radius;
      const double area = r * (r * angle_[b] + arcs_[b]);
      const double volume = (r * area + discs_[b]) / 3 - area * grown - volume_shift_[b];
      // Rounding of what is nothing must not become a negative share.
      m.ball_area[b] = std::max(0.0, area - (2 * area / r - arcs_[b]) * grown - area_shift_[b]);
      m.ball_volume[b] = std::max(0.0, volume);
      m.area += m.ball_area[b];
      m.volume += m.ball_volume[b];
    }
    return m;
  }

private:
  Vec3 center(int32_t ball) const { return center_of(shape_.site[ball]); }

  /// Solid angles of the shape's tetrahedra are no part of what is bare.
  void add_tetrahedra() {
    power_center_.resize(shape_.cells.size());
    for (std::size_t c = 0; c < shape_.cells.size(); ++c) {
      progress_.tick(done_++, work_);
      if (!shape_.cell_in[c]) continue;
      const std::array<int32_t, 4> &b = shape_.cells[c].ball;
      power_center_[c] = center(b[0]) + tetrahedron_center(shape_.site[b[0]], shape_.site[b[1]],
                                                           shape_.site[b[2]], shape_.site[b[3]]);
      for (int i = 0; i < 4; ++i) {
        const int(&f)[3] = kFacet[i];
        const Vec3 at = center(b[i]);
        angle_[b[i]] -=
            solid_angle(center(b[f[0]]) - at, center(b[f[1]]) - at, center(b[f[2]]) - at);
      }
    }
  }

  /// Corners of the bare patches: where three spheres meet, on each outside side of their triangle.
  void add_triangles() {
    center_.reserve(shape_.triangles.size());
    chord_.reserve(shape_.triangles.size());
    for (const DualShape::Triangle &t : shape_.triangles) {
      progress_.tick(done_++, work_);
      const Site *s[3] = {&shape_.site[t.ball[0]], &shape_.site[t.ball[1]],
                          &shape_.site[t.ball[2]]};
      const Vec3 y = triangle_center(*s[0], *s[1], *s[2]), at = center(t.ball[0]) + y;
      const double r = s[0]->r, h = length(y);
      const double chord = std::sqrt(std::max(0.0, (r - h) * (r + h)));
      center_.push_back(at);
      chord_.push_back(chord);
      const int sides = t.open[0] + t.open[1];
      if (!sides) continue;
      const Vec3 c[3] = {center(t.ball[0]), center(t.ball[1]), center(t.ball[2])};
      const Vec3 corner = at + unit(cross(c[1] - c[0], c[2] - c[0])) * chord;
      for (int i = 0; i < 3; ++i) {
        const Vec3 u = unit(corner - c[i]);
        const Vec3 p = unit(c[(i + 1) % 3] - c[i]), q = unit(c[(i + 2) % 3] - c[i]);
        const Vec3 g = p - u * dot(p, u), h = q - u * dot(q, u); // into the caps, along the sphere
        angle_[t.ball[i]] += sides * (kPi - std::atan2(length(cross(g, h)), dot(g, h)));
      }
    }
  }

  /// Arcs and discs between two balls.
  void add_edge(const DualShape::Edge &e) {
    const Site &a = shape_.site[e.a], &b = shape_.site[e.b];
    const Axis3 axis(a, b);
    double open = 0, arc = 0; // angles about the edge: outside the shape, and of the bare arcs
    double disc = 0;          // twice the area of the disc between the cells
    if (e.begin == e.end) {
      open = arc = 2 * kPi;
    } else {
      for (uint32_t t = e.begin; t < e.end; ++t) {
        const uint32_t next = next_turn(e, t);
        double from_height, to_height;
        const Vec3 from = facet(axis, e, t, from_height), to = facet(axis, e, next, to_height);
        const int32_t f = shape_.turns[t].triangle(), g = shape_.turns[next].triangle();
        if (shape_.turns[t].outside()) {
          const double wedge = outside_angle(shape_, e, axis, t);
          open += wedge;
          arc += wedge - std::atan2(chord_[f], from_height) - std::atan2(chord_[g], to_height);
          disc += from_height * chord_[f] + to_height * chord_[g];
        } else {
          // The kite between the circle's centre, two facets and the tetrahedron's power centre.
          const Vec3 x = power_center_[shape_.cell_of(t)] - axis.center;
          disc += from_height * dot(x, cross(axis.direction, from)) -
                  to_height * dot(x, cross(axis.direction, to));
        }
      }
    }
    disc = (disc + axis.radius * axis.radius * arc) / 2;
    const double grown =
        (a.r * (a.r - balls_[e.a].radius) - b.r * (b.r - balls_[e.b].radius)) / axis.length;
    add_side(e.a, axis.height_a, grown, open, arc, disc);
    add_side(e.b, axis.height_b, -grown, open, arc, disc);
  }

  /// The direction of a facet from the edge, and how far in that direction its orthocentre is.
  Vec3 facet(const Axis3 &axis, const DualShape::Edge &e, uint32_t turn, double &height) const {
    const Vec3 direction = unit(axis.perpendicular(center(shape_.ball_of(e, turn)) - center(e.a)));
    height = dot(center_[shape_.turns[turn].triangle()] - axis.center, direction);
    return direction;
  }

  void add_side(int32_t ball, double height, double grown, double open, double arc, double disc) {
    angle_[ball] -= open;
    arcs_[ball] += height * arc;
    discs_[ball] += height * disc;
    const double r = shape_.site[ball].r;
    if (!(std::fabs(grown) < kMostShift * r)) return;
    area_shift_[ball] += r * arc * grown;
    volume_shift_[ball] += disc * grown;
  }

  const DualShape &shape_;
  const std::vector<Ball> &balls_;
  Progress &progress_;
  std::size_t done_ = 0, work_;
  std::vector<Vec3> power_center_;   // of the shape's tetrahedra, by cell
  std::vector<Vec3> center_;         // orthocentres of the triangles
  std::vector<double> chord_;        // from there to where the three spheres meet
  std::vector<double> angle_;        // per ball: solid angle, as if all arcs were great circles
  std::vector<double> arcs_, discs_; // per ball: sums of height times arc, height times disc
  std::vector<double> area_shift_, volume_shift_; // for planes that move
};

} // namespace

UnionMeasures union_measures(const std::vector<Ball> &balls, double touch, Progress &progress) {
  const DualShape shape = dual_shape(balls, touch, progress);
  return Sums(shape, balls, progress).run();
}

} // namespace vbm::impl
