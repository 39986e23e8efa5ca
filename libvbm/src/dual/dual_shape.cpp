// SPDX-License-Identifier: GPL-3.0-or-later
// Edelsbrunner, "The union of balls and its dual shape" (1995); Edelsbrunner, Muecke (1994). It
// differs in that all radii are a little larger than they were given (kTouch), so that balls that
// merely touch, as all balls of a Voronoi ball model do at their samples, meet properly.
#include "dual/dual_shape.h"

#include "core/error.h"
#include "core/progress.h"
#include "core/tolerances.h"
#include "dual/orthospheres.h"
#include "surface/arrange_cells.h"

namespace vbm::impl {
namespace {

using Cell = PowerDiagram::Cell;

class Search {
public:
  Search(DualShape &shape, Progress &progress) : shape_(shape), progress_(progress) {}

  void run() {
    find_tetrahedra();
    find_triangles();
    find_edges();
    find_vertices();
  }

private:
  const Site &site(int32_t ball) const { return shape_.site[ball]; }
  bool all_real(const Cell &c) const {
    return shape_.real(c.ball[0]) && shape_.real(c.ball[1]) && shape_.real(c.ball[2]) &&
           shape_.real(c.ball[3]);
  }

  void find_tetrahedra() {
    shape_.cell_in.assign(shape_.cells.size(), 0);
    for (std::size_t c = 0; c < shape_.cells.size(); ++c) {
      progress_.tick(c, 4 * shape_.cells.size());
      const Cell &cell = shape_.cells[c];
      if (!all_real(cell)) continue;
      shape_.cell_in[c] = tetrahedron_meets(site(cell.ball[0]), site(cell.ball[1]),
                                            site(cell.ball[2]), site(cell.ball[3]));
    }
  }

  /// A triangle is in the shape with a tetrahedron of it, or if its balls meet where no ball of
  /// those tetrahedra is nearer.
  void find_triangles() {
    triangle_.assign(4 * shape_.cells.size(), -1);
    shape_.facet_in.assign(shape_.cells.size(), 0);
    shape_.triangles.reserve(shape_.cells.size()); // rarely more
    for (std::size_t c = 0; c < shape_.cells.size(); ++c) {
      progress_.tick(shape_.cells.size() + c, 4 * shape_.cells.size());
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
        triangle_[code] = triangle_[other] = int32_t(shape_.triangles.size());
        shape_.facet_in[c] |= uint8_t(1 << i);
        shape_.facet_in[other >> 2] |= uint8_t(1 << (other & 3));
        shape_.triangles.push_back({ball, code, {uint8_t(!in0), uint8_t(!in1)}});
      }
    }
  }

  bool triangle_alone(const std::array<int32_t, 3> &t, int32_t p, int32_t q) const {
    const Site &a = site(t[0]), &b = site(t[1]), &c = site(t[2]);
    return triangle_alone_meets(a, b, c, shape_.real(p) ? &site(p) : nullptr,
                                shape_.real(q) ? &site(q) : nullptr);
  }

  /// Every edge once: a bit for each of a tetrahedron's six says that it is done.
  void find_edges() {
    std::vector<uint8_t> done(shape_.cells.size(), 0);
    shape_.turns.reserve(3 * shape_.triangles.size());
    shape_.edges.reserve(shape_.cells.size());
    for (std::size_t c = 0; c < shape_.cells.size(); ++c) {
      progress_.tick(2 * shape_.cells.size() + c, 4 * shape_.cells.size());
      const Cell &cell = shape_.cells[c];
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j) {
          if (done[c] & kEdgeBit[i][j]) continue;
          if (!shape_.real(cell.ball[i]) || !shape_.real(cell.ball[j])) continue;
          turn_about(int32_t(c), cell.ball[i], cell.ball[j], done);
        }
    }
  }

  void turn_about(int32_t first, int32_t a, int32_t b, std::vector<uint8_t> &done) {
    const uint32_t begin = uint32_t(shape_.turns.size());
    around_.clear();
    int32_t at = first;
    do {
      const Cell &cell = shape_.cells[at];
      const int i = index_of(cell, a), j = index_of(cell, b), k = kTurn[i][j], l = 6 - i - j - k;
      done[at] |= kEdgeBit[i][j];
      around_.push_back(cell.ball[k]);
      if (const int32_t t = triangle_[4 * at + l]; t >= 0) {
        const uint32_t side = shape_.triangles[t].code == 4 * at + l ? 0 : 2;
        shape_.turns.push_back({4 * uint32_t(t) + side + !shape_.cell_in[at]});
      }
      at = cell.neighbor[k] >> 2;
    } while (at != first);
    const uint32_t end = uint32_t(shape_.turns.size());
    if (begin == end && !edge_alone(a, b)) return;
    shape_.edges.push_back({a, b, first, begin, end});
  }

  bool edge_alone(int32_t a, int32_t b) const {
    if (!edge_meets(site(a), site(b))) return false;
    for (int32_t p : around_)
      if (shape_.real(p) && hides_edge(site(a), site(b), site(p))) return false;
    return true;
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

  DualShape &shape_;
  Progress &progress_;
  std::vector<int32_t> triangle_; // by cell and facet
  std::vector<int32_t> around_;   // balls round the edge at work
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
