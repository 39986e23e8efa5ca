// SPDX-License-Identifier: GPL-3.0-or-later
// The dual of a triangulated solid has its interior's homotopy type (as the nerve of the open stars
// of tetrahedra, facets, edges and vertices that lie inside). Tetrahedra on one sphere form a
// convex polytope, which is contracted to one vertex; where rounding or the labels' repair left a
// group that is not contractible, its tetrahedra stay apart. Facets between the same two groups
// form a plane polygon, which is contracted to one edge.
#include "medial/dual_complex.h"

#include "balls/circumcenter.h"
#include "core/disjoint_sets.h"
#include "core/prefetch.h"
#include "core/progress.h"
#include "medial/pinches.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace vbm::impl {
namespace {

class Builder {
public:
  Builder(const Model &model, Progress &progress, const BallSet *balls)
      : model_(model), cells_(model.cells), inside_(model.inside), progress_(progress) {
    if (balls)
      balls_ = *balls;
    else
      balls_ = merge_cospherical(cells_, model_.samples.position,
                                 circumscribe(cells_, model_.samples.position, progress_, &inside_),
                                 progress_, &inside_);
  }

  DualComplex run() {
    pinches_ = find_pinches(model_, progress_);
    gather_cells();
    find_groups();
    number_facets();
    find_rings();
    while (dissolve_bad_groups()) {
    }
    make_vertices();
    make_edges();
    make_faces();
    fill_pinches();
    return std::move(out_);
  }

private:
  /// An inside tetrahedron, all that is asked of it in one cache line. Neighbours are inside, or
  /// -1.
  struct alignas(64) Inner {
    std::array<int32_t, 4> vertex, neighbor, facet; // facet: its number
    int32_t cell;                                   // of the model
    uint8_t seen;                                   // a bit per edge
  };

  /// Where a value is in a row that has it once; without branches, which nothing could foretell.
  static int place(const std::array<int32_t, 4> &row, int32_t value) {
    return int(row[1] == value) + 2 * int(row[2] == value) + 3 * int(row[3] == value);
  }

  void gather_cells() {
    number_.assign(cells_.size(), -1);
    int32_t count = 0;
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (inside_[c]) number_[c] = count++;
    inner_.resize(std::size_t(count));
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      progress_.tick(0, 1);
      if (!inside_[c]) continue;
      Inner &inner = inner_[number_[c]];
      inner = {cells_.vertex[c], {}, {-1, -1, -1, -1}, int32_t(c), 0};
      for (int i = 0; i < 4; ++i) {
        const int32_t n = cells_.neighbor[c][i];
        inner.neighbor[i] = n < 0 ? -1 : number_[n];
      }
    }
  }

  /// Groups of inside tetrahedra on one sphere that hang together across facets.
  void find_groups() {
    const auto count = int32_t(inner_.size());
    const auto ball_of = [&](int32_t c) { return balls_.of_cell[inner_[c].cell]; };
    group_.resize(inner_.size());
    std::iota(group_.begin(), group_.end(), 0);
    grouped_.assign(inner_.size(), 0);
    std::vector<uint8_t> shared(balls_.ball.size(), 0); // 1: one cell has it, 2: more
    for (int32_t c = 0; c < count; ++c) {
      uint8_t &s = shared[ball_of(c)];
      s = uint8_t(s ? 2 : 1);
    }
    if (std::find(shared.begin(), shared.end(), 2) == shared.end()) return;
    DisjointSets sets(inner_.size());
    for (int32_t c = 0; c < count; ++c) {
      progress_.tick(0, 1);
      if (shared[ball_of(c)] < 2) continue;
      for (int32_t n : inner_[c].neighbor)
        if (n > c && ball_of(n) == ball_of(c)) sets.unite(c, n);
    }
    for (int32_t c = 0; c < count; ++c) {
      group_[c] = sets.find(c);
      if (group_[c] != c) grouped_[c] = grouped_[group_[c]] = any_grouped_ = 1;
    }
  }

