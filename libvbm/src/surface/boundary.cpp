// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/boundary.h"

#include <algorithm>

namespace vbm::impl {

namespace {

class Search {
public:
  Search(const Cells &cells, const std::vector<uint8_t> &inside, Progress &progress)
      : cells_(cells), inside_(inside), progress_(progress) {}

  Boundary run() {
    collect_facets();
    find_mates();
    make_vertices();
    return std::move(out_);
  }

private:
  struct Facet {
    int32_t cell;
    int8_t face;
  };

  bool inside(int32_t c) const { return c >= 0 && inside_[c]; }

  void collect_facets() {
    first_facet_.assign(cells_.size(), -1);
    for (int32_t c = 0; c < int32_t(cells_.size()); ++c) {
      progress_.tick(c, cells_.size());
      if (!inside(c)) continue;
      for (int8_t i = 0; i < 4; ++i)
        if (!inside(cells_.neighbor[c][i])) {
          if (first_facet_[c] < 0) first_facet_[c] = int32_t(facets_.size());
          facets_.push_back({c, i});
          out_.cell.push_back(c);
        }
    }
  }

  int32_t facet_of(int32_t cell, int face) const {
    int32_t f = first_facet_[cell];
    while (facets_[f].face != face) ++f;
    return f;
  }

  int32_t vertex(const Facet &f, int corner) const {
    return cells_.vertex[f.cell][kFacet[f.face][corner]];
  }

  int place(int32_t cell, int32_t vertex) const {
    const auto &v = cells_.vertex[cell];
    return v[0] == vertex ? 0 : v[1] == vertex ? 1 : v[2] == vertex ? 2 : 3;
  }

  /// The facet met when turning about edge (a, b) from facet f through inside tetrahedra.
  int32_t mate(const Facet &f, int32_t a, int32_t b) const {
    int32_t cell = f.cell;
    int across = 6 - f.face - place(cell, a) - place(cell, b);
    for (;;) {
      const int32_t next = cells_.neighbor[cell][across];
      if (!inside(next)) return facet_of(cell, across);
      // In `next`, leave by the facet opposite to the vertex that both facets about the edge share.
      const int32_t shared = cells_.vertex[cell][6 - across - place(cell, a) - place(cell, b)];
      across = place(next, shared);
      cell = next;
    }
  }

  int corner_of(int32_t facet, int32_t v) const {
    const Facet &f = facets_[facet];
    return vertex(f, 0) == v ? 0 : vertex(f, 1) == v ? 1 : 2;
  }

  void find_mates() {
    out_.mate.assign(facets_.size(), {-1, -1, -1});
    for (int32_t f = 0; f < int32_t(facets_.size()); ++f) {
      progress_.tick(f, facets_.size());
      for (int e = 0; e < 3; ++e) {
        if (out_.mate[f][e] >= 0) continue;
        const int32_t a = vertex(facets_[f], e), b = vertex(facets_[f], (e + 1) % 3);
        const int32_t g = mate(facets_[f], a, b);
        out_.mate[f][e] = g;
        out_.mate[g][corner_of(g, b)] = f; // the same way back, seen from g
      }
    }
  }

  /// One vertex for all corners of a fan: from a corner across the edge that begins there.
  void make_vertices() {
    std::vector<uint8_t> seen(cells_.samples, 0);
    out_.triangle.assign(facets_.size(), {-1, -1, -1});
    for (int32_t first = 0; first < int32_t(facets_.size()); ++first) {
      progress_.tick(1, 1);
      for (int i = 0; i < 3; ++i) {
        if (out_.triangle[first][i] >= 0) continue;
        const int32_t s = vertex(facets_[first], i), number = int32_t(out_.sample.size());
        out_.sample.push_back(s);
        out_.split += seen[s];
        seen[s] = 1;
        int32_t f = first;
        int corner = i;
        do {
          out_.triangle[f][corner] = number;
          f = out_.mate[f][corner];
          corner = corner_of(f, s);
        } while (f != first);
      }
    }
  }

  const Cells &cells_;
  const std::vector<uint8_t> &inside_;
  Progress &progress_;
  std::vector<Facet> facets_;
  std::vector<int32_t> first_facet_; // per cell; its others follow
  Boundary out_;
};

} // namespace

uint64_t Boundary::components(Progress &progress) const {
  std::vector<uint8_t> seen(triangle.size(), 0);
  std::vector<int32_t> stack;
  uint64_t count = 0;
  for (std::size_t first = 0; first < triangle.size(); ++first) {
    progress.tick(1, 1);
    if (seen[first]) continue;
    ++count;
    seen[first] = 1;
    stack.push_back(int32_t(first));
    while (!stack.empty()) {
      progress.tick(1, 1);
      const int32_t t = stack.back();
      stack.pop_back();
      for (int32_t m : mate[t])
        if (!seen[m]) {
          seen[m] = 1;
          stack.push_back(m);
        }
    }
  }
  return count;
}

Boundary find_boundary(const Cells &cells, const std::vector<uint8_t> &inside, Progress &progress) {
  return Search(cells, inside, progress).run();
}

} // namespace vbm::impl
