// SPDX-License-Identifier: GPL-3.0-or-later
// Chew, "Constrained Delaunay triangulations" (1989), on the sphere itself, so that patches may be
// of any size and every triangle faces outwards. What comes out is counted before it is believed: a
// patch of m loops is a disk with m - 1 holes.
#include "ball_surface/sphere_patch.h"

#include "ball_surface/sphere_triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vbm::impl {
namespace {

/// Shares of the grid's spacing: points of it nearer than these to a corner, or to a cap, are left
/// out.
constexpr double kCornerGap = 0.6, kCapGap = 0.35;

/// Ways to turn the octahedron that are tried.
constexpr int kTurns = 12;

/// Where a patch has room for points.
class Room {
public:
  Room(const SpherePatch &patch, double spacing)
      : patch_(patch), near_(2 * std::sin(kCornerGap * spacing / 2)) {
    for (const SpherePatch::Cap &cap : patch.caps) {
      const double angle = std::acos(std::clamp(cap.cosine, -1.0, 1.0));
      angle_.push_back(angle);
      limit_.push_back(std::cos(std::min(angle + kCapGap * spacing, 3.141592653589793)));
    }
  }

  bool is_free(const Vec3 &p) const {
    for (std::size_t i = 0; i < limit_.size(); ++i)
      if (dot(p, patch_.caps[i].axis) > limit_[i]) return false;
    for (const std::vector<Vec3> &loop : patch_.loops)
      for (const Vec3 &q : loop)
        if (is_near(p, q)) return false;
    return true;
  }
  bool is_near(const Vec3 &p, const Vec3 &q) const {
    const Vec3 d = p - q;
    return dot(d, d) < near_ * near_;
  }

  /// How far a direction is from every border, in radians: within caps, too.
  double clearance(const Vec3 &p) const {
    double least = std::numeric_limits<double>::infinity(), deepest = 0;
    for (std::size_t i = 0; i < angle_.size(); ++i) {
      const double away = std::acos(std::clamp(dot(p, patch_.caps[i].axis), -1.0, 1.0)) - angle_[i];
      deepest = std::max(deepest, -away);
      least = std::min(least, away);
    }
    if (deepest > 0) return deepest;
    for (const std::vector<Vec3> &loop : patch_.loops)
      for (const Vec3 &q : loop) least = std::min(least, distance(p, q));
    return least;
  }

private:
  const SpherePatch &patch_;
  double near_;
  std::vector<double> angle_, limit_;
};

/// An octahedron turned so that its corners are away from the patch's borders.
std::array<Vec3, 6> octahedron(const Room &room, double spacing) {
  std::array<Vec3, 6> best{};
  double most = -1;
  for (int i = 0; i < kTurns && most < kCornerGap * spacing; ++i) {
    // Turns spread over all by multiples of two irrational numbers.
    const double z = 2 * std::fmod(0.5 + i * 0.7548776662466927, 1) - 1,
                 turn = 6.283185307179586 * std::fmod(0.25 + i * 0.5698402909980532, 1);
    const double s = std::sqrt(1 - z * z);
    const Vec3 a{s * std::cos(turn), s * std::sin(turn), z};
    const Vec3 other{std::sin(turn + i), std::cos(turn + 2 * i), std::sin(1.0 + 3 * i)};
    const Vec3 b = unit(cross(a, other)), c = cross(a, b);
    if (b == Vec3{}) continue;
    const std::array<Vec3, 6> corners{a, -a, b, -b, c, -c};
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3 &p : corners) least = std::min(least, room.clearance(p));
    if (least > most) most = least, best = corners;
  }
  return best;
}

class Triangulating {
public:
  Triangulating(const SpherePatch &patch, const std::array<Vec3, 6> &start, PatchTriangles &out,
                Progress &progress)
      : patch_(patch), out_(out), sphere_(start, progress) {}

  bool run(const std::vector<Vec3> &points) {
    for (const auto &loop : patch_.loops)
      for (const Vec3 &p : loop) corner_.push_back(sphere_.insert(p));
    for (const Vec3 &p : points) sphere_.insert(p);
    std::size_t first = 0;
    for (const auto &loop : patch_.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i)
        side_.push_back({int32_t(first + i), int32_t(first + (i + 1) % loop.size())});
      first += loop.size();
    }
    for (const auto &[u, v] : side_)
      if (corner_[u] == corner_[v] || !sphere_.constrain(corner_[u], corner_[v])) return false;
    sphere_.improve();
    return mark() && name_corners() && collect();
  }

