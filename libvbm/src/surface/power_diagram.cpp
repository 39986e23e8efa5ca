// SPDX-License-Identifier: GPL-3.0-or-later
// Bowyer (1981), Watson (1981), and Edelsbrunner, Shah, "Incremental topological flipping works for
// regular triangulations" (1996): balls are inserted one by one, each replacing the tetrahedra it
// is in conflict with by a fan of new ones.
//
// It differs from the usual in two ways. There is no infinite vertex: four far corners surround
// everything. And a tie, a ball exactly as far from a power centre as the four balls there, is no
// conflict. That is a symbolic perturbation: it raises every lifted point by an amount that is
// small against those of all later points, so the last one of five decides, and it is always the
// one being inserted. Every tetrahedron made so has a volume.
#include "surface/power_diagram.h"

#include "core/cells.h"
#include "core/error.h"
#include "core/grid.h"
#include "core/hash.h"
#include "core/prefetch.h"
#include "core/progress.h"
#include "core/tolerances.h"
#include "surface/insertion_order.h"
#include "surface/power_predicates.h"
#include "surface/power_side_wide.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vbm::impl {
namespace {

constexpr int32_t kNone = INT32_MIN;
constexpr std::size_t kMaxCells = std::size_t(1) << 29; // 4 * cell + facet fits an int32

class Builder {
public:
  Builder(std::vector<Site> sites) : site_(std::move(sites)), place_(site_.size(), Place{-1, 0}) {
    make_room(64);
  }

  /// Sites 0 to 3 are the far corners, positively oriented; insert the others in their order.
  void build(Progress &progress) {
    cell_.reserve(site_.size() * 9);
    cell_.push_back({{0, 1, 2, 3}, {kNone, kNone, kNone, kNone}});
    for (std::size_t i = 4; i < site_.size(); ++i) {
      progress.tick(i, site_.size());
      insert(int32_t(i));
    }
    for (int32_t c : free_) cell_[c].ball[0] = -1;
  }

  LargeList<PowerDiagram::Cell> &cells() { return cell_; }

private:
  using Cell = PowerDiagram::Cell;

  bool is_in_conflict(const Site *site, const Cell &c, const Site &p) const {
    const Site &s0 = site[c.ball[0]], &s1 = site[c.ball[1]], &s2 = site[c.ball[2]],
               &s3 = site[c.ball[3]];
    return (wide_ ? power_side_wide(s0, s1, s2, s3, p) : power_side(s0, s1, s2, s3, p)) > 0;
  }

  /// The tetrahedron that contains p: walks through facets that p lies behind. Visibility walks in
  /// regular triangulations end, whatever the order of the facets.
  int32_t locate(const Site &p) const {
    int32_t at = last_, from = -1;
    for (;;) {
      const Cell &c = cell_[at];
      int32_t next = -1;
      for (int i = 0; i < 4 && next < 0; ++i) {
        if (i == from) continue;
        const Site *s[4] = {&site_[c.ball[0]], &site_[c.ball[1]], &site_[c.ball[2]],
                            &site_[c.ball[3]]};
        s[i] = &p;
        if (c.neighbor[i] >= 0 && orientation(*s[0], *s[1], *s[2], *s[3]) < 0) next = c.neighbor[i];
      }
      if (next < 0) return at;
      at = next >> 2;
      from = next & 3;
    }
  }

  void insert(int32_t ball) {
    const Site &p = site_[ball];
    const int32_t first = locate(p);
    if (!is_in_conflict(site_.data(), cell_[first], p)) return; // hidden
    find_conflicts(ball, first);
    fill_hole(ball);
    free_.insert(free_.end(), conflict_.begin(), conflict_.begin() + std::ptrdiff_t(found_));
    last_ = made_[around_ - 1];
  }

  // While a ball is inserted, the top bit of ball[0] marks a cell found in conflict, that of
  // ball[1] one found not in conflict: a cell then costs one cache line to look at.
  static constexpr int32_t kMark = INT32_MIN;

  /// Beside the one a cell was found through: the first was found through none, number 4.
  static constexpr int kOtherFacets[5][4] = {
      {1, 2, 3, -1}, {0, 2, 3, -1}, {0, 1, 3, -1}, {0, 1, 2, -1}, {0, 1, 2, 3}};

