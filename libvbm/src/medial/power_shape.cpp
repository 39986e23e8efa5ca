// SPDX-License-Identifier: GPL-3.0-or-later
// Amenta, Choi, Kolluri, "The power crust, unions of balls, and the medial axis transform" (2001),
// for the power shape; Amenta, Kolluri, "The medial axis of a union of balls" (2001), and thesis
// 7.3.1 for its singular points: one for each side of a triangle behind which there is no
// tetrahedron. Identical ones are found by incidence (thesis 7.4): where the three balls of a
// triangle touch one sample, the singular point is that sample, and is not computed.
#include "medial/power_shape.h"

#include "core/cells.h"
#include "core/progress.h"
#include "surface/power_diagram.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vbm::impl {
namespace {

/// Unit lengths. A computed singular point this far from one of its three spheres is no use: their
/// centres are too nearly in line.
constexpr double kOffSphere = 1e-11;

/// Unit lengths. Balls that are no polar balls of the shape but of far noise meet beyond this.
constexpr double kBeyond = 1;

class Finder {
public:
  Finder(const Model &model, Progress &progress)
      : model_(model), progress_(progress),
        diagram_(power_diagram(model.balls, model.inner, progress)) {}

  PowerShape run() {
    for (std::size_t c = 0; c < diagram_.cells.size(); ++c) {
      progress_.tick(1, 1);
      const PowerDiagram::Cell &cell = diagram_.cells[c];
      if (cell.ball[0] < 0) continue;
      if (is_inner(cell)) {
        ++out_.tetrahedra;
        continue;
      }
      for (int i = 0; i < 4; ++i)
        if (is_inner(cell, i)) look_at(int32_t(c), i);
    }
    return std::move(out_);
  }

private:
  bool is_inner(int32_t ball) const { return std::size_t(ball) < model_.inner; }
  bool is_inner(const PowerDiagram::Cell &cell) const {
    return is_inner(cell.ball[0]) && is_inner(cell.ball[1]) && is_inner(cell.ball[2]) &&
           is_inner(cell.ball[3]);
  }
  bool is_inner(const PowerDiagram::Cell &cell, int facet) const {
    for (int k : kFacet[facet])
      if (!is_inner(cell.ball[k])) return false;
    return true;
  }

  /// A triangle of the shape, seen from a tetrahedron beside it that is not of the shape.
  void look_at(int32_t c, int facet) {
    const PowerDiagram::Cell &cell = diagram_.cells[c];
    const int32_t behind = cell.neighbor[facet];
    int32_t inner = -1; // the far ball of the shape's tetrahedron behind
    if (behind >= 0 && is_inner(diagram_.cells[behind >> 2])) {
      inner = diagram_.cells[behind >> 2].ball[behind & 3];
      ++out_.regular;
    } else if (behind < 0 || (behind >> 2) > c) {
      ++out_.singular;
    }
    SingularPoint point;
    const int(&k)[3] = kFacet[facet];
    const int32_t ball[3] = {cell.ball[k[0]], cell.ball[k[1]], cell.ball[k[2]]};
    const Vec3 &origin = model_.balls[ball[0]].center;
    const Vec3 u = model_.balls[ball[1]].center - origin, v = model_.balls[ball[2]].center - origin;
    point.outward = unit(-cross(u, v)); // the facet is counter-clockwise from outside of the cell
    for (int i = 0; i < 3; ++i) point.balls[i] = ball[i];
    point.sample = common_sample(ball);
    if (point.sample >= 0)
      point.position = model_.samples.position[point.sample];
    else if (!meet(ball, point.outward, point.position) || covered(inner, point.position)) {
      ++out_.apart;
      return;
    }
    std::sort(point.balls.begin(), point.balls.end());
    find_near(point);
    out_.points.push_back(point);
  }

  /// The least sample that three balls touch, or -1.
  int32_t common_sample(const int32_t (&ball)[3]) const {
    const Incidence &lists = model_.ball_samples;
    const auto list = [&](int i) { return lists.index.data() + lists.offset[ball[i]]; };
    const auto end = [&](int i) { return lists.index.data() + lists.offset[ball[i] + 1]; };
    for (const int32_t *s = list(0); s != end(0); ++s)
      if (std::binary_search(list(1), end(1), *s) && std::binary_search(list(2), end(2), *s))
        return *s;
    return -1;
  }

  /// Where three spheres meet on one side of the plane through their centres.
  bool meet(const int32_t (&ball)[3], const Vec3 &outward, Vec3 &position) const {
    const Ball &a = model_.balls[ball[0]], &b = model_.balls[ball[1]], &c = model_.balls[ball[2]];
    const Vec3 u = b.center - a.center, v = c.center - a.center, n = cross(u, v);
    const double square = dot(n, n);
    const double p = (dot(u, u) + (a.radius - b.radius) * (a.radius + b.radius)) / 2;
    const double q = (dot(v, v) + (a.radius - c.radius) * (a.radius + c.radius)) / 2;
    const Vec3 in_plane = (cross(v, n) * p + cross(n, u) * q) * (1 / square);
    const double height = a.radius * a.radius - dot(in_plane, in_plane);
    if (!(height >= 0)) return false; // also where the centres are in line
    position = a.center + in_plane + outward * std::sqrt(height);
    for (const Ball *ball_at : {&a, &b, &c})
      if (!(std::fabs(distance(position, ball_at->center) - ball_at->radius) < kOffSphere))
        return false;
    return std::max({std::fabs(position.x), std::fabs(position.y), std::fabs(position.z)}) <
           kBeyond;
  }

  /// Whether the point is inside the fourth ball of the tetrahedron behind: then not even the
  /// union's boundary comes to it.
  bool covered(int32_t inner, const Vec3 &position) const {
    return inner >= 0 &&
           distance(position, model_.balls[inner].center) < model_.balls[inner].radius - kOffSphere;
  }

  void find_near(SingularPoint &point) const {
    const Incidence &lists = model_.ball_samples;
    std::pair<double, int32_t> best{HUGE_VAL, -1}, second = best;
    const auto look_at = [&](int32_t s) {
      const std::pair<double, int32_t> here{distance(model_.samples.position[s], point.position),
                                            s};
      if (here.second == best.second || here.second == second.second) return;
      if (here < best)
        second = std::exchange(best, here);
      else if (here < second)
        second = here;
    };
    for (int32_t b : point.balls)
      for (uint64_t k = lists.offset[b]; k < lists.offset[b + 1]; ++k) look_at(lists.index[k]);
    if (second.second < 0) // the balls there touch no two samples
      for (int32_t s = 0; s < model_.cells.samples; ++s) look_at(s);
    point.near_sample = best.second;
    point.next_sample = second.second;
  }

  const Model &model_;
  Progress &progress_;
  PowerDiagram diagram_;
  PowerShape out_;
};

} // namespace

PowerShape power_shape(const Model &model, Progress &progress) {
  return Finder(model, progress).run();
}

} // namespace vbm::impl
