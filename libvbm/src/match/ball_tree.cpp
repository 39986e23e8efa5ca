// SPDX-License-Identifier: GPL-3.0-or-later
// Friedman, Bentley, Finkel, "An algorithm for finding best matches in logarithmic expected time"
// (1977), with the radius as a fourth coordinate: a box of centres and the smallest and largest
// radius in it bound the distance to a ball's near and far side, and small balls beside large ones
// are told apart.
#include "match/ball_tree.h"

#include "core/progress.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vbm::impl {
namespace {

constexpr int32_t kLeaf = 8;   // balls in a leaf: about as much work as one more level of boxes
constexpr int kMaxStack = 128; // two nodes a level, and a level halves the balls

/// Balls from which on coordinates are copied before they are compared.
constexpr int32_t kMany = 10000;

double coordinate(const Ball &ball, int axis) { return axis < 3 ? ball.center[axis] : ball.radius; }

} // namespace

BallTree::BallTree(const std::vector<Ball> &balls, Progress &progress)
    : balls_(balls), order_(balls.size()), place_(balls.size()), gone_(balls.size(), 0) {
  const int32_t count = int32_t(balls.size());
  for (int32_t i = 0; i < count; ++i) order_[i] = i;
  nodes_.reserve(std::size_t(count) / 2 + 1);
  if (count) nodes_.push_back({{}, {}, 0, 0, 0, count, 0, count});
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (n < 64)
      progress.tick_slow(n, std::size_t(count) / 4 + 1); // large ones
    else
      progress.tick(n, std::size_t(count) / 4 + 1);
    split(int32_t(n), progress);
  }
  for (int32_t i = 0; i < count; ++i) place_[order_[i]] = i;
  for (int32_t i = 0; i < count; ++i) balls_[i] = balls[order_[i]];
}

void BallTree::split(int32_t index, Progress &progress) {
  Node node = nodes_[index];
  double low[4], high[4];
  for (int axis = 0; axis < 4; ++axis) {
    low[axis] = std::numeric_limits<double>::infinity(), high[axis] = -low[axis];
    for (int32_t i = node.begin; i < node.end; ++i) {
      low[axis] = std::min(low[axis], coordinate(balls_[order_[i]], axis));
      high[axis] = std::max(high[axis], coordinate(balls_[order_[i]], axis));
    }
  }
  node.low = {low[0], low[1], low[2]}, node.high = {high[0], high[1], high[2]};
  node.smallest = low[3], node.largest = high[3];
  if (node.end - node.begin > kLeaf) {
    int widest = 0;
    for (int axis = 1; axis < 4; ++axis)
      if (high[axis] - low[axis] > high[widest] - low[widest]) widest = axis;
    const int32_t middle = node.begin + (node.end - node.begin) / 2;
    select(node.begin, middle, node.end, widest, progress);
    node.left = int32_t(nodes_.size());
    nodes_.push_back({{}, {}, 0, 0, node.begin, middle, 0, middle - node.begin});
    nodes_.push_back({{}, {}, 0, 0, middle, node.end, 0, node.end - middle});
  }
  nodes_[index] = node;
}

/// nth_element by a coordinate, then by number.
void BallTree::select(int32_t begin, int32_t middle, int32_t end, int axis, Progress &progress) {
  if (end - begin < kMany) {
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](int32_t a, int32_t b) {
                       const double ca = coordinate(balls_[a], axis),
                                    cb = coordinate(balls_[b], axis);
                       return ca != cb ? ca < cb : a < b;
                     });
    return;
  }
  progress.tick_slow(0, 1);
  std::vector<std::pair<double, int32_t>> key;
  key.reserve(std::size_t(end - begin));
  for (int32_t i = begin; i < end; ++i)
    key.emplace_back(coordinate(balls_[order_[i]], axis), order_[i]);
  progress.tick_slow(0, 1);
  std::nth_element(key.begin(), key.begin() + (middle - begin), key.end());
  for (int32_t i = begin; i < end; ++i) order_[i] = key[i - begin].second;
}

void BallTree::remove(int32_t ball) {
  const int32_t place = place_[ball];
  if (gone_[place]) return;
  gone_[place] = 1;
  for (int32_t n = 0;;) {
    Node &node = nodes_[n];
    --node.alive;
    if (!node.left) return;
    n = place < nodes_[node.left].end ? node.left : node.left + 1;
  }
}

double BallTree::nearest(const Node &node, const Vec3 &p) const {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = std::max({node.low[axis] - p[axis], p[axis] - node.high[axis], 0.0});
    sum += d * d;
  }
  return std::sqrt(sum);
}

void BallTree::inside(const Vec3 &center, double radius, std::vector<int32_t> &found) const {
  if (nodes_.empty()) return;
  int32_t stack[kMaxStack], top = 0;
  stack[top++] = 0;
  while (top) {
    const Node &node = nodes_[stack[--top]];
    if (!node.alive || nearest(node, center) + node.smallest > radius) continue;
    if (node.left) {
      stack[top++] = node.left + 1;
      stack[top++] = node.left;
      continue;
    }
    for (int32_t i = node.begin; i < node.end; ++i)
      if (!gone_[i] && distance(balls_[i].center, center) + balls_[i].radius <= radius)
        found.push_back(order_[i]);
  }
}

double BallTree::to_union(const Vec3 &point, double limit, int32_t *ball) const {
  constexpr double inf = std::numeric_limits<double>::infinity();
  struct Entry {
    int32_t node;
    double bound;
  } stack[kMaxStack];
  int top = 0;
  double best = limit;
  bool any = false;
  if (!nodes_.empty()) stack[top++] = {0, -inf};
  while (top) {
    const Entry entry = stack[--top];
    if (any ? entry.bound >= best : entry.bound > best) continue;
    const Node &node = nodes_[entry.node];
    if (!node.alive) continue;
    if (node.left) {
      const Node &l = nodes_[node.left], &r = nodes_[node.left + 1];
      const double dl = nearest(l, point) - l.largest, dr = nearest(r, point) - r.largest;
      const bool left_first = dl <= dr; // the nearer one is searched first
      stack[top++] = {node.left + (left_first ? 1 : 0), left_first ? dr : dl};
      stack[top++] = {node.left + (left_first ? 0 : 1), left_first ? dl : dr};
      continue;
    }
    for (int32_t i = node.begin; i < node.end; ++i) {
      if (gone_[i]) continue;
      const double d = distance(balls_[i].center, point) - balls_[i].radius;
      if (d > best || (d == best && any)) continue;
      best = d, any = true;
      if (ball) *ball = order_[i];
    }
  }
  return any ? best : inf;
}

} // namespace vbm::impl