  /// All cells in conflict, which are connected, and the facets around them.
  void find_conflicts(int32_t ball, int32_t first) {
    const Site &p = site_[ball];
    const Site *const site = site_.data();
    Cell *const cell = cell_.data();
    int32_t *conflict = conflict_.data(), *entry = entry_.data(), *boundary = boundary_.data();
    std::size_t room = conflict_.size(), found = 1, around = 0;
    conflict[0] = first;
    entry[0] = 4;
    cell[first].ball[0] |= kMark;
    // What a test finds is as good as random, so nothing is branched on it: both lists are written
    // to, and only one of them grows. Nor is it on the facet that a cell was found through.
    for (std::size_t k = 0; k < found; ++k) {
      if (found + 4 > room || around + 4 > room) {
        room = 2 * room;
        make_room(room);
        conflict = conflict_.data(), entry = entry_.data(), boundary = boundary_.data();
      }
      if (k + 1 < found)
        for (int32_t ahead : cell[conflict[k + 1]].neighbor)
          prefetch(cell + (std::max(ahead, 0) >> 2));
      const int32_t at = conflict[k];
      const int *const facets = kOtherFacets[entry[k]];
      for (int n = 0; n < (k == 0 ? 4 : 3); ++n) {
        const int i = facets[n];
        const int32_t code = cell[at].neighbor[i];
        int32_t in = 0;
        if (code >= 0) {
          Cell &next = cell[code >> 2];
          in = next.ball[0] < 0;
          if ((next.ball[0] | next.ball[1]) >= 0) {
            in = is_in_conflict(site, next, p);
            next.ball[1 - in] |= kMark;
            conflict[found] = code >> 2;
            entry[found] = code & 3;
            found += std::size_t(in);
          }
        }
        boundary[around] = at * 4 + i;
        around += std::size_t(1 - in);
      }
    }
    found_ = found;
    around_ = around;
    for (std::size_t k = 0; k < found; ++k) cell[conflict[k]].ball[0] &= ~kMark;
  }

  void make_room(std::size_t room) {
    conflict_.resize(room);
    entry_.resize(room);
    boundary_.resize(room);
  }

  void take_cells() {
    made_.resize(std::max(made_.size(), around_));
    for (std::size_t k = 0; k < around_; ++k) {
      if (!free_.empty()) {
        made_[k] = free_.back();
        free_.pop_back();
        continue;
      }
      if (cell_.size() >= kMaxCells)
        throw Error(VBM_ERROR_LIMIT, "the power diagram needs more than half a billion tetrahedra");
      made_[k] = int32_t(cell_.size());
      cell_.emplace_back();
    }
  }

  /// Join every boundary facet to the new ball. Two new cells are neighbours where their facets on
  /// the hole's boundary share an edge, which runs through the two in opposite directions.
  void fill_hole(int32_t ball) {
    take_cells();
    corner_.resize(std::max(corner_.size(), around_));
    const int32_t *const boundary = boundary_.data(), *const made = made_.data();
    Cell *const cell = cell_.data();
    Place *const place = place_.data();
    std::array<uint32_t, 3> *const corner = corner_.data();
    uint32_t sites = 0; // on the hole's boundary, numbered in the order of first sight
    for (std::size_t k = 0; k < around_; ++k) {
      const int32_t t = made[k];
      const Cell &old = cell[boundary[k] >> 2];
      const int i = boundary[k] & 3;
      Cell &fresh = cell[t];
      for (int c = 0; c < 3; ++c) {
        Place &at = place[old.ball[kFacet[i][c]]];
        if (at.ball != ball) at = {ball, sites++};
        corner[k][c] = at.number;
      }
      fresh.ball = old.ball;
      fresh.ball[i] = ball;
      const int32_t outside = old.neighbor[i];
      fresh.neighbor[i] = outside;
      if (outside >= 0) {
        cell[outside >> 2].neighbor[outside & 3] = t * 4 + i;
        cell[outside >> 2].ball[1] &= ~kMark;
      }
    }
    if (sites <= kTable)
      link_by_table();
    else
      link_by_turning();
  }

  void link_by_table() {
    const int32_t *const boundary = boundary_.data(), *const made = made_.data();
    const std::array<uint32_t, 3> *const corner = corner_.data();
    Cell *const cell = cell_.data();
    for (std::size_t k = 0; k < around_; ++k) {
      const int(&f)[3] = kFacet[boundary[k] & 3];
      const std::array<uint32_t, 3> &v = corner[k];
      table_[v[0]][v[1]] = made[k] * 4 + f[2];
      table_[v[1]][v[2]] = made[k] * 4 + f[0];
      table_[v[2]][v[0]] = made[k] * 4 + f[1];
    }
    for (std::size_t k = 0; k < around_; ++k) {
      const int(&f)[3] = kFacet[boundary[k] & 3];
      const std::array<uint32_t, 3> &v = corner[k];
      Cell &c = cell[made[k]];
      c.neighbor[f[2]] = table_[v[1]][v[0]];
      c.neighbor[f[0]] = table_[v[2]][v[1]];
      c.neighbor[f[1]] = table_[v[0]][v[2]];
    }
  }

