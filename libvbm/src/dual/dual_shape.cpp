// SPDX-License-Identifier: GPL-3.0-or-later
// Edelsbrunner, "The union of balls and its dual shape" (1995); Edelsbrunner, Muecke (1994). It
// differs in that all radii are a little larger than they were given (kTouch), so that balls that
// merely touch, as all balls of a Voronoi ball model do at their samples, meet properly.
#include "dual/dual_shape.h"

#include "core/error.h"
#include "core/progress.h"
#include "core/tolerances.h"
#include "core/workers.h"
#include "dual/orthospheres.h"
#include "surface/arrange_cells.h"

namespace vbm::impl {
namespace {

using Cell = PowerDiagram::Cell;

/// Cells from which on two threads are worth it.
constexpr std::size_t kManyCells = 4000;

class Search {
public:
  Search(DualShape &shape, Progress &progress)
      : shape_(shape), progress_(progress), parts_(shape.cells.size() < kManyCells ? 1 : 2) {}

  void run() {
    const std::size_t count = shape_.cells.size();
    shape_.cell_in.resize(count);
    shape_.facet_in.resize(count);
    turn_.assign(4 * count, kNoTriangle);
    in_parts(&Search::find_tetrahedra);
    in_parts(&Search::find_triangles);
    join_triangles();
    in_parts(&Search::find_edges);
    join_edges();
    find_vertices();
  }

private:
  static constexpr uint32_t kNoTriangle = UINT32_MAX;

  /// What is found from the cells of one of several parts.
  struct alignas(kApart) Part {
    std::size_t begin, end; // cells
    LargeList<DualShape::Triangle> triangles;
    LargeList<DualShape::Edge> edges;
    LargeList<DualShape::Turn> turns; // and room for more
    std::size_t count = 0;            // how many there are
  };

  const Site &site(int32_t ball) const { return shape_.site[ball]; }
  bool all_real(const Cell &c) const {
    return shape_.real(c.ball[0]) && shape_.real(c.ball[1]) && shape_.real(c.ball[2]) &&
           shape_.real(c.ball[3]);
  }

  void in_parts(void (Search::*find)(Part &, Progress &)) {
    run_parts(int(parts_.size()), progress_, [&](int n, Progress &progress) {
      Part &part = parts_[std::size_t(n)];
      part.begin = shape_.cells.size() * std::size_t(n) / parts_.size();
      part.end = shape_.cells.size() * std::size_t(n + 1) / parts_.size();
      (this->*find)(part, progress);
    });
  }

  /// The first part's lists have room for those of all.
  std::size_t room_of(const Part &part) const {
    return part.begin == 0 ? shape_.cells.size() : part.end - part.begin;
  }

  void find_tetrahedra(Part &part, Progress &progress) {
    for (std::size_t c = part.begin; c < part.end; ++c) {
      progress.tick(c, 4 * part.end);
      const Cell &cell = shape_.cells[c];
      shape_.cell_in[c] =
          all_real(cell) && tetrahedron_meets(site(cell.ball[0]), site(cell.ball[1]),
                                              site(cell.ball[2]), site(cell.ball[3]));
    }
  }

  /// A triangle is in the shape with a tetrahedron of it, or if its balls meet where no ball of
  /// those tetrahedra is nearer. It is found from the first of its tetrahedra.
  void find_triangles(Part &part, Progress &progress) {
    part.triangles.reserve(room_of(part)); // rarely more
    for (std::size_t c = part.begin; c < part.end; ++c) {
      progress.tick(part.end + c, 4 * part.end);
      const Cell &cell = shape_.cells[c];
      for (int i = 0; i < 4; ++i) {
        const int32_t code = int32_t(4 * c) + i, other = cell.neighbor[i];
        if (other < code) continue; // seen from there, or beyond the far tetrahedron
        const int(&f)[3] = kFacet[i];
        const std::array<int32_t, 3> ball = {cell.ball[f[0]], cell.ball[f[1]], cell.ball[f[2]]};
        const uint8_t in0 = shape_.cell_in[c], in1 = shape_.cell_in[other >> 2];
        if (!in0 && !in1) {
          if (!shape_.real(ball[0]) || !shape_.real(ball[1]) || !shape_.real(ball[2])) continue;
          if (!triangle_alone(ball, cell.ball[i], shape_.cells[other >> 2].ball[other & 3]))
            continue;
        }
        const uint32_t first = 4 * uint32_t(part.triangles.size());
        turn_[code] = first + !in0;
        turn_[other] = first + 2 + !in1;
        part.triangles.push_back({ball, code, {uint8_t(!in0), uint8_t(!in1)}});
      }
    }
  }

