// SPDX-License-Identifier: GPL-3.0-or-later
// Chew, "Constrained Delaunay triangulations" (1989), by CGAL (Yvinec, Pion), in the plane that a
// stereographic projection makes of the sphere: circles stay circles, so that the triangles are
// Delaunay on the sphere as well, and the projection's centre is within a cap the patch lies
// outside of. What comes out is counted before it is believed: a patch of m loops is a disk with m
// - 1 holes.
#include "ball_surface/sphere_patch.h"

#include "balls/block_allocator.h"

#define CGAL_ALLOCATOR(T) vbm::impl::BlockAllocator<T>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "core/progress.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace vbm::impl {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int8_t, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Plane = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, Structure, CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Point = Kernel::Point_2;

/// Shares of the grid's spacing: points of it nearer than these to a corner, or to a cap, are left
/// out.
constexpr double kCornerGap = 0.6, kCapGap = 0.35;

/// Bits of a projected coordinate, relative to the largest: exact predicates then take no memory.
constexpr int kPlaneBits = 48;

/// A projection of the sphere from the point `pole`, which keeps what is counter-clockwise seen
/// from outside.
class Projection {
public:
  explicit Projection(const Vec3 &pole) : pole_(pole) {
    const Vec3 any = std::fabs(pole.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    u_ = unit(cross(pole, any));
    v_ = cross(u_, pole);
  }
  void add(const Vec3 &p) {
    const double away = 1 - dot(p, pole_);
    x_.push_back(dot(p, u_) / away);
    y_.push_back(dot(p, v_) / away);
  }
  bool scale() {
    double most = 0;
    for (std::size_t i = 0; i < x_.size(); ++i)
      most = std::max({most, std::fabs(x_[i]), std::fabs(y_[i])});
    if (!(most < 1e12)) return false; // also for what is no number
    step_ = std::ldexp(1.0, std::ilogb(most > 0 ? most : 1) + 1 - kPlaneBits);
    return true;
  }
  /// On a grid of whole numbers below 2^48, scaled to be one digit of the exact type.
  Point at(std::size_t i) const {
    return {std::ldexp(std::nearbyint(x_[i] / step_), -kPlaneBits),
            std::ldexp(std::nearbyint(y_[i] / step_), -kPlaneBits)};
  }
  std::size_t size() const { return x_.size(); }

private:
  Vec3 pole_, u_, v_;
  std::vector<double> x_, y_;
  double step_ = 1;
};

bool is_free(const SpherePatch &patch, const Vec3 &p, double spacing) {
  for (const SpherePatch::Cap &cap : patch.caps)
    if (std::acos(std::clamp(dot(p, cap.axis), -1.0, 1.0)) <
        std::acos(std::clamp(cap.cosine, -1.0, 1.0)) + kCapGap * spacing)
      return false;
  const double near = 2 * std::sin(kCornerGap * spacing / 2);
  for (const std::vector<Vec3> &loop : patch.loops)
    for (const Vec3 &q : loop)
      if (distance(p, q) < near) return false;
  return true;
}

class Triangulating {
public:
  Triangulating(const SpherePatch &patch, PatchTriangles &out, Progress &progress)
      : patch_(patch), out_(out), progress_(progress) {}

  bool run(const Vec3 &pole) {
    Projection projection(pole);
    for (const auto &loop : patch_.loops)
      for (const Vec3 &p : loop) projection.add(p);
    corners_ = projection.size();
    for (const Vec3 &p : out_.points) projection.add(p);
    if (!projection.scale()) return false;
    for (std::size_t i = 0; i < projection.size(); ++i) {
      progress_.tick(0, 1);
      const Plane::Vertex_handle v = plane_.insert(projection.at(i), hint());
      if (plane_.number_of_vertices() != i + 1) return false; // two in one place
      v->info() = int32_t(i);
      vertex_.push_back(v);
    }
    return constrain() && mark() && count();
  }

private:
  Plane::Face_handle hint() const {
    return vertex_.empty() ? Plane::Face_handle() : vertex_.back()->face();
  }

  bool constrain() {
    std::size_t first = 0;
    for (const auto &loop : patch_.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        progress_.tick(0, 1);
        const auto a = vertex_[first + i], b = vertex_[first + (i + 1) % loop.size()];
        plane_.insert_constraint(a, b); // throws where it would cross another
      }
      first += loop.size();
    }
    return plane_.number_of_vertices() == vertex_.size();
  }

