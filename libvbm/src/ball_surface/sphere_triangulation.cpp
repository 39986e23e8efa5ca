// SPDX-License-Identifier: GPL-3.0-or-later
// Lawson, "Software for C1 surface interpolation" (1977), for the insertion and the flips; Sloan,
// "A fast algorithm for generating constrained Delaunay triangulations" (1993), for the
// constraints; both with great circles for lines. All that is asked of the points are signs of
// determinants, which are exact (CGAL's filtered predicates), so that the triangles stay what they
// are said to be. A flip only moves the surface outwards, so that flips come to an end.
#include "ball_surface/sphere_triangulation.h"

#include "core/progress.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace vbm::impl {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(const Vec3 &v) { return {v.x, v.y, v.z}; }

constexpr int next(int k) { return k == 2 ? 0 : k + 1; }
constexpr int last(int k) { return k == 0 ? 2 : k - 1; }

} // namespace

SphereTriangulation::SphereTriangulation(const std::array<Vec3, 6> &octahedron, Progress &progress)
    : progress_(progress), p_(octahedron.begin(), octahedron.end()) {
  // Opposite corners are 2 i and 2 i + 1; one of each pair for every triangle.
  const int sign = turn(0, 2, 4);
  t_.resize(8);
  of_.assign(6, 0);
  for (int32_t i = 0; i < 8; ++i) {
    Triangle &t = t_[i];
    t.fixed = {0, 0, 0};
    t.mark = 0;
    for (int k = 0; k < 3; ++k) {
      t.vertex[k] = 2 * k + (i >> k & 1);
      t.neighbor[k] = i ^ (1 << k);
      of_[t.vertex[k]] = i;
    }
    const int odd = (i & 1) ^ (i >> 1 & 1) ^ (i >> 2 & 1);
    if ((sign > 0) == (odd == 1)) {
      std::swap(t.vertex[0], t.vertex[1]);
      std::swap(t.neighbor[0], t.neighbor[1]);
    }
  }
}

int SphereTriangulation::turn(const Vec3 &a, const Vec3 &b, const Vec3 &c) {
  return int(CGAL::orientation(Kernel::Point_3(0, 0, 0), point(a), point(b), point(c)));
}

bool SphereTriangulation::is_above(int32_t a, int32_t b, int32_t c, int32_t d) const {
  return CGAL::orientation(point(p_[a]), point(p_[b]), point(p_[c]), point(p_[d])) ==
         CGAL::POSITIVE;
}

int SphereTriangulation::mirror(int32_t t, int k) const {
  // The side's ends are in the other order there.
  const Triangle &other = t_[t_[t].neighbor[k]];
  return next(index(other, t_[t].vertex[next(k)]));
}

int32_t SphereTriangulation::locate(const Vec3 &p) const {
  // A walk in a Delaunay triangulation ends; the limit is for what constraints may have left.
  int32_t at = of_.back();
  for (std::size_t step = 0; step < 2 * t_.size(); ++step) {
    const Triangle &t = t_[at];
    int out = -1;
    for (int i = 0; i < 3 && out < 0; ++i) {
      const int k = int((step + std::size_t(i)) % 3);
      if (turn(p_[t.vertex[next(k)]], p_[t.vertex[last(k)]], p) < 0) out = k;
    }
    if (out < 0) return at;
    at = t.neighbor[out];
  }
  for (std::size_t i = 0; i < t_.size(); ++i) {
    const Triangle &t = t_[i];
    bool inside = true;
    for (int k = 0; k < 3; ++k)
      inside = inside && turn(p_[t.vertex[next(k)]], p_[t.vertex[last(k)]], p) >= 0;
    if (inside) return int32_t(i);
  }
  return at; // never: they cover the sphere
}