  bool triangle_alone(const std::array<int32_t, 3> &t, int32_t p, int32_t q) const {
    const Site &a = site(t[0]), &b = site(t[1]), &c = site(t[2]);
    return triangle_alone_meets(a, b, c, shape_.real(p) ? &site(p) : nullptr,
                                shape_.real(q) ? &site(q) : nullptr);
  }

  void join_triangles() {
    LargeList<DualShape::Triangle> &all = shape_.triangles;
    all.swap(parts_[0].triangles);
    for (std::size_t n = 1; n < parts_.size(); ++n) {
      const uint32_t before = uint32_t(all.size());
      for (const DualShape::Triangle &t : parts_[n].triangles) {
        progress_.tick(2, 4);
        turn_[t.code] += 4 * before;
        turn_[shape_.cells[t.code >> 2].neighbor[t.code & 3]] += 4 * before;
      }
      all.insert(all.end(), parts_[n].triangles.begin(), parts_[n].triangles.end());
      parts_[n].triangles = {};
    }
  }

  /// Every edge once, from the first of its tetrahedra: a bit for each of a tetrahedron's six says
  /// that it is done.
  void find_edges(Part &part, Progress &progress) {
    std::vector<uint8_t> done(part.end - part.begin, 0);
    part.turns.reserve(3 * room_of(part) * shape_.triangles.size() / shape_.cells.size() + 1);
    part.turns.resize(3 * (part.end - part.begin) * shape_.triangles.size() / shape_.cells.size());
    part.edges.reserve(room_of(part));
    for (std::size_t c = part.begin; c < part.end; ++c) {
      progress.tick(2 * part.end + c, 4 * part.end);
      for (int k = 0; k < 4; ++k)
        shape_.facet_in[c] |= uint8_t((turn_[4 * c + std::size_t(k)] != kNoTriangle) << k);
      for (uint8_t left = uint8_t(edges_of(shape_.cells[c]) & ~done[c - part.begin]); left;
           left &= uint8_t(left - 1)) {
        const int *const edge = kEdgeEnds[lowest_bit(left)];
        turn_about(part, done, int32_t(c), edge[0], edge[1]);
      }
    }
    part.turns.resize(part.count);
  }

  /// About the edge from a tetrahedron's ball i to its ball j.
  void turn_about(Part &part, std::vector<uint8_t> &done, int32_t first, int i, int j) {
    const int32_t a = shape_.cells[first].ball[i], b = shape_.cells[first].ball[j];
    const Cell *const cell = shape_.cells.data();
    const uint32_t *const turn = turn_.data();
    uint8_t *const done_here = done.data();
    const std::size_t begin = part.begin, cells = part.end - part.begin;
    std::size_t count = part.count;
    bool is_first = true;
    int32_t at = first;
    do {
      const int k = kTurn[i][j], l = 6 - i - j - k;
      if (count == part.turns.size()) part.turns.resize(2 * count + 1024);
      // Whether there is a triangle is as good as random, so nothing is branched on it.
      const uint32_t code = turn[4 * at + l];
      part.turns[count].code = code;
      count += code != kNoTriangle;
      const std::size_t here = std::size_t(at) - begin;
      if (here < cells)
        done_here[here] |= kEdgeBit[i][j];
      else
        is_first &= std::size_t(at) >= begin;
      at = cell[at].neighbor[k] >> 2;
      i = index_of(cell[at], a);
      j = index_of(cell[at], b);
    } while (at != first);
    if (!is_first || (count == part.count && !edge_alone(a, b, first))) return;
    part.edges.push_back({a, b, first, uint32_t(part.count), uint32_t(count)});
    part.count = count;
  }