  void number_facets() {
    facet_cell_.reserve(2 * inner_.size());
    facet_place_.reserve(2 * inner_.size());
    for (int32_t c = 0; c < int32_t(inner_.size()); ++c) {
      progress_.tick(0, 1);
      for (int i = 0; i < 4; ++i) {
        const int32_t n = inner_[c].neighbor[i];
        if (n < c) continue;
        // Two tetrahedra share one facet, as their far vertices differ.
        const int k = place(inner_[n].neighbor, c);
        inner_[c].facet[i] = inner_[n].facet[k] = int32_t(facet_cell_.size());
        facet_cell_.push_back(c);
        facet_place_.push_back(int8_t(i));
      }
    }
  }

  /// The tetrahedra and facets round every Delaunay edge that has only inside round it. Samples
  /// with any other edge or facet are not solid.
  void find_rings() {
    out_.solid.assign(cells_.samples, 0);
    for (const Inner &inner : inner_)
      for (int32_t v : inner.vertex)
        if (v < cells_.samples) out_.solid[v] = 1;
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (!inside_[c])
        for (int32_t v : cells_.vertex[c])
          if (v < cells_.samples) out_.solid[v] = 0;
    ring_cell_.reserve(4 * inner_.size());
    ring_facet_.reserve(4 * inner_.size());
    constexpr int32_t kAhead = 8;
    for (int32_t c = 0; c < int32_t(inner_.size()); ++c) {
      progress_.tick(0, 1);
      if (c + kAhead < int32_t(inner_.size()))
        for (int32_t n : inner_[c + kAhead].neighbor) prefetch(&inner_[std::max(n, 0)]);
      const auto &near = inner_[c].neighbor;
      for (int i = 0, bit = 0; i < 3; ++i)
        for (int j = i + 1; j < 4; ++j, ++bit) {
          if (inner_[c].seen >> bit & 1) continue;
          const int k = i != 0 ? 0 : j == 3 ? 2 : 3, l = 6 - i - j - k; // the other two
          if (near[k] >= 0 && near[l] >= 0) turn_about(c, i, j);
        }
    }
  }

  static int edge_bit(int i, int j) { // 01 02 03 12 13 23
    if (i > j) std::swap(i, j);
    return i == 0 ? j - 1 : i == 1 ? j + 1 : 5;
  }

  void turn_about(int32_t first, int i, int j) {
    const int32_t a = inner_[first].vertex[i], b = inner_[first].vertex[j];
    int32_t at = first;
    int across = 0;
    while (across == i || across == j) ++across;
    const std::size_t begin = ring_cell_.size();
    do {
      Inner &cell = inner_[at];
      const int pa = place(cell.vertex, a), pb = place(cell.vertex, b);
      cell.seen = uint8_t(cell.seen | 1 << edge_bit(pa, pb));
      ring_cell_.push_back(at);
      ring_facet_.push_back(cell.facet[across]);
      const int32_t next = cell.neighbor[across];
      if (next < 0) { // no face
        ring_cell_.resize(begin);
        ring_facet_.resize(begin);
        return;
      }
      across = place(inner_[next].vertex, cell.vertex[6 - across - pa - pb]);
      at = next;
    } while (at != first);
    ring_samples_.push_back({std::min(a, b), std::max(a, b)});
    ring_.push_back(ring_cell_.size());
  }

  bool has_group(std::size_t ring) const {
    if (any_grouped_)
      for (uint64_t k = ring_[ring]; k < ring_[ring + 1]; ++k)
        if (grouped_[ring_cell_[k]]) return true;
    return false;
  }

  /// The stretches of a ring's tetrahedra that are in one group: their groups, and the facet that
  /// leads out of each. None if all are in one group.
  void stretches(std::size_t ring) {
    groups_.clear();
    exits_.clear();
    int32_t next = group_[ring_cell_[ring_[ring]]];
    for (uint64_t k = ring_[ring + 1]; k-- > ring_[ring];) {
      const int32_t here = group_[ring_cell_[k]];
      if (here != next) {
        groups_.push_back(here);
        exits_.push_back(ring_facet_[k]);
      }
      next = here;
    }
    std::reverse(groups_.begin(), groups_.end());
    std::reverse(exits_.begin(), exits_.end());
  }