int32_t SphereTriangulation::insert(const Vec3 &direction) {
  progress_.tick(0, 1);
  const int32_t t = locate(direction), v = int32_t(p_.size());
  int on = -1, zeros = 0;
  for (int k = 0; k < 3; ++k)
    if (turn(p_[t_[t].vertex[next(k)]], p_[t_[t].vertex[last(k)]], direction) == 0) on = k, ++zeros;
  if (zeros >= 2) {
    // In the direction of the vertex that both sides have.
    for (int k = 0; k < 3; ++k)
      if (turn(p_[t_[t].vertex[next(k)]], p_[t_[t].vertex[last(k)]], direction) != 0)
        return t_[t].vertex[k];
    return t_[t].vertex[on]; // never: three sides have no direction in common
  }
  p_.push_back(direction);
  of_.push_back(t);
  if (zeros == 1)
    split_edge(t, on, v);
  else
    split_triangle(t, v);
  return v;
}

void SphereTriangulation::set(int32_t t, const std::array<int32_t, 3> &v,
                              const std::array<int32_t, 3> &n,
                              const std::array<uint8_t, 3> &fixed) {
  t_[t].vertex = v;
  t_[t].neighbor = n;
  t_[t].fixed = fixed;
  for (int32_t u : v) of_[u] = t;
}

/// Tells the neighbour across side k that this triangle is now the one on that side.
void SphereTriangulation::relink(int32_t t, int k) {
  Triangle &other = t_[t_[t].neighbor[k]];
  const int32_t a = t_[t].vertex[next(k)], b = t_[t].vertex[last(k)];
  for (int i = 0; i < 3; ++i)
    if (other.vertex[next(i)] == b && other.vertex[last(i)] == a) other.neighbor[i] = t;
}

void SphereTriangulation::split_triangle(int32_t t, int32_t v) {
  const Triangle old = t_[t];
  const int32_t n = int32_t(t_.size());
  t_.resize(t_.size() + 2, old);
  const int32_t piece[3] = {t, n, n + 1}; // piece k has side k
  for (int k = 0; k < 3; ++k)
    set(piece[k], {v, old.vertex[next(k)], old.vertex[last(k)]},
        {old.neighbor[k], piece[next(k)], piece[last(k)]}, {old.fixed[k], 0, 0});
  for (int32_t p : piece) relink(p, 0);
  std::vector<int32_t> work{t, n, n + 1};
  legalize(work);
}

void SphereTriangulation::split_edge(int32_t t, int k, int32_t v) {
  const int32_t u = t_[t].neighbor[k];
  const int m = mirror(t, k);
  const Triangle p = t_[t], q = t_[u];
  const int32_t n = int32_t(t_.size());
  t_.resize(t_.size() + 2, p);
  const int32_t c = p.vertex[k], a = p.vertex[next(k)], b = p.vertex[last(k)], d = q.vertex[m];
  // c, a, v | c, v, b | d, b, v | d, v, a
  set(t, {c, a, v}, {u, n, p.neighbor[last(k)]}, {0, 0, p.fixed[last(k)]});
  set(n, {c, v, b}, {n + 1, p.neighbor[next(k)], t}, {0, p.fixed[next(k)], 0});
  set(n + 1, {d, b, v}, {n, u, q.neighbor[last(m)]}, {0, 0, q.fixed[last(m)]});
  set(u, {d, v, a}, {t, q.neighbor[next(m)], n + 1}, {0, q.fixed[next(m)], 0});
  relink(t, 2);
  relink(n, 1);
  relink(n + 1, 2);
  relink(u, 1);
  std::vector<int32_t> work{t, n, n + 1, u};
  legalize(work);
}

/// Whether the two triangles at a side can have the other diagonal.
bool SphereTriangulation::is_convex(int32_t t, int k) const {
  const Triangle &p = t_[t], &q = t_[p.neighbor[k]];
  const int32_t c = p.vertex[k], a = p.vertex[next(k)], b = p.vertex[last(k)],
                d = q.vertex[mirror(t, k)];
  return turn(c, a, d) > 0 && turn(d, b, c) > 0;
}

void SphereTriangulation::flip(int32_t t, int k) {
  const int32_t u = t_[t].neighbor[k];
  const int m = mirror(t, k);
  const Triangle p = t_[t], q = t_[u];
  const int32_t c = p.vertex[k], a = p.vertex[next(k)], b = p.vertex[last(k)], d = q.vertex[m];
  set(t, {c, a, d}, {q.neighbor[next(m)], u, p.neighbor[last(k)]},
      {q.fixed[next(m)], 0, p.fixed[last(k)]});
  set(u, {d, b, c}, {p.neighbor[next(k)], t, q.neighbor[last(m)]},
      {p.fixed[next(k)], 0, q.fixed[last(m)]});
  relink(t, 0);
  relink(t, 2);
  relink(u, 0);
  relink(u, 2);
}