private:
  using Triangle = SphereTriangulation::Triangle;

  /// What is on the left of the loops, and reached from there without crossing them.
  bool mark() {
    std::vector<Triangle> &t = sphere_.triangles();
    std::vector<int32_t> stack;
    int side = 0;
    for (const auto &[u, v] : side_) {
      const int32_t left = sphere_.find(corner_[u], corner_[v], side);
      if (left < 0) return false;
      if (!t[left].mark) stack.push_back(left);
      t[left].mark = 1;
    }
    while (!stack.empty()) {
      const int32_t at = stack.back();
      stack.pop_back();
      for (int k = 0; k < 3; ++k) {
        const int32_t n = t[at].neighbor[k];
        if (t[at].fixed[k] || t[n].mark) continue;
        t[n].mark = 1;
        stack.push_back(n);
      }
    }
    // The right sides must have stayed outside.
    for (const auto &[u, v] : side_) {
      const int32_t left = sphere_.find(corner_[u], corner_[v], side);
      if (t[t[left].neighbor[side]].mark) return false;
    }
    return true;
  }

  /// Tells the triangles which corner is theirs: several may be in one direction, where the patch
  /// touches itself. Each has those between its two sides.
  bool name_corners() {
    std::vector<Triangle> &t = sphere_.triangles();
    name_.assign(t.size(), {-1, -1, -1});
    int side = 0;
    for (const auto &[u, v] : side_) {
      const int32_t a = corner_[u];
      for (int32_t at = sphere_.find(a, corner_[v], side);;) {
        const int i = SphereTriangulation::index(t[at], a), leave = i == 2 ? 0 : i + 1;
        if (name_[at][i] >= 0) return false;
        name_[at][i] = u;
        if (t[at].fixed[leave]) break;
        at = t[at].neighbor[leave];
      }
    }
    return true;
  }

  bool collect() {
    std::vector<Triangle> &t = sphere_.triangles();
    const int32_t corners = int32_t(corner_.size());
    std::vector<int32_t> number(sphere_.vertices(), -1);
    std::vector<uint8_t> used(corner_.size(), 0), is_corner(sphere_.vertices(), 0);
    for (int32_t v : corner_) is_corner[v] = 1;
    std::size_t inner_sides = 0, seen = 0;
    for (std::size_t i = 0; i < t.size(); ++i) {
      if (!t[i].mark) continue;
      std::array<int32_t, 3> made = name_[i];
      for (int k = 0; k < 3; ++k) {
        const int32_t v = t[i].vertex[k];
        inner_sides += !t[i].fixed[k];
        if (made[k] >= 0) {
          seen += !used[made[k]];
          used[made[k]] = 1;
          continue;
        }
        if (is_corner[v]) return false;
        if (number[v] < 0) {
          number[v] = corners + int32_t(out_.points.size());
          out_.points.push_back(sphere_.at(v));
        }
        made[k] = number[v];
      }
      out_.triangles.push_back(made);
    }
    const long vertices = long(seen + out_.points.size()),
               edges = long(side_.size()) + long(inner_sides) / 2;
    return seen == corner_.size() &&
           vertices - edges + long(out_.triangles.size()) == 2 - long(patch_.loops.size()) &&
           is_connected();
  }

  bool is_connected() {
    std::vector<Triangle> &t = sphere_.triangles();
    std::vector<int32_t> stack;
    for (std::size_t i = 0; i < t.size() && stack.empty(); ++i)
      if (t[i].mark == 1) stack.push_back(int32_t(i));
    if (stack.empty()) return false;
    t[stack[0]].mark = 2;
    std::size_t reached = 0;
    while (!stack.empty()) {
      const int32_t at = stack.back();
      stack.pop_back();
      ++reached;
      for (int k = 0; k < 3; ++k) {
        const int32_t n = t[at].neighbor[k];
        if (t[at].fixed[k] || t[n].mark != 1) continue;
        t[n].mark = 2;
        stack.push_back(n);
      }
    }
    return reached == out_.triangles.size();
  }

  const SpherePatch &patch_;
  PatchTriangles &out_;
  SphereTriangulation sphere_;
  std::vector<int32_t> corner_;              // the vertex of each
  std::vector<std::array<int32_t, 2>> side_; // of loops: corners
  std::vector<std::array<int32_t, 3>> name_; // per triangle and vertex: the corner
};

} // namespace