  /// The bits of those that end at no far corner.
  uint8_t edges_of(const Cell &cell) const {
    uint8_t edges = 63;
    if (!all_real(cell))
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
          if (i != j && !shape_.real(cell.ball[i])) edges &= uint8_t(~kEdgeBit[i][j]);
    return edges;
  }
  static int lowest_bit(unsigned bits) {
    int at = 0;
    while (!(bits >> at & 1)) ++at;
    return at;
  }

  bool edge_alone(int32_t a, int32_t b, int32_t first) const {
    if (!edge_meets(site(a), site(b))) return false;
    int32_t at = first;
    do {
      const Cell &cell = shape_.cells[at];
      const int k = kTurn[index_of(cell, a)][index_of(cell, b)];
      const int32_t p = cell.ball[k];
      if (shape_.real(p) && hides_edge(site(a), site(b), site(p))) return false;
      at = cell.neighbor[k] >> 2;
    } while (at != first);
    return true;
  }

  void join_edges() {
    shape_.edges.swap(parts_[0].edges);
    shape_.turns.swap(parts_[0].turns);
    for (std::size_t n = 1; n < parts_.size(); ++n) {
      const uint32_t before = uint32_t(shape_.turns.size());
      shape_.turns.insert(shape_.turns.end(), parts_[n].turns.begin(), parts_[n].turns.end());
      for (DualShape::Edge &e : parts_[n].edges) {
        progress_.tick(3, 4);
        e.begin += before;
        e.end += before;
        shape_.edges.push_back(e);
      }
    }
  }

  void find_vertices() {
    const std::size_t count = shape_.vertex.size();
    std::vector<uint8_t> hidden(count, 1);
    for (const Cell &cell : shape_.cells) {
      progress_.tick(3, 4);
      for (int32_t b : cell.ball)
        if (shape_.real(b)) hidden[b] = 0;
    }
    for (const DualShape::Edge &e : shape_.edges) {
      progress_.tick(3, 4);
      shape_.vertex[e.a] = shape_.vertex[e.b] = 1;
    }
    for (std::size_t b = 0; b < count; ++b) hidden[b] |= shape_.vertex[b]; // need no test
    for (std::size_t c = 0; c < shape_.cells.size(); ++c) {
      progress_.tick(3 * shape_.cells.size() + c, 4 * shape_.cells.size());
      const Cell &cell = shape_.cells[c];
      for (int32_t a : cell.ball) {
        if (!shape_.real(a) || hidden[a]) continue;
        for (int32_t p : cell.ball)
          if (p != a && shape_.real(p) && hides_vertex(site(a), site(p))) hidden[a] = 1;
      }
    }
    for (std::size_t b = 0; b < count; ++b) shape_.vertex[b] |= !hidden[b];
  }

  static constexpr uint8_t kEdgeBit[4][4] = {
      {0, 1, 2, 4}, {1, 0, 8, 16}, {2, 8, 0, 32}, {4, 16, 32, 0}};
  static constexpr int kEdgeEnds[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

  DualShape &shape_;
  Progress &progress_;
  std::vector<Part> parts_;
  LargeList<uint32_t> turn_; // by cell and facet: as a Turn, kNoTriangle where there is none
};

} // namespace

DualShape dual_shape(const std::vector<Ball> &balls, double touch, Progress &progress) {
  std::vector<Ball> grown(balls);
  for (Ball &b : grown) b.radius = b.radius * (1 + kTouch) + touch;
  DualShape shape;
  shape.vertex.assign(balls.size(), 0);
  {
    const PowerDiagram diagram = power_diagram(grown, 0, progress);
    shape.cells = arranged(diagram.cells, balls.size(), progress);
    shape.corner = diagram.corner;
  }
  shape.site.reserve(balls.size());
  for (std::size_t b = 0; b < balls.size(); ++b)
    shape.site.push_back(changed_site(grown[b], int32_t(b), false));
  Search(shape, progress).run();
  return shape;
}

} // namespace vbm::impl