  /// Take groups apart that are no balls (by Euler's number), that a ring meets twice, or that
  /// share facets which form no disk. Returns whether there were any.
  bool dissolve_bad_groups() {
    facet_set_ = DisjointSets(any_grouped_ ? facet_cell_.size() : 0);
    if (!any_grouped_) return false;
    const auto count = int32_t(inner_.size());
    std::vector<int32_t> euler(inner_.size(), 0);
    for (int32_t c = 0; c < count; ++c)
      if (grouped_[c]) ++euler[group_[c]];
    std::vector<uint8_t> bad(inner_.size(), 0);
    for (const Pinch &p : pinches_)
      for (const auto &[c, i] : p.facets)
        bad[group_[number_[c]]] = bad[group_[number_[cells_.neighbor[c][i]]]] = 1;
    for (std::size_t f = 0; f < facet_cell_.size(); ++f) {
      const int32_t c = facet_cell_[f], n = inner_[c].neighbor[facet_place_[f]];
      if (group_[c] == group_[n]) --euler[group_[c]];
    }
    for (std::size_t r = 0; r + 1 < ring_.size(); ++r) {
      progress_.tick(0, 1);
      if (!has_group(r)) continue;
      stretches(r);
      const std::size_t n = groups_.size();
      if (n == 0) ++euler[group_[ring_cell_[ring_[r]]]];
      sorted_ = groups_;
      std::sort(sorted_.begin(), sorted_.end());
      for (std::size_t i = 1; i < n; ++i)
        if (sorted_[i] == sorted_[i - 1]) bad[sorted_[i]] = 1;
      if (n == 2 && !facet_set_.unite(exits_[0], exits_[1])) bad[groups_[0]] = bad[groups_[1]] = 1;
    }
    for (int32_t c = 0; c < count; ++c)
      if (grouped_[c] && euler[group_[c]] != 1) bad[group_[c]] = 1;
    bool any = false;
    for (int32_t c = 0; c < count; ++c)
      if (grouped_[c] && bad[group_[c]]) own_.push_back(c);
    for (int32_t c : own_) {
      any = true;
      group_[c] = c;
      grouped_[c] = 0;
    }
    own_.clear();
    return any;
  }

  void make_vertices() {
    vertex_.assign(inner_.size(), -1);
    out_.vertex_of_cell.assign(cells_.size(), -1);
    out_.ball.reserve(inner_.size());
    for (int32_t c = 0; c < int32_t(inner_.size()); ++c) {
      int32_t &v = vertex_[group_[c]];
      if (v < 0) {
        v = int32_t(out_.ball.size());
        out_.ball.push_back(balls_.ball[balls_.of_cell[inner_[c].cell]]);
      }
      vertex_[c] = out_.vertex_of_cell[inner_[c].cell] = v;
    }
    balls_ = BallSet();
  }

  void make_edges() {
    edge_of_facet_.assign(facet_cell_.size(), -1);
    out_.edge.reserve(facet_cell_.size());
    out_.edge_samples.reserve(facet_cell_.size());
    for (int32_t f = 0; f < int32_t(facet_cell_.size()); ++f) {
      progress_.tick(0, 1);
      const Inner &cell = inner_[facet_cell_[f]];
      const int i = facet_place_[f];
      const int32_t u = vertex_[facet_cell_[f]], v = vertex_[cell.neighbor[i]];
      if (u == v) continue;
      const int32_t set = any_grouped_ ? facet_set_.find(f) : f;
      const auto &s = cell.vertex;
      const std::array<int32_t, 3> samples = {s[kFacet[i][0]], s[kFacet[i][1]], s[kFacet[i][2]]};
      if (edge_of_facet_[set] < 0) {
        edge_of_facet_[set] = int32_t(out_.edge.size());
        out_.edge.push_back({u, v});
        out_.edge_samples.push_back(samples);
      } else if (auto &others = out_.edge_samples[edge_of_facet_[set]];
                 shortest_side(samples) > shortest_side(others)) {
        // Of a polygon's triangles, the one whose samples are farthest apart stands for it: if it
        // has corners on three sides of the shape, then one triangle has.
        others = samples;
      }
      edge_of_facet_[f] = edge_of_facet_[set];
    }
  }

  double shortest_side(const std::array<int32_t, 3> &s) const {
    const std::vector<Vec3> &at = model_.samples.position;
    return std::min(
        {distance(at[s[0]], at[s[1]]), distance(at[s[1]], at[s[2]]), distance(at[s[2]], at[s[0]])});
  }