bool triangulate_patch(const SpherePatch &patch, const Geodesic &grid, PatchTriangles &out,
                       Progress &progress) {
  out = {};
  const Room room(patch, grid.spacing);
  const std::array<Vec3, 6> start = octahedron(room, grid.spacing);
  std::vector<Vec3> points;
  for (const Vec3 &p : grid.points) {
    bool is_free = room.is_free(p);
    for (const Vec3 &q : start) is_free = is_free && !room.is_near(p, q);
    if (is_free) points.push_back(p);
  }
  return Triangulating(patch, start, out, progress).run(points);
}

double solid_angle(const SpherePatch &patch, const PatchTriangles &built) {
  std::vector<Vec3> at;
  for (const auto &loop : patch.loops) at.insert(at.end(), loop.begin(), loop.end());
  at.insert(at.end(), built.points.begin(), built.points.end());
  double sum = 0;
  for (const auto &t : built.triangles) {
    // Van Oosterom, Strackee, "The solid angle of a plane triangle" (1983).
    const Vec3 &p = at[t[0]], &q = at[t[1]], &r = at[t[2]];
    sum += 2 * std::atan2(dot(cross(p, q), r), 1 + dot(p, q) + dot(q, r) + dot(r, p));
  }
  return sum;
}

void ring_patch(const SpherePatch &patch, const Vec3 &middle, PatchTriangles &out) {
  out = {};
  // The walk round all loops: to each later one and back by a cut, whose middle is a point.
  struct Stop {
    int32_t vertex; // corner, or ~point
    Vec3 place;
  };
  std::vector<Stop> walk;
  int32_t first = 0;
  for (std::size_t l = 0; l < patch.loops.size(); ++l) {
    const std::vector<Vec3> &loop = patch.loops[l];
    const std::size_t count = loop.size();
    // Loops may touch: a cut's ends must not be one vertex.
    std::size_t start = 0;
    while (l > 0 && start + 1 < count && loop[start] == walk[0].place) ++start;
    int32_t cut = 0;
    if (l > 0) {
      cut = ~int32_t(out.points.size());
      out.points.push_back(unit(walk[0].place + loop[start]));
      walk.push_back({0, walk[0].place});
      walk.push_back({cut, out.points.back()});
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = (start + i) % count;
      walk.push_back({first + int32_t(k), loop[k]});
    }
    if (l > 0) {
      walk.push_back({first + int32_t(start), loop[start]});
      walk.push_back({cut, out.points[~cut]});
    }
    first += int32_t(loop.size());
  }
  const int32_t ring = int32_t(out.points.size()), count = int32_t(walk.size());
  for (const Stop &s : walk) {
    const Vec3 p = unit(s.place + middle);
    out.points.push_back(p == Vec3{} ? middle : p);
  }
  const int32_t center = int32_t(out.points.size());
  out.points.push_back(middle);
  const auto vertex = [&](int32_t v) { return v < 0 ? first + ~v : v; };
  for (int32_t i = 0; i < count; ++i) {
    const int32_t j = (i + 1) % count, a = vertex(walk[i].vertex), b = vertex(walk[j].vertex);
    out.triangles.push_back({a, b, first + ring + j});
    out.triangles.push_back({a, first + ring + j, first + ring + i});
    out.triangles.push_back({first + ring + i, first + ring + j, first + center});
  }
}

Vec3 patch_middle(const SpherePatch &patch, const Geodesic &grid) {
  Vec3 best, sum;
  double most = -4;
  for (const Vec3 &p : grid.points) {
    double free = 4;
    for (const SpherePatch::Cap &cap : patch.caps)
      free = std::min(free, std::acos(std::clamp(dot(p, cap.axis), -1.0, 1.0)) -
                                std::acos(std::clamp(cap.cosine, -1.0, 1.0)));
    if (free > most) {
      most = free;
      best = p;
    }
  }
  if (most > 0) return best;
  for (const auto &loop : patch.loops)
    for (const Vec3 &p : loop) sum += p;
  return sum == Vec3{} ? best : unit(sum);
}

} // namespace vbm::impl
