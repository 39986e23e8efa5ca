// SPDX-License-Identifier: GPL-3.0-or-later
// The signed distance from p to what a ball sweeps is the least of |p - c| - r over the mixtures
// (c, r) of the primitive's balls. That is convex, so it is least where its derivative vanishes or
// on the border: on a triangle where p's tangent plane touches, on an edge where the cone's
// generator does (the cones of Thiery et al., "Sphere-meshes", and the slabs of Li et al., "Q-MAT",
// in closed form). Primitives are found by a bounding volume hierarchy over their centres.
#include "medial/envelope.h"

#include "core/progress.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vbm::impl {
namespace {

constexpr int32_t kLeaf = 4; // primitives

/// Ratio of a triangle's doubled area to its longest edge squared, below which its plane is noise
/// and its edges tell all.
constexpr double kFlatTriangle = 1e-10;

} // namespace

Envelope::Envelope(const BallComplex &complex, Progress &progress) : complex_(complex) {
  std::vector<uint8_t> used(complex.ball.size(), 0);
  primitive_.reserve(complex.primitives());
  for (const auto &t : complex.triangle) {
    add({t[0], t[1], t[2]});
    for (int32_t v : t) used[v] = 1;
  }
  for (const auto &e : complex.edge) {
    add({e[0], e[1], -1});
    for (int32_t v : e) used[v] = 1;
  }
  for (std::size_t v = 0; v < used.size(); ++v)
    if (!used[v]) add({int32_t(v), -1, -1});
  share_edges();
  build(progress);
}

/// Where the least of several triangles is on an edge they share, it is the least of each of them:
/// one is enough to find it.
void Envelope::share_edges() {
  struct Edge {
    int32_t low, high, triangle;
    int place;
    bool operator<(const Edge &o) const {
      return low != o.low ? low < o.low : high != o.high ? high < o.high : triangle < o.triangle;
    }
  };
  std::vector<Edge> edges;
  edges.reserve(3 * slab_.size());
  for (std::size_t t = 0; t < slab_.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(primitive_[t][i], primitive_[t][(i + 1) % 3]);
      edges.push_back({low, high, int32_t(t), i});
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t k = 0; k < edges.size(); ++k)
    if (k == 0 || edges[k].low != edges[k - 1].low || edges[k].high != edges[k - 1].high)
      slab_[edges[k].triangle].edges |= uint8_t(1 << edges[k].place);
}

void Envelope::add(const Primitive &primitive) {
  primitive_.push_back(primitive);
  if (primitive[2] < 0) return;
  slab_.emplace_back();
  Slab &slab = slab_.back();
  const Ball &a = complex_.ball[primitive[0]], &b = complex_.ball[primitive[1]],
             &c = complex_.ball[primitive[2]];
  const Vec3 u = b.center - a.center, v = c.center - a.center, n = cross(u, v);
  const double area = length(n), longest = std::max({dot(u, u), dot(v, v), dot(u - v, u - v)});
  if (!(area > kFlatTriangle * longest)) return;
  slab.normal = n * (1 / area);
  slab.to_b = cross(v, slab.normal) * (1 / area);
  slab.to_c = cross(slab.normal, u) * (1 / area);
  slab.gradient = slab.to_b * (b.radius - a.radius) + slab.to_c * (c.radius - a.radius);
  const double g2 = dot(slab.gradient, slab.gradient);
  if (g2 < 1) slab.slope = std::sqrt(1 - g2);
}