  /// For large holes: turn about each edge through the hole's old cells, from one facet on its
  /// boundary to the other. A facet's neighbor is ~(the new cell on it) meanwhile.
  void link_by_turning() {
    for (std::size_t k = 0; k < around_; ++k)
      cell_[boundary_[k] >> 2].neighbor[boundary_[k] & 3] = ~made_[k];
    for (std::size_t k = 0; k < around_; ++k)
      for (int j : kFacet[boundary_[k] & 3]) {
        int32_t at = boundary_[k] >> 2, code;
        int in = boundary_[k] & 3, out = j;
        while ((code = cell_[at].neighbor[out]) >= 0) {
          const int32_t shared = cell_[at].ball[in];
          at = code >> 2;
          in = code & 3;
          const std::array<int32_t, 4> &b = cell_[at].ball;
          out = b[0] == shared ? 0 : b[1] == shared ? 1 : b[2] == shared ? 2 : 3;
        }
        cell_[made_[k]].neighbor[j] = ~code * 4 + in;
      }
  }

  static constexpr std::size_t kTable = 64; // sites round a hole, on average 18

  const bool wide_ = has_four_doubles();
  std::vector<Site> site_;
  LargeList<Cell> cell_;
  std::vector<int32_t> free_;
  // Of the ball at work: cells in conflict, and the facet each was found through; facets round
  // them, the new cells there, and the numbers of their corners. Longer than what they hold.
  std::vector<int32_t> conflict_, entry_, boundary_, made_;
  std::vector<std::array<uint32_t, 3>> corner_;
  std::size_t found_ = 0, around_ = 0;
  /// A site's number on the boundary of the hole of the ball it was last on.
  struct Place {
    int32_t ball;
    uint32_t number;
  };
  std::vector<Place> place_;
  /// By the ends of a boundary edge: the new cell and facet behind it.
  int32_t table_[kTable][kTable];
  int32_t last_ = 0; // where the next walk begins
};

} // namespace

Site changed_site(const Ball &ball, int32_t b, bool inner) {
  const double part = 0.5 + 0.5 * double(hash_index(b) >> 11) * 0x1p-53;
  const double radius = ball.radius * (1 + kPowerChange * (inner ? -part : part));
  const Vec3 c = on_grid(ball.center, kSiteGrid);
  return {c.x, c.y, c.z, on_grid(radius, kSiteGrid)};
}

PowerDiagram power_diagram(const std::vector<Ball> &balls, std::size_t inner, Progress &progress) {
  std::vector<Vec3> centers(balls.size());
  double reach = 1;
  for (std::size_t b = 0; b < balls.size(); ++b) {
    progress.tick(0, 1);
    centers[b] = balls[b].center;
    for (int a = 0; a < 3; ++a) reach = std::max(reach, std::fabs(centers[b][a]) + balls[b].radius);
  }
  const std::vector<int32_t> order = insertion_order(centers, progress);

  PowerDiagram diagram;
  // The inscribed sphere of this tetrahedron has 18 times the reach, so that the corners' cells
  // stay away from all that lies within reach of a ball.
  const double far = 32 * reach;
  diagram.corner = {Vec3{far, far, far}, Vec3{-far, -far, far}, Vec3{-far, far, -far},
                    Vec3{far, -far, -far}};
  std::vector<Site> sites;
  sites.reserve(balls.size() + 4);
  for (const Vec3 &c : diagram.corner) sites.push_back({c.x, c.y, c.z, 0});
  for (int32_t b : order) {
    progress.tick(0, 1);
    sites.push_back(changed_site(balls[b], b, std::size_t(b) < inner));
  }

  Builder builder(std::move(sites));
  builder.build(progress);
  diagram.cells = std::move(builder.cells());
  std::vector<uint8_t> present(balls.size(), 0);
  for (PowerDiagram::Cell &c : diagram.cells) {
    progress.tick(1, 1);
    if (c.ball[0] < 0) continue;
    for (int32_t &b : c.ball) {
      b = b < 4 ? int32_t(balls.size()) + b : order[b - 4];
      if (b < int32_t(balls.size())) present[b] = 1;
    }
  }
  for (std::size_t b = 0; b < balls.size(); ++b)
    if (!present[b]) diagram.hidden.push_back(int32_t(b));
  return diagram;
}

} // namespace vbm::impl