  void make_faces() {
    out_.face_vertices.index.reserve(ring_cell_.size());
    out_.face_edges.index.reserve(ring_cell_.size());
    out_.face_vertices.offset.reserve(ring_.size());
    out_.face_edges.offset.reserve(ring_.size());
    out_.face_samples.reserve(ring_samples_.size());
    for (std::size_t r = 0; r + 1 < ring_.size(); ++r) {
      progress_.tick(0, 1);
      if (has_group(r)) {
        stretches(r);
        if (groups_.size() < 3) continue;
        for (std::size_t i = 0; i < groups_.size(); ++i) {
          out_.face_vertices.index.push_back(vertex_[groups_[i]]);
          out_.face_edges.index.push_back(edge_of_facet_[exits_[i]]);
        }
      } else {
        for (uint64_t k = ring_[r]; k < ring_[r + 1]; ++k) {
          out_.face_vertices.index.push_back(vertex_[ring_cell_[k]]);
          out_.face_edges.index.push_back(edge_of_facet_[ring_facet_[k]]);
        }
      }
      out_.face_vertices.offset.push_back(out_.face_vertices.index.size());
      out_.face_edges.offset.push_back(out_.face_edges.index.size());
      out_.face_samples.push_back(ring_samples_[r]);
    }
  }

  /// A cone over the rings about each pinch.
  void fill_pinches() {
    std::map<int32_t, int32_t> spoke; // vertex: edge to it
    for (const Pinch &p : pinches_) {
      spoke.clear();
      const int32_t hub = int32_t(out_.ball.size());
      Vec3 sum;
      for (const auto &[c, i] : p.facets)
        for (int32_t cell : {c, cells_.neighbor[c][i]}) {
          const int32_t v = out_.vertex_of_cell[cell];
          if (!spoke.emplace(v, int32_t(out_.edge.size())).second) continue;
          out_.edge.push_back({hub, v});
          out_.edge_samples.push_back({p.sample, p.sample, p.sample});
          sum += out_.ball[v].center;
        }
      const Vec3 at = sum * (1.0 / double(spoke.size()));
      out_.ball.push_back({at, distance(at, model_.samples.position[p.sample])});
      for (const auto &[c, i] : p.facets) {
        const int32_t e = edge_of_facet_[inner_[number_[c]].facet[i]];
        const auto [u, v] = out_.edge[e];
        out_.face_vertices.index.insert(out_.face_vertices.index.end(), {hub, u, v});
        out_.face_edges.index.insert(out_.face_edges.index.end(), {spoke.at(u), e, spoke.at(v)});
        out_.face_vertices.offset.push_back(out_.face_vertices.index.size());
        out_.face_edges.offset.push_back(out_.face_edges.index.size());
        out_.face_samples.push_back({p.sample, p.sample});
      }
    }
  }

  const Model &model_;
  const Cells &cells_;
  const std::vector<uint8_t> &inside_;
  Progress &progress_;
  std::vector<Pinch> pinches_;
  std::vector<int32_t> number_; // per cell of the model: its place in inner_, or -1
  std::vector<Inner> inner_;    // "cells" below are these
  BallSet balls_;
  std::vector<int32_t> group_, vertex_; // per cell: a cell that names its group; its vertex
  std::vector<uint8_t> grouped_;        // per cell: whether its group has more
  bool any_grouped_ = false;
  std::vector<int32_t> facet_cell_; // per facet: one of its cells, and its place there
  std::vector<int8_t> facet_place_;
  std::vector<uint64_t> ring_{0};               // per ring: where it begins in the next two
  std::vector<int32_t> ring_cell_, ring_facet_; // facet i leads from cell i to i + 1
  std::vector<std::array<int32_t, 2>> ring_samples_;
  std::vector<int32_t> groups_, exits_, sorted_; // of the ring looked at
  std::vector<int32_t> own_, edge_of_facet_;
  DisjointSets facet_set_{0}; // facets that are one edge
  DualComplex out_;
};

} // namespace

DualComplex dual_complex(const Model &model, Progress &progress, const BallSet *balls) {
  return Builder(model, progress, balls).run();
}

} // namespace vbm::impl
