// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices of a boundary, of which some become one.
#pragma once

#include "core/disjoint_sets.h"
#include "core/vec3.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace vbm::impl {

class MergedPoints {
public:
  /// Singular points, and the sample of each, or -1: samples keep their places.
  MergedPoints(std::vector<Vec3> position, std::vector<double> blur, std::vector<int32_t> sample)
      : sets_(position.size()), position_(std::move(position)), blur_(std::move(blur)),
        reach_(position_.size(), 0), sample_(std::move(sample)), fixed_(position_.size(), 0),
        singular_(position_.size()) {}

  std::size_t size() const { return position_.size(); }
  /// What names all that became one with a vertex; the others take such names.
  int32_t find(int32_t v) { return sets_.find(v); }
  const Vec3 &at(int32_t v) const { return position_[v]; }
  int32_t sample(int32_t v) const { return sample_[v]; }
  bool has_samples() const {
    return std::any_of(sample_.begin(), sample_.end(), [](int32_t s) { return s >= 0; });
  }

  /// This vertex keeps its place from here on; what becomes one with it comes there.
  void fix(int32_t v) { fixed_[v] = 1; }
  bool stays(int32_t v) const { return sample_[v] >= 0 || fixed_[v] != 0; }
  /// How far from its place the farthest of the points is that became this vertex.
  double moved(int32_t v) const { return reach_[v]; }
  /// How far from its place the farthest of two vertices that become one would be.
  double reach_of(int32_t u, int32_t v) const {
    const bool keep_u = rank(u) != rank(v) ? rank(u) > rank(v) : reach_[u] >= reach_[v];
    const int32_t kept = keep_u ? u : v, moved = keep_u ? v : u;
    return std::max(reach_[kept], distance(position_[u], position_[v]) + reach_[moved]);
  }

  void unite(int32_t u, int32_t v) { unite(u, v, reach_of(u, v)); }
  /// The same, where reach_of() is known.
  void unite(int32_t u, int32_t v, double reach) {
    bool keep_u = u < v;
    if (rank(u) != rank(v))
      keep_u = rank(u) > rank(v);
    else if (reach_[u] != reach_[v])
      keep_u = reach_[u] > reach_[v];
    else if (blur_[u] != blur_[v])
      keep_u = blur_[u] < blur_[v];
    const int32_t kept = keep_u ? u : v, name = std::min(u, v);
    sets_.unite(u, v);
    position_[name] = position_[kept];
    blur_[name] = blur_[kept];
    sample_[name] = sample_[kept];
    reach_[name] = reach;
    fixed_[name] = fixed_[u] | fixed_[v];
  }

  /// One more vertex, which is within an arc.
  int32_t add(const Vec3 &p) {
    position_.push_back(p);
    blur_.push_back(0);
    reach_.push_back(0);
    sample_.push_back(-1);
    fixed_.push_back(0);
    return sets_.add();
  }

private:
  /// Samples keep their places, and what is fixed, then points where three balls meet.
  int rank(int32_t v) const { return stays(v) ? 2 : std::size_t(v) < singular_ ? 1 : 0; }

  DisjointSets sets_;
  std::vector<Vec3> position_; // by vertex, valid for those that name their sets
  std::vector<double> blur_, reach_;
  std::vector<int32_t> sample_;
  std::vector<uint8_t> fixed_;
  std::size_t singular_;
};

} // namespace vbm::impl
