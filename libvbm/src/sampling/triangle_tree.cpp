// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles are sorted along a Morton curve and every four make a leaf, every two nodes a
// parent, as in Lauterbach et al., "Fast BVH construction on GPUs" (2009), but without its splits:
// the tree is complete, so a node needs no more than its box. Rays are tested as in Woop, Benthin
// and Wald, "Watertight ray/triangle intersection" (2013): the points are sheared so that the ray
// runs along an axis, and an edge's sign is computed from the same numbers for both its faces, so
// that a ray never slips between them. Where a sign is zero another ray is taken. Nearest points:
// Ericson, "Real-time collision detection" (2005), 5.1.5.
#include "sampling/triangle_tree.h"

#include "core/progress.h"
#include "sampling/face_normals.h"
#include "sampling/tolerances.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vbm::impl {
namespace {

uint64_t spread_bits(uint64_t v) { // 14 bits to every third bit
  v = (v | v << 16) & 0x1f0000ff0000ffu;
  v = (v | v << 8) & 0x100f00f00f00f00fu;
  v = (v | v << 4) & 0x10c30c30c30c30c3u;
  return (v | v << 2) & 0x1249249249249249u;
}

uint64_t morton(const Vec3 &p) { // p in [-1, 1]
  uint64_t code = 0;
  for (int a = 0; a < 3; ++a) {
    const double cell = std::clamp((p[a] + 1) * 0.5 * 16384.0, 0.0, 16383.0);
    code |= spread_bits(static_cast<uint64_t>(cell)) << a;
  }
  return code;
}

struct Keyed {
  uint64_t key;
  int32_t triangle;
};

/// Stable counting sort, eleven bits at a time.
void radix_sort(std::vector<Keyed> &items, Progress &progress) {
  std::vector<Keyed> other(items.size());
  for (int shift = 0; shift < 42; shift += 11) {
    progress.tick_slow(0, 1);
    std::size_t begin[2049] = {};
    for (const Keyed &i : items) ++begin[(i.key >> shift & 2047) + 1];
    for (int b = 0; b < 2048; ++b) begin[b + 1] += begin[b];
    for (const Keyed &i : items) other[begin[i.key >> shift & 2047]++] = i;
    items.swap(other);
  }
}

/// The nearest point of triangle abc to p.
Vec3 nearest_on(const Vec3 &p, const Vec3 &a, const Vec3 &b, const Vec3 &c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Vec3 bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 > d3 ? d1 / (d1 - d3) : 0);
  const Vec3 cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 > d6 ? d2 / (d2 - d6) : 0);
  const double va = d3 * d6 - d5 * d4;
  const double bc = (d4 - d3) + (d5 - d6);
  if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (c - b) * (bc > 0 ? (d4 - d3) / bc : 0);
  const double area = va + vb + vc;
  if (!(area > 0)) return a; // no area, and the edges did not take it
  return a + ab * (vb / area) + ac * (vc / area);
}

/// A ray and the shear that lays it along its longest axis.
struct Ray {
  Vec3 origin, direction, inverse;
  int kx, ky, kz;
  double sx, sy;

  Ray(const Vec3 &origin, const Vec3 &d) : origin(origin), direction(d) {
    inverse = {1 / d.x, 1 / d.y, 1 / d.z};
    kz = 0;
    for (int a = 1; a < 3; ++a)
      if (std::fabs(d[a]) > std::fabs(d[kz])) kz = a;
    kx = (kz + 1) % 3, ky = (kz + 2) % 3;
    if (d[kz] < 0) std::swap(kx, ky); // keeps the direction of turning
    sx = d[kx] / d[kz], sy = d[ky] / d[kz];
  }
  Vec3 sheared(const Vec3 &p) const {
    const Vec3 q = p - origin;
    return {q[kx] - sx * q[kz], q[ky] - sy * q[kz], q[kz] / direction[kz]};
  }
};

/// On which side of the edge from p to q (named i and j) the ray is, from the same operations in
/// the same order for either direction of the edge.
double side_of(const Vec3 &p, int32_t i, const Vec3 &q, int32_t j) {
  if (i < j) return p.x * q.y - p.y * q.x;
  return -(q.x * p.y - q.y * p.x);
}

enum class Hit { miss, front, back, unclear };