  /// What is on the left of the loops, and reached from there without crossing them.
  bool mark() {
    for (auto f = plane_.all_faces_begin(); f != plane_.all_faces_end(); ++f) f->info() = 0;
    std::vector<Plane::Face_handle> stack;
    std::size_t first = 0;
    for (const auto &loop : patch_.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        Plane::Face_handle f;
        int k = 0;
        const auto a = vertex_[first + i], b = vertex_[first + (i + 1) % loop.size()];
        if (!plane_.is_edge(a, b, f, k) || !f->is_constrained(k)) return false;
        // The face in which b follows a counter-clockwise.
        if (f->vertex(Plane::ccw(k)) != a) f = f->neighbor(k);
        if (!f->info()) stack.push_back(f);
        f->info() = 1;
        left_.emplace_back(a, b);
      }
      first += loop.size();
    }
    while (!stack.empty()) {
      const Plane::Face_handle f = stack.back();
      stack.pop_back();
      if (plane_.is_infinite(f)) return false;
      for (int k = 0; k < 3; ++k) {
        if (f->is_constrained(k)) continue;
        const Plane::Face_handle g = f->neighbor(k);
        if (g->info()) continue;
        g->info() = 1;
        stack.push_back(g);
      }
    }
    // The right sides must have stayed outside.
    for (const auto &[a, b] : left_) {
      Plane::Face_handle f;
      int k = 0;
      plane_.is_edge(a, b, f, k);
      if (f->vertex(Plane::ccw(k)) == a) f = f->neighbor(k);
      if (f->info()) return false;
    }
    return true;
  }

  /// Collects the triangles: connected, by their number a disk with holes, and using every corner.
  bool count() {
    std::vector<int32_t> number(vertex_.size(), -1);
    std::vector<Vec3> points;
    std::size_t used = 0, faces = 0, inner_sides = 0;
    for (auto f = plane_.finite_faces_begin(); f != plane_.finite_faces_end(); ++f) {
      if (!f->info()) continue;
      ++faces;
      std::array<int32_t, 3> t;
      for (int k = 0; k < 3; ++k) {
        const int32_t v = f->vertex(k)->info();
        if (number[v] < 0) {
          ++used;
          number[v] = std::size_t(v) < corners_ ? v : int32_t(corners_ + points.size());
          if (std::size_t(v) >= corners_) points.push_back(out_.points[v - corners_]);
        }
        t[k] = number[v];
        inner_sides += !f->is_constrained(k);
      }
      out_.triangles.push_back(t);
    }
    for (std::size_t i = 0; i < corners_; ++i)
      if (number[i] < 0) return false;
    out_.points = std::move(points);
    const long edges = long(corners_) + long(inner_sides) / 2;
    return long(used) - edges + long(faces) == 2 - long(patch_.loops.size()) && is_connected();
  }

  bool is_connected() {
    auto seed = plane_.finite_faces_end();
    for (auto f = plane_.finite_faces_begin(); f != plane_.finite_faces_end(); ++f)
      if (f->info()) seed = f;
    if (seed == plane_.finite_faces_end()) return false;
    std::vector<Plane::Face_handle> stack(1, seed);
    std::size_t reached = 0;
    seed->info() = 2;
    while (!stack.empty()) {
      const Plane::Face_handle f = stack.back();
      stack.pop_back();
      ++reached;
      for (int k = 0; k < 3; ++k) {
        const Plane::Face_handle g = f->neighbor(k);
        if (f->is_constrained(k) || g->info() != 1) continue;
        g->info() = 2;
        stack.push_back(g);
      }
    }
    return reached == out_.triangles.size();
  }

  static Plane make(Blocks &blocks) {
    const Blocks::Scope scope(blocks);
    return Plane();
  }

  const SpherePatch &patch_;
  PatchTriangles &out_;
  Progress &progress_;
  Blocks blocks_; // outlives the triangulation
  Plane plane_ = make(blocks_);
  std::vector<Plane::Vertex_handle> vertex_;
  std::vector<std::pair<Plane::Vertex_handle, Plane::Vertex_handle>> left_;
  std::size_t corners_ = 0;
};

} // namespace

bool triangulate_patch(const SpherePatch &patch, const Geodesic &grid, PatchTriangles &out,
                       Progress &progress) {
  out = {};
  const SpherePatch::Cap *widest = nullptr;
  for (const SpherePatch::Cap &cap : patch.caps)
    if (!widest || cap.cosine < widest->cosine) widest = &cap;
  if (!widest) return false;
  for (const Vec3 &p : grid.points)
    if (is_free(patch, p, grid.spacing)) out.points.push_back(p);
  try {
    return Triangulating(patch, out, progress).run(widest->axis);
  } catch (const Plane::Intersection_of_constraints_exception &) {
    return false;
  }
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