void SphereTriangulation::legalize(std::vector<int32_t> &work) {
  while (!work.empty()) {
    const int32_t t = work.back();
    work.pop_back();
    for (int k = 0; k < 3; ++k) {
      if (t_[t].fixed[k]) continue;
      const Triangle &p = t_[t];
      const int32_t u = p.neighbor[k], d = t_[u].vertex[mirror(t, k)];
      if (!is_above(p.vertex[0], p.vertex[1], p.vertex[2], d) || !is_convex(t, k)) continue;
      flip(t, k);
      work.push_back(u);
      work.push_back(t);
      break;
    }
  }
}

void SphereTriangulation::improve() {
  std::vector<int32_t> work(t_.size());
  for (std::size_t i = 0; i < work.size(); ++i) work[i] = int32_t(i);
  legalize(work);
}

int32_t SphereTriangulation::find(int32_t a, int32_t b, int &side) const {
  const int32_t first = of_[a];
  int32_t at = first;
  do {
    const Triangle &t = t_[at];
    const int i = index(t, a);
    if (t.vertex[next(i)] == b) {
      side = last(i);
      return at;
    }
    at = t.neighbor[next(i)]; // counter-clockwise round a
  } while (at != first);
  return -1;
}

bool SphereTriangulation::constrain(int32_t a, int32_t b) {
  progress_.tick(0, 1);
  const auto fix = [&](int32_t t, int k) {
    t_[t].fixed[k] = t_[t_[t].neighbor[k]].fixed[mirror(t, k)] = 1;
    return true;
  };
  int side = 0;
  if (const int32_t t = find(a, b, side); t >= 0) return fix(t, side);
  // The edges between, as pairs of vertices: right and left of the way.
  std::vector<std::array<int32_t, 2>> crossed;
  int32_t at = of_[a], found = -1;
  const int32_t first = at;
  do {
    const Triangle &t = t_[at];
    const int i = index(t, a);
    const int32_t x = t.vertex[next(i)], y = t.vertex[last(i)];
    if (turn(a, x, b) > 0 && turn(a, b, y) > 0) found = at;
    at = t.neighbor[next(i)];
  } while (at != first && found < 0);
  if (found < 0) return false;
  int k = index(t_[found], a);
  for (at = found;;) {
    const Triangle &t = t_[at];
    if (t.fixed[k] || crossed.size() > 3 * t_.size()) return false;
    const int32_t right = t.vertex[next(k)], left = t.vertex[last(k)];
    crossed.push_back({right, left});
    const int m = mirror(at, k);
    at = t.neighbor[k];
    const int32_t z = t_[at].vertex[m];
    if (z == b) break;
    const int s = turn(a, b, z);
    if (s == 0) return false;
    // On: through the side between z and the end that is across.
    k = s > 0 ? index(t_[at], left) : index(t_[at], right);
  }
  // Every edge between is flipped where that can be done, until none crosses.
  std::size_t waits = 0, head = 0;
  while (head < crossed.size()) {
    const auto [x, y] = crossed[head++];
    const int32_t t = find(x, y, side);
    if (t < 0) return false;
    if (!is_convex(t, side)) {
      crossed.push_back({x, y});
      if (++waits > 4 * crossed.size() + 1000) return false;
      continue;
    }
    const int32_t u = t_[t].neighbor[side];
    const int32_t c = t_[t].vertex[side], d = t_[u].vertex[mirror(t, side)];
    flip(t, side);
    waits = 0;
    if (c == a || c == b || d == a || d == b) continue;
    const int sc = turn(a, b, c), sd = turn(a, b, d);
    if (sc == sd) continue;
    crossed.push_back(sc < 0 ? std::array<int32_t, 2>{c, d} : std::array<int32_t, 2>{d, c});
  }
  const int32_t t = find(a, b, side);
  return t >= 0 && fix(t, side);
}

} // namespace vbm::impl