Hit hit(const Ray &ray, const Triangle &t, const std::vector<Vec3> &position) {
  const Vec3 a = ray.sheared(position[t[0]]), b = ray.sheared(position[t[1]]),
             c = ray.sheared(position[t[2]]);
  if (a.z < 0 && b.z < 0 && c.z < 0) return Hit::miss;
  const double u = side_of(b, t[1], c, t[2]), v = side_of(c, t[2], a, t[0]),
               w = side_of(a, t[0], b, t[1]);
  const bool any_negative = u < 0 || v < 0 || w<0, any_positive = u> 0 || v > 0 || w > 0;
  if (any_negative && any_positive) return Hit::miss;
  if (u == 0 || v == 0 || w == 0) return Hit::unclear; // through an edge, or edge-on
  const double depth = (u * a.z + v * b.z + w * c.z) / (u + v + w);
  const double size = std::max({std::fabs(a.z), std::fabs(b.z), std::fabs(c.z)});
  if (std::fabs(depth) <= 1e-15 * size) return Hit::unclear; // starts on the triangle
  if (depth < 0) return Hit::miss;
  return u > 0 ? Hit::back : Hit::front;
}

/// Directions without symmetry, so that faces of no usual shape are met edge-on twice.
constexpr Vec3 kDirections[] = {{0.61237, 0.35211, 0.70779},   {-0.43817, 0.80453, 0.40091},
                                {0.27301, -0.54919, 0.78983},  {-0.69437, -0.61169, -0.37907},
                                {0.93151, -0.21713, -0.29179}, {-0.13267, 0.39119, -0.91073},
                                {0.50221, 0.82963, -0.24407},  {-0.88007, 0.15331, 0.44939}};

} // namespace

TriangleTree::TriangleTree(std::vector<Vec3> position, const std::vector<Triangle> &triangles,
                           const std::vector<uint8_t> &use, Progress &progress)
    : position_(std::move(position)) {
  std::vector<Keyed> order(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if ((t & 1023) == 0) progress.tick(0, 1);
    const Triangle &v = triangles[t];
    const Vec3 middle = (position_[v[0]] + position_[v[1]] + position_[v[2]]) * (1.0 / 3);
    order[t] = {morton(middle), static_cast<int32_t>(t)};
  }
  radix_sort(order, progress);
  triangle_.reserve(triangles.size());
  for (const Keyed &k : order) triangle_.push_back(triangles[k.triangle]);
  if (!use.empty())
    for (const Keyed &k : order) use_.push_back(use[k.triangle]);

  std::size_t nodes = (triangle_.size() + kLeaf - 1) / kLeaf;
  level_begin_.push_back(0);
  progress.tick_slow(0, 1);
  for (std::size_t l = 0; l < nodes; ++l) {
    if ((l & 1023) == 0) progress.tick(0, 1);
    box_.push_back(box_of_leaf(l));
  }
  level_begin_.push_back(box_.size());
  while (nodes > 1) {
    const std::size_t first = level_begin_[level_begin_.size() - 2];
    for (std::size_t n = 0; n < nodes; n += 2) {
      Box box = box_[first + n];
      if (n + 1 < nodes) {
        const Box &other = box_[first + n + 1];
        for (int a = 0; a < 3; ++a) {
          box.low[a] = std::min(box.low[a], other.low[a]);
          box.high[a] = std::max(box.high[a], other.high[a]);
        }
      }
      box_.push_back(box);
    }
    nodes = (nodes + 1) / 2;
    level_begin_.push_back(box_.size());
  }
}

TriangleTree::Box TriangleTree::box_of_leaf(std::size_t leaf) const {
  constexpr float inf = std::numeric_limits<float>::infinity();
  Box box;
  for (int a = 0; a < 3; ++a) {
    double low = inf, high = -inf;
    const std::size_t end = std::min(triangle_.size(), (leaf + 1) * kLeaf);
    for (std::size_t t = leaf * kLeaf; t < end; ++t)
      for (int32_t v : triangle_[t]) {
        low = std::min(low, position_[v][a]);
        high = std::max(high, position_[v][a]);
      }
    box.low[a] = std::nextafter(static_cast<float>(low - kBoxSlack), -inf);
    box.high[a] = std::nextafter(static_cast<float>(high + kBoxSlack), inf);
  }
  return box;
}

/// Depth-first, the first child first: accept(box) says whether to look inside, leaf(triangle)
/// whether to go on at all.
template <class Accept, class Leaf> void TriangleTree::descend(Accept accept, Leaf leaf) const {
  if (triangle_.empty()) return;
  struct Node {
    std::size_t level, index;
  };
  Node stack[128];
  int size = 0;
  stack[size++] = {level_begin_.size() - 2, 0};
  while (size) {
    const Node node = stack[--size];
    if (!accept(box_[level_begin_[node.level] + node.index])) continue;
    if (node.level == 0) {
      const std::size_t end = std::min(triangle_.size(), (node.index + 1) * kLeaf);
      for (std::size_t t = node.index * kLeaf; t < end; ++t)
        if (!leaf(t)) return;
      continue;
    }
    const std::size_t below = node.level - 1, first = 2 * node.index;
    const std::size_t count = level_begin_[below + 1] - level_begin_[below];
    if (first + 1 < count) stack[size++] = {below, first + 1};
    stack[size++] = {below, first};
  }
}

