// SPDX-License-Identifier: GPL-3.0-or-later
// Union-find after Tarjan, with path halving; the smallest member names its set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace vbm::impl {

class DisjointSets {
public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int32_t find(int32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Whether they were in different sets.
  bool unite(int32_t i, int32_t j) {
    i = find(i), j = find(j);
    if (i > j) std::swap(i, j);
    parent_[j] = i;
    return i != j;
  }
  /// One more member, in a set of its own.
  int32_t add() {
    parent_.push_back(int32_t(parent_.size()));
    return parent_.back();
  }
  /// Number of every member's set, counted from 0 in the order of their smallest members.
  std::vector<int32_t> numbers(std::size_t &sets) {
    std::vector<int32_t> number(parent_.size());
    int32_t next = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) {
      const int32_t root = find(static_cast<int32_t>(i));
      number[i] = root == static_cast<int32_t>(i) ? next++ : number[root];
    }
    sets = static_cast<std::size_t>(next);
    return number;
  }

private:
  std::vector<int32_t> parent_;
};

} // namespace vbm::impl