void Envelope::build(Progress &progress) {
  const std::size_t count = primitive_.size();
  std::vector<Vec3> middle(count);
  order_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    order_[i] = int32_t(i);
    int n = 0;
    for (int32_t v : primitive_[i])
      if (v >= 0) middle[i] += complex_.ball[v].center, ++n;
    middle[i] = middle[i] * (1.0 / std::max(n, 1));
  }
  if (!count) return;
  // Depth first, the first child right behind its parent.
  struct Task {
    int32_t begin, end, parent; // parent: whose second child this is, or -1
  };
  std::vector<Task> tasks{{0, int32_t(count), -1}};
  while (!tasks.empty()) {
    progress.tick(0, 1);
    const Task task = tasks.back();
    tasks.pop_back();
    const int32_t index = int32_t(node_.size());
    if (task.parent >= 0) node_[task.parent].right = index;
    constexpr double inf = std::numeric_limits<double>::infinity();
    Node node{{inf, inf, inf}, {-inf, -inf, -inf}, 0, task.begin, task.end, -1};
    Vec3 low = node.low, high = node.high; // of middles
    for (int32_t k = task.begin; k < task.end; ++k) {
      for (int a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], middle[order_[k]][a]);
        high[a] = std::max(high[a], middle[order_[k]][a]);
      }
      for (int32_t v : primitive_[order_[k]]) {
        if (v < 0) continue;
        const Ball &ball = complex_.ball[v];
        for (int a = 0; a < 3; ++a) {
          node.low[a] = std::min(node.low[a], ball.center[a]);
          node.high[a] = std::max(node.high[a], ball.center[a]);
        }
        node.radius = std::max(node.radius, ball.radius);
      }
    }
    node_.push_back(node);
    if (task.end - task.begin <= kLeaf) continue;
    int axis = 0;
    for (int a = 1; a < 3; ++a)
      if (high[a] - low[a] > high[axis] - low[axis]) axis = a;
    const int32_t half = task.begin + (task.end - task.begin) / 2;
    std::nth_element(order_.begin() + task.begin, order_.begin() + half, order_.begin() + task.end,
                     [&](int32_t i, int32_t j) {
                       return middle[i][axis] != middle[j][axis] ? middle[i][axis] < middle[j][axis]
                                                                 : i < j;
                     });
    tasks.push_back({half, task.end, index});
    tasks.push_back({task.begin, half, -1});
  }
}

double Envelope::bound(const Node &node, const Vec3 &p) const {
  double d2 = 0;
  for (int a = 0; a < 3; ++a) {
    const double d = std::max({node.low[a] - p[a], p[a] - node.high[a], 0.0});
    d2 += d * d;
  }
  return std::sqrt(d2) - node.radius;
}

void Envelope::test_edge(int32_t primitive, int i, int j, const Vec3 &p, EnvelopeHit &best) const {
  const Ball &a = complex_.ball[primitive_[primitive][i]],
             &b = complex_.ball[primitive_[primitive][j]];
  const Vec3 u = b.center - a.center, q = p - a.center;
  const double u2 = dot(u, u), dr = b.radius - a.radius;
  // Nearer than the axis's whole line less the larger radius it is not.
  const double most = best.distance + std::max(a.radius, b.radius), along_u = dot(q, u);
  if (most <= 0 || dot(q, q) * u2 - along_u * along_u > most * most * u2) return;
  double t = dr > 0 ? 1 : 0; // one ball holds the other
  if (u2 > dr * dr) {
    const double along = along_u / u2;
    const double aside = std::sqrt(std::max(0.0, dot(q, q) - along * along * u2));
    t = std::clamp(along + aside * dr / std::sqrt((u2 - dr * dr) * u2), 0.0, 1.0);
  }
  const double d = length(q - u * t) - (a.radius + dr * t);
  if (!(d < best.distance)) return;
  best.distance = d;
  best.primitive = primitive;
  best.weight = {};
  best.weight[i] = 1 - t;
  best.weight[j] = t;
}