bool TriangleTree::winding_number(const Vec3 &p, int &number) const {
  for (const Vec3 &direction : kDirections) {
    const Ray ray(p, direction);
    bool clear = true;
    number = 0;
    descend(
        [&](const Box &box) {
          double enter = 0, leave = HUGE_VAL;
          for (int a = 0; a < 3; ++a) {
            const double s = (box.low[a] - p[a]) * ray.inverse[a];
            const double t = (box.high[a] - p[a]) * ray.inverse[a];
            enter = std::max(enter, std::min(s, t));
            leave = std::min(leave, std::max(s, t));
          }
          return enter <= leave * (1 + 1e-12) + kBoxSlack;
        },
        [&](std::size_t t) {
          if (!counts(t, winding)) return true;
          const Hit h = hit(ray, triangle_[t], position_);
          clear = h != Hit::unclear;
          number += h == Hit::back ? 1 : h == Hit::front ? -1 : 0;
          return clear;
        });
    if (clear) return true;
  }
  return false;
}

double TriangleTree::distance2(const Box &box, const Vec3 &p) const {
  double sum = 0;
  for (int a = 0; a < 3; ++a) {
    const double d = std::max({box.low[a] - p[a], 0.0, p[a] - box.high[a]});
    sum += d * d;
  }
  return sum;
}

bool TriangleTree::nearest(const Vec3 &p, Nearest &found) const {
  double best2 = found.distance * found.distance;
  found.triangle = -1;
  if (triangle_.empty()) return false;
  struct Node {
    std::size_t level, index;
    double distance2;
  };
  Node stack[128];
  int size = 0;
  stack[size++] = {level_begin_.size() - 2, 0, distance2(box_.back(), p)};
  while (size) {
    const Node node = stack[--size];
    if (!(node.distance2 < best2)) continue;
    if (node.level == 0) {
      const std::size_t end = std::min(triangle_.size(), (node.index + 1) * kLeaf);
      for (std::size_t t = node.index * kLeaf; t < end; ++t) {
        if (!counts(t, surface)) continue;
        const Triangle &v = triangle_[t];
        const Vec3 q = nearest_on(p, position_[v[0]], position_[v[1]], position_[v[2]]);
        const double d2 = dot(q - p, q - p);
        if (d2 < best2) best2 = d2, found.point = q, found.triangle = static_cast<int32_t>(t);
      }
      continue;
    }
    const std::size_t below = node.level - 1, first = 2 * node.index;
    const std::size_t count = level_begin_[below + 1] - level_begin_[below];
    Node near{below, first, distance2(box_[level_begin_[below] + first], p)};
    if (first + 1 < count) {
      Node far{below, first + 1, distance2(box_[level_begin_[below] + first + 1], p)};
      if (far.distance2 < near.distance2) std::swap(near, far);
      stack[size++] = far;
    }
    stack[size++] = near;
  }
  found.distance = std::sqrt(best2);
  return found.triangle >= 0;
}

Vec3 TriangleTree::normal_at(const Vec3 &point) const {
  const double touching2 = kTouching * kTouching;
  Vec3 sum;
  descend([&](const Box &box) { return distance2(box, point) <= touching2; },
          [&](std::size_t i) {
            if (!counts(i, surface)) return true;
            const Triangle &t = triangle_[i];
            const Vec3 a = position_[t[0]], b = position_[t[1]], c = position_[t[2]];
            const Vec3 q = nearest_on(point, a, b, c) - point;
            if (dot(q, q) > touching2) return true;
            double angle = 2 * kPi; // inside the face; all angles in it count equal then
            for (int k = 0; k < 3; ++k) {
              const Vec3 p = position_[t[k]], edge = position_[t[(k + 1) % 3]] - p;
              if (length(cross(edge, point - p)) <= kTouching * length(edge)) angle = kPi;
            }
            for (int k = 0; k < 3; ++k)
              if (distance(position_[t[k]], point) <= kTouching)
                angle = corner_angle(t, k, position_);
            sum += unit(cross(b - a, c - a)) * angle;
            return true;
          });
  return length(sum) > kOppositeNormals ? unit(sum) : Vec3{};
}

} // namespace vbm::impl
