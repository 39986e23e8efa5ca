// SPDX-License-Identifier: GPL-3.0-or-later
// Amenta, Choi, Kolluri, "The power crust" (2001): the faces of the power diagram that separate
// inner from outer cells. It differs in never looking at a coordinate: whatever is decided here is
// decided by the tetrahedra's indices.
#include "surface/crust_complex.h"

#include "core/prefetch.h"
#include "core/progress.h"

namespace vbm::impl {
namespace {

using Cell = PowerDiagram::Cell;

/// For facet-less turning: [i][j] is the k for which (i, j, k, l) is an even permutation of (0, 1,
/// 2, 3). Turning counter-clockwise about the edge from i to j, a tetrahedron is left by the facet
/// opposite k.
constexpr int kTurn[4][4] = {{-1, 2, 3, 1}, {3, -1, 0, 2}, {1, 3, -1, 0}, {2, 0, 1, -1}};

/// A bit for each of the six edges {i, j}.
constexpr int kEdge[4][4] = {{0, 1, 2, 4}, {1, 0, 8, 16}, {2, 8, 0, 32}, {4, 16, 32, 0}};

int index_of(const Cell &c, int32_t ball) {
  return (c.ball[1] == ball) + 2 * (c.ball[2] == ball) + 3 * (c.ball[3] == ball);
}

/// Cells to a patch: about what the nearest cache holds.
constexpr std::size_t kPatch = 512;

/// The cells that have both sides, component by component, in patches that are each searched
/// breadth first, the next one from the border of the last: what is near on the surface is near in
/// memory.
void collect_mixed(CrustComplex &crust, const LargeList<Cell> &cells, Progress &progress) {
  const auto mixed = [&](const Cell &c) {
    const int inner = crust.is_inner(c.ball[0]) + crust.is_inner(c.ball[1]) +
                      crust.is_inner(c.ball[2]) + crust.is_inner(c.ball[3]);
    return c.ball[0] >= 0 && inner % 4 != 0;
  };
  std::vector<int32_t> number(cells.size(), -1), border, patch;
  std::size_t count = 0;
  for (const Cell &c : cells) {
    progress.tick(0, 1);
    count += mixed(c);
  }
  crust.vertices.reserve(count);
  const auto take = [&](int32_t cell) {
    number[cell] = int32_t(crust.vertices.size());
    crust.vertices.push_back(cells[cell]);
    Cell &c = crust.vertices.back();
    for (int i = 0; i < 4; ++i) {
      const bool a = crust.is_inner(c.ball[(i + 1) % 4]);
      if (a == crust.is_inner(c.ball[(i + 2) % 4]) && a == crust.is_inner(c.ball[(i + 3) % 4]))
        c.neighbor[i] = -1;
      else if (number[c.neighbor[i] >> 2] < 0) {
        prefetch(&cells[c.neighbor[i] >> 2]);
        patch.push_back(c.neighbor[i] >> 2);
      }
    }
  };
  for (std::size_t first = 0; first < cells.size(); ++first) {
    progress.tick(crust.vertices.size(), 4 * count);
    if (number[first] >= 0 || !mixed(cells[first])) continue;
    ++crust.components;
    border.assign(1, int32_t(first));
    while (!border.empty()) {
      progress.tick(crust.vertices.size(), 4 * count);
      patch.assign(1, border.back());
      border.pop_back();
      const std::size_t end = crust.vertices.size() + kPatch;
      std::size_t k = 0;
      for (; k < patch.size() && crust.vertices.size() < end; ++k)
        if (number[patch[k]] < 0) take(patch[k]);
      for (; k < patch.size(); ++k)
        if (number[patch[k]] < 0) border.push_back(patch[k]);
    }
  }
  for (Cell &c : crust.vertices) {
    progress.tick(count, 4 * count);
    for (int32_t &code : c.neighbor)
      if (code >= 0) code = number[code >> 2] * 4 + (code & 3);
  }
}

void find_rings(CrustComplex &crust, Progress &progress) {
  const LargeList<Cell> &cells = crust.vertices;
  std::vector<uint8_t> seen(cells.size(), 0); // edges, as in kEdge
  std::vector<uint8_t> rings(cells.size(), 0);
  crust.rings_at.reserve(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    progress.tick(0, 1);
    crust.rings_at.push_back({-1, -1, -1, -1});
  }
  // On dense samplings a vertex has three or four corners, five corners make a ring.
  crust.rings.index.reserve(7 * cells.size() / 2);
  crust.rings.offset.reserve(3 * cells.size() / 4);
  crust.ring_inner.reserve(3 * cells.size() / 4);
  crust.ring_outer.reserve(3 * cells.size() / 4);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    progress.tick(c, cells.size());
    for (int i = 0; i < 4; ++i) {
      const int32_t a = cells[c].ball[i];
      if (!crust.is_inner(a)) continue;
      for (int j = 0; j < 4; ++j) {
        const int32_t b = cells[c].ball[j];
        if (crust.is_inner(b) || (seen[c] & kEdge[i][j])) continue;
        const int32_t ring = int32_t(crust.ring_inner.size());
        int32_t at = int32_t(c);
        int p = i, q = j;
        do {
          crust.rings.index.push_back(at);
          seen[at] |= kEdge[p][q];
          crust.rings_at[at][rings[at]++] = ring;
          at = cells[at].neighbor[kTurn[p][q]] >> 2;
          p = index_of(cells[at], a);
          q = index_of(cells[at], b);
        } while (at != int32_t(c));
        crust.rings.offset.push_back(crust.rings.index.size());
        crust.ring_inner.push_back(a);
        crust.ring_outer.push_back(b);
      }
    }
  }
}

} // namespace

int64_t CrustComplex::euler() const {
  return int64_t(vertices.size()) - int64_t(rings.index.size() / 2) + int64_t(ring_inner.size());
}

CrustComplex crust_complex(PowerDiagram diagram, std::size_t balls, std::size_t inner,
                           Progress &progress) {
  CrustComplex crust;
  crust.inner = int32_t(inner);
  crust.balls = balls;
  crust.corner = diagram.corner;
  collect_mixed(crust, diagram.cells, progress);
  LargeList<Cell>().swap(diagram.cells);
  find_rings(crust, progress);
  return crust;
}

} // namespace vbm::impl