void Envelope::test(int32_t primitive, const Vec3 &p, EnvelopeHit &best) const {
  const Primitive &balls = primitive_[primitive];
  if (balls[1] < 0) {
    const Ball &a = complex_.ball[balls[0]];
    const double d = distance(p, a.center) - a.radius;
    if (d < best.distance) best = {d, primitive, {1, 0, 0}};
    return;
  }
  if (balls[2] < 0) return test_edge(primitive, 0, 1, p, best);
  const Slab &slab = slab_[primitive];
  if (slab.slope <= 1) {
    const Ball &a = complex_.ball[balls[0]];
    const Vec3 q = p - a.center;
    const double side = dot(q, slab.normal), height = std::fabs(side);
    const double least = height * slab.slope - a.radius - dot(slab.gradient, q);
    if (!(least < best.distance)) return; // nowhere on the triangle's plane is it less
    const Vec3 foot =
        q - slab.normal * side + slab.gradient * (slab.slope > 0 ? height / slab.slope : 0);
    const double wb = dot(foot, slab.to_b), wc = dot(foot, slab.to_c);
    if (wb >= 0 && wc >= 0 && wb + wc <= 1) {
      best = {least, primitive, {1 - wb - wc, wb, wc}};
      return;
    }
    // The distance is convex over the plane: the least of the triangle is on an edge that the least
    // of the plane is beyond.
    const bool beyond_ab = wc < 0, beyond_ca = wb < 0;
    const bool beyond_bc = wb + wc > 1;
    if (beyond_ab || beyond_bc || beyond_ca) {
      if (beyond_ab && (slab.edges & 1)) test_edge(primitive, 0, 1, p, best);
      if (beyond_bc && (slab.edges & 2)) test_edge(primitive, 1, 2, p, best);
      if (beyond_ca && (slab.edges & 4)) test_edge(primitive, 2, 0, p, best);
      return;
    }
  }
  for (int i = 0; i < 3; ++i)
    if (slab.edges >> i & 1) test_edge(primitive, i, (i + 1) % 3, p, best);
}

EnvelopeHit Envelope::nearest(const Vec3 &p, int32_t likely) const {
  EnvelopeHit best;
  best.distance = std::numeric_limits<double>::infinity();
  if (node_.empty()) return best;
  if (likely >= 0) test(likely, p, best);
  struct Entry {
    int32_t node;
    double bound;
  };
  Entry stack[64]; // halving 2^31 primitives takes 31 levels, each of which leaves one behind
  int top = 0;
  stack[top++] = {0, bound(node_[0], p)};
  while (top) {
    const Entry entry = stack[--top];
    if (entry.bound >= best.distance) continue;
    const Node &node = node_[entry.node];
    if (node.right < 0) {
      for (int32_t k = node.begin; k < node.end; ++k) test(order_[k], p, best);
      continue;
    }
    Entry near{entry.node + 1, bound(node_[entry.node + 1], p)},
        far{node.right, bound(node_[node.right], p)};
    if (far.bound < near.bound) std::swap(near, far);
    stack[top++] = far;
    stack[top++] = near;
  }
  return best;
}

bool Envelope::covers(const Vec3 &p, double depth) const {
  if (node_.empty()) return false;
  int32_t stack[64];
  int top = 0;
  stack[top++] = 0;
  EnvelopeHit best;
  best.distance = -depth;
  while (top) {
    const int32_t index = stack[--top];
    const Node &node = node_[index];
    if (bound(node, p) >= -depth) continue;
    if (node.right < 0) {
      for (int32_t k = node.begin; k < node.end; ++k) {
        test(order_[k], p, best);
        if (best.primitive >= 0) return true;
      }
      continue;
    }
    stack[top++] = node.right;
    stack[top++] = index + 1;
  }
  return false;
}

Ball Envelope::at(const EnvelopeHit &hit) const {
  Ball out;
  for (int i = 0; i < 3; ++i) {
    const int32_t v = primitive_[hit.primitive][i];
    if (v < 0) continue;
    out.center += complex_.ball[v].center * hit.weight[i];
    out.radius += complex_.ball[v].radius * hit.weight[i];
  }
  return out;
}

} // namespace vbm::impl
