// SPDX-License-Identifier: GPL-3.0-or-later
// A bounding volume hierarchy over the sites, halved at the middle of the longest side. A spacing
// with a bounded slope is what graded meshes have (Ruppert, "A Delaunay refinement algorithm for
// quality 2-dimensional mesh generation", 1995).
#include "sampling/spacing_field.h"

#include "sampling/tolerances.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

constexpr std::size_t kLeaf = 8; // sites

double wanted(double spacing, double reach, double distance) {
  return spacing + kSpacingGrowth * std::max(0.0, distance - reach);
}

double distance_to_box(const Vec3 &low, const Vec3 &high, const Vec3 &p) {
  double sum = 0;
  for (int a = 0; a < 3; ++a) {
    const double d = std::max({low[a] - p[a], 0.0, p[a] - high[a]});
    sum += d * d;
  }
  return std::sqrt(sum);
}

} // namespace

SpacingField::SpacingField(double most, std::vector<SpacingSite> sites)
    : most_(most), least_(most), site_(std::move(sites)) {
  if (!site_.empty()) add_node(0, site_.size());
  if (!site_.empty()) least_ = std::min(most, node_[0].spacing);
}

int32_t SpacingField::add_node(std::size_t begin, std::size_t end) {
  const auto number = static_cast<int32_t>(node_.size());
  const SpacingSite &first = site_[begin];
  Node node{first.at, first.at, first.spacing, first.reach, begin, end, -1};
  for (std::size_t i = begin; i < end; ++i) {
    const SpacingSite &s = site_[i];
    for (int a = 0; a < 3; ++a) {
      node.low[a] = std::min(node.low[a], s.at[a]);
      node.high[a] = std::max(node.high[a], s.at[a]);
    }
    node.spacing = std::min(node.spacing, s.spacing);
    node.reach = std::max(node.reach, s.reach);
  }
  node_.push_back(node);
  if (end - begin <= kLeaf) return number;
  int axis = 0;
  for (int a = 1; a < 3; ++a)
    if (node.high[a] - node.low[a] > node.high[axis] - node.low[axis]) axis = a;
  const std::size_t middle = begin + (end - begin) / 2;
  std::nth_element(
      site_.begin() + begin, site_.begin() + middle, site_.begin() + end,
      [&](const SpacingSite &s, const SpacingSite &t) { return s.at[axis] < t.at[axis]; });
  add_node(begin, middle);
  const int32_t right = add_node(middle, end);
  node_[number].right = right;
  return number;
}

double SpacingField::at(const Vec3 &p) const {
  double best = most_;
  if (node_.empty()) return best;
  struct Entry {
    int32_t node;
    double bound;
  };
  const auto bound = [&](int32_t n) {
    const Node &node = node_[n];
    return wanted(node.spacing, node.reach, distance_to_box(node.low, node.high, p));
  };
  Entry stack[128]; // the tree is halved: it has no more levels than an index has bits
  int size = 0;
  stack[size++] = {0, bound(0)};
  while (size) {
    const Entry entry = stack[--size];
    if (!(entry.bound < best)) continue;
    const Node &node = node_[entry.node];
    if (node.right < 0) {
      for (std::size_t i = node.begin; i < node.end; ++i)
        best = std::min(best, wanted(site_[i].spacing, site_[i].reach, distance(site_[i].at, p)));
      continue;
    }
    Entry near{entry.node + 1, bound(entry.node + 1)}, far{node.right, bound(node.right)};
    if (far.bound < near.bound) std::swap(near, far);
    stack[size++] = far;
    stack[size++] = near;
  }
  return best;
}

} // namespace vbm::impl
