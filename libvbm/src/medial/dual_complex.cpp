// SPDX-License-Identifier: GPL-3.0-or-later
// The dual of a triangulated solid has its interior's homotopy type (as the nerve of the open stars
// of tetrahedra, facets, edges and vertices that lie inside). Tetrahedra on one sphere form a
// convex polytope, which is contracted to one vertex; where rounding or the labels' repair left a
// group that is not contractible, its tetrahedra stay apart. Facets between the same two groups
// form a plane polygon, which is contracted to one edge.
#include "medial/dual_complex.h"

#include "balls/circumcenter.h"
#include "core/disjoint_sets.h"
#include "core/progress.h"
#include "medial/pinches.h"

#include <algorithm>
#include <map>

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
  bool inside(int32_t c) const { return c >= 0 && inside_[c]; }

  int place(int32_t cell, int32_t vertex) const {
    const auto &v = cells_.vertex[cell];
    return v[0] == vertex ? 0 : v[1] == vertex ? 1 : v[2] == vertex ? 2 : 3;
  }

  /// Groups of inside tetrahedra on one sphere that hang together across facets.
  void find_groups() {
    group_.resize(cells_.size());
    for (std::size_t c = 0; c < cells_.size(); ++c) group_[c] = int32_t(c);
    DisjointSets sets(cells_.size());
    for (int32_t c = 0; c < int32_t(cells_.size()); ++c) {
      progress_.tick(0, 1);
      if (!inside(c)) continue;
      for (int32_t n : cells_.neighbor[c])
        if (n > c && inside(n) && balls_.of_cell[n] == balls_.of_cell[c]) sets.unite(c, n);
    }
    for (std::size_t c = 0; c < cells_.size(); ++c) group_[c] = sets.find(int32_t(c));
  }

  void number_facets() {
    facet_.assign(cells_.size(), {-1, -1, -1, -1});
    for (int32_t c = 0; c < int32_t(cells_.size()); ++c) {
      progress_.tick(0, 1);
      if (!inside(c)) continue;
      for (int i = 0; i < 4; ++i) {
        const int32_t n = cells_.neighbor[c][i];
        if (!inside(n)) continue;
        if (n < c) {
          for (int k = 0; k < 4; ++k)
            if (cells_.neighbor[n][k] == c && opposite(n, k, c)) facet_[c][i] = facet_[n][k];
        } else {
          facet_[c][i] = int32_t(facet_cell_.size());
          facet_cell_.push_back(c);
          facet_place_.push_back(int8_t(i));
        }
      }
    }
  }

  /// Whether facet k of n is the one it shares with c: two tetrahedra share one facet, as their far
  /// vertices differ.
  bool opposite(int32_t n, int k, int32_t c) const {
    const auto &v = cells_.vertex[c];
    return std::find(v.begin(), v.end(), cells_.vertex[n][k]) == v.end();
  }

  /// The tetrahedra and facets round every Delaunay edge that has only inside round it. Samples
  /// with any other edge or facet are not solid.
  void find_rings() {
    out_.solid.assign(cells_.samples, 0);
    for (int32_t c = 0; c < int32_t(cells_.size()); ++c)
      if (inside(c))
        for (int32_t v : cells_.vertex[c])
          if (v < cells_.samples) out_.solid[v] = 1;
    for (int32_t c = 0; c < int32_t(cells_.size()); ++c)
      if (!inside(c))
        for (int32_t v : cells_.vertex[c])
          if (v < cells_.samples) out_.solid[v] = 0;
    std::vector<uint8_t> seen(cells_.size(), 0); // a bit per edge
    for (int32_t c = 0; c < int32_t(cells_.size()); ++c) {
      progress_.tick(0, 1);
      if (!inside(c)) continue;
      for (int i = 0, bit = 0; i < 3; ++i)
        for (int j = i + 1; j < 4; ++j, ++bit)
          if (!(seen[c] >> bit & 1)) turn_about(c, i, j, seen);
    }
  }

  static int edge_bit(int i, int j) { // 01 02 03 12 13 23
    if (i > j) std::swap(i, j);
    return i == 0 ? j - 1 : i == 1 ? j + 1 : 5;
  }

  void turn_about(int32_t first, int i, int j, std::vector<uint8_t> &seen) {
    const int32_t a = cells_.vertex[first][i], b = cells_.vertex[first][j];
    int32_t cell = first;
    int across = 0;
    while (across == i || across == j) ++across;
    const std::size_t begin = ring_cell_.size();
    do {
      const int pa = place(cell, a), pb = place(cell, b);
      seen[cell] = uint8_t(seen[cell] | 1 << edge_bit(pa, pb));
      ring_cell_.push_back(cell);
      ring_facet_.push_back(facet_[cell][across]);
      const int32_t next = cells_.neighbor[cell][across];
      if (!inside(next)) { // no face
        ring_cell_.resize(begin);
        ring_facet_.resize(begin);
        return;
      }
      const int32_t shared = cells_.vertex[cell][6 - across - pa - pb];
      across = place(next, shared);
      cell = next;
    } while (cell != first);
    ring_samples_.push_back({std::min(a, b), std::max(a, b)});
    ring_.push_back(ring_cell_.size());
  }

  bool within_one_group(std::size_t ring) const {
    for (uint64_t k = ring_[ring]; k < ring_[ring + 1]; ++k)
      if (group_[ring_cell_[k]] != group_[ring_cell_[ring_[ring]]]) return false;
    return true;
  }

  /// The stretches of a ring's tetrahedra that are in one group: their groups, and the facet that
  /// leads out of each.
  void stretches(std::size_t ring) {
    groups_.clear();
    exits_.clear();
    const uint64_t begin = ring_[ring], count = ring_[ring + 1] - begin;
    for (uint64_t k = 0; k < count; ++k) {
      const int32_t here = group_[ring_cell_[begin + k]];
      if (here == group_[ring_cell_[begin + (k + 1) % count]]) continue;
      groups_.push_back(here);
      exits_.push_back(ring_facet_[begin + k]);
    }
  }

  /// Take groups apart that are no balls (by Euler's number), that a ring meets twice, or that
  /// share facets which form no disk. Returns whether there were any.
  bool dissolve_bad_groups() {
    std::vector<int32_t> euler(cells_.size(), 0);
    for (int32_t c = 0; c < int32_t(cells_.size()); ++c)
      if (inside(c)) ++euler[group_[c]];
    facet_set_ = DisjointSets(facet_cell_.size());
    std::vector<uint8_t> bad(cells_.size(), 0);
    for (const Pinch &p : pinches_)
      for (const auto &[c, i] : p.facets) bad[group_[c]] = bad[group_[cells_.neighbor[c][i]]] = 1;
    for (std::size_t f = 0; f < facet_cell_.size(); ++f) {
      const int32_t c = facet_cell_[f], n = cells_.neighbor[c][facet_place_[f]];
      if (group_[c] == group_[n]) --euler[group_[c]];
    }
    for (std::size_t r = 0; r + 1 < ring_.size(); ++r) {
      progress_.tick(0, 1);
      if (within_one_group(r)) {
        ++euler[group_[ring_cell_[ring_[r]]]];
        continue;
      }
      stretches(r);
      const std::size_t n = groups_.size();
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 1; k < n; ++k)
          if (groups_[i] == groups_[k]) bad[groups_[i]] = 1;
      if (n == 2 && !facet_set_.unite(exits_[0], exits_[1])) bad[groups_[0]] = bad[groups_[1]] = 1;
    }
    bool any = false;
    for (int32_t c = 0; c < int32_t(cells_.size()); ++c)
      if (inside(c) && euler[c] != 0 && euler[c] != 1) bad[c] = 1;
    for (int32_t c = 0; c < int32_t(cells_.size()); ++c) {
      if (!inside(c) || !bad[group_[c]]) continue;
      any |= group_[c] != c;
      own_.push_back(c);
    }
    if (!any) return own_.clear(), false;
    for (int32_t c : own_) group_[c] = c;
    own_.clear();
    return true;
  }

  void make_vertices() {
    out_.vertex_of_cell.assign(cells_.size(), -1);
    for (int32_t c = 0; c < int32_t(cells_.size()); ++c) {
      if (!inside(c)) continue;
      int32_t &v = out_.vertex_of_cell[group_[c]];
      if (v < 0) {
        v = int32_t(out_.ball.size());
        out_.ball.push_back(balls_.ball[balls_.of_cell[c]]);
      }
      out_.vertex_of_cell[c] = v;
    }
    balls_ = BallSet();
  }

  void make_edges() {
    edge_of_facet_.assign(facet_cell_.size(), -1);
    for (int32_t f = 0; f < int32_t(facet_cell_.size()); ++f) {
      progress_.tick(0, 1);
      const int32_t c = facet_cell_[f], i = facet_place_[f], n = cells_.neighbor[c][i];
      if (group_[c] == group_[n]) continue;
      const int32_t set = facet_set_.find(f);
      if (edge_of_facet_[set] < 0) {
        edge_of_facet_[set] = int32_t(out_.edge.size());
        out_.edge.push_back({out_.vertex_of_cell[c], out_.vertex_of_cell[n]});
        out_.edge_samples.push_back({cells_.vertex[c][kFacet[i][0]], cells_.vertex[c][kFacet[i][1]],
                                     cells_.vertex[c][kFacet[i][2]]});
      }
      edge_of_facet_[f] = edge_of_facet_[set];
    }
  }

  void make_faces() {
    for (std::size_t r = 0; r + 1 < ring_.size(); ++r) {
      progress_.tick(0, 1);
      stretches(r);
      if (groups_.size() < 3) continue;
      for (std::size_t i = 0; i < groups_.size(); ++i) {
        out_.face_vertices.index.push_back(out_.vertex_of_cell[groups_[i]]);
        out_.face_edges.index.push_back(edge_of_facet_[exits_[i]]);
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
        const int32_t e = edge_of_facet_[facet_[c][i]];
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
  BallSet balls_;
  std::vector<int32_t> group_;                // per cell: a cell that names its group
  std::vector<std::array<int32_t, 4>> facet_; // per cell: numbers of the facets to inside cells
  std::vector<int32_t> facet_cell_;           // per facet: one of its cells, and its place there
  std::vector<int8_t> facet_place_;
  std::vector<uint64_t> ring_{0};               // per ring: where it begins in the next two
  std::vector<int32_t> ring_cell_, ring_facet_; // facet i leads from cell i to i + 1
  std::vector<std::array<int32_t, 2>> ring_samples_;
  std::vector<int32_t> groups_, exits_; // of the ring looked at
  std::vector<int32_t> own_, edge_of_facet_;
  DisjointSets facet_set_{0}; // facets that are one edge
  DualComplex out_;
};

} // namespace

DualComplex dual_complex(const Model &model, Progress &progress, const BallSet *balls) {
  return Builder(model, progress, balls).run();
}

} // namespace vbm::impl
