// SPDX-License-Identifier: GPL-3.0-or-later
// Marching tetrahedra on the pieces of mixed cells, after Kruithof and Vegter (see
// mixed_complex.cpp).
//
// Notation: a flag of a cell is an order of its four balls, thus a chain of simplices s0 < s1 < s2
// < s3. Its piece of the mixed cell of sk is the prism of the chains s0 .. sk and sk .. s3, cut
// into a tetrahedron for each monotone path of corners (si, sj) from (s0, sk) to (sk, s3).
#include "ball_surface/skin_mesh.h"

#include "core/error.h"
#include "core/progress.h"
#include "core/sort_in_buckets.h"

#include <algorithm>
#include <deque>
#include <string>

namespace vbm::impl {
namespace {

void check_count(std::size_t triangles) {
  constexpr std::size_t kMost = 500000000;
  if (triangles > kMost)
    throw Error(VBM_ERROR_LIMIT,
                "the skin surface would have more than " + std::to_string(kMost) + " triangles");
}

struct Piece {
  std::array<uint8_t, 4> low, high; // simplices of the corners, by bits of a cell's balls
  uint8_t ball;                     // by bits
  bool positive;
};

/// The 192 pieces that the mixed cells have in a cell.
std::vector<Piece> pieces_of_cell() {
  std::vector<Piece> pieces;
  std::array<int, 4> order{0, 1, 2, 3};
  do {
    uint8_t chain[4] = {};
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k <= i; ++k) chain[i] = uint8_t(chain[i] | (1 << order[k]));
    bool even = true;
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < i; ++k) even ^= order[k] > order[i];
    for (int k = 0; k < 4; ++k)
      // Bit i of the path: step i is within s0 .. sk; k of them are.
      for (int path = 0; path < 8; ++path) {
        if ((path & 1) + (path >> 1 & 1) + (path >> 2 & 1) != k) continue;
        Piece p{};
        p.ball = chain[0];
        p.positive = even;
        int i = 0, j = k;
        for (int step = 0;; ++step) {
          p.low[step] = chain[i];
          p.high[step] = chain[j];
          if (step == 3) break;
          if (path >> step & 1) {
            p.positive ^= (j - k) % 2 != 0; // each swap with a step taken before turns it over
            ++i;
          } else {
            ++j;
          }
        }
        pieces.push_back(p);
      }
  } while (std::next_permutation(order.begin(), order.end()));
  return pieces;
}

/// A corner of a triangle: the edge from a corner inside to one outside that it is on.
struct Use {
  MixedComplex::Corner in, out;
  uint32_t triangle;
  int32_t place;

  std::array<int32_t, 4> key() const { return {in.low, in.high, out.low, out.high}; }
};

class March {
public:
  March(const MixedComplex &mixed, Progress &progress)
      : mixed_(mixed), progress_(progress), pieces_(pieces_of_cell()) {}

  SkinMesh run() {
    for (std::size_t c = 0; c < mixed_.cell_count(); ++c) {
      progress_.tick(c, mixed_.cell_count());
      cut_cell(int32_t(c));
    }
    const std::unique_ptr<Use[]> sorted = sorted_in_buckets(
        uses_, mixed_.simplex_count(), [](const Use &u) { return u.in.low; },
        [](const Use &a, const Use &b) {
          const auto x = a.key(), y = b.key();
          return x != y                     ? x < y
                 : a.triangle != b.triangle ? a.triangle < b.triangle
                                            : a.place < b.place;
        },
        progress_);
    for (std::size_t i = 0; i < uses_.size(); ++i) {
      progress_.tick(i, uses_.size());
      const Use &use = sorted[i];
      if (i == 0 || use.key() != sorted[i - 1].key()) {
        mesh_.normal.emplace_back();
        mesh_.position.push_back(mixed_.crossing(use.in, use.out, mesh_.normal.back()));
      }
      mesh_.triangles[use.triangle].vertex[use.place] = int32_t(mesh_.position.size()) - 1;
    }
    return std::move(mesh_);
  }

private:
  void cut_cell(int32_t number) {
    const MixedComplex::Cell cell = mixed_.cell(std::size_t(number));
    // The sides of all corners: bit `high` of below_[low] is set inside.
    std::array<uint16_t, 16> below{};
    int inside = 0, all = 0;
    for (int low = 1; low < 16; ++low)
      for (int high = low; high < 16; ++high) {
        if ((low & high) != low) continue;
        const bool in = mixed_.value({cell.simplex[low], cell.simplex[high]}) < 0;
        below[low] = uint16_t(below[low] | in << high);
        inside += in;
        ++all;
      }
    if (inside == 0 || inside == all) return;
    for (const Piece &p : pieces_) {
      std::array<int, 4> order{};
      int in = 0, out = 4;
      bool positive = p.positive;
      for (int i = 0; i < 4; ++i)
        if (below[p.low[i]] >> p.high[i] & 1) {
          positive ^= (4 - out) % 2 != 0; // corners outside that it is moved before
          order[in++] = i;
        } else {
          order[--out] = i;
        }
      if (in == 0 || in == 4) continue;
      std::reverse(order.begin() + in, order.end()); // as they came
      if (in == 1) {
        add(number, cell, p, order, {0, 1, 0, 2, 0, 3}, positive);
      } else if (in == 3) {
        add(number, cell, p, order, {0, 3, 1, 3, 2, 3}, positive);
      } else {
        add(number, cell, p, order, {0, 2, 0, 3, 1, 3}, positive);
        add(number, cell, p, order, {0, 2, 1, 3, 1, 2}, positive);
      }
    }
  }

  /// The triangle through three edges of a piece, from corner order[ends[2 i]] inside to
  /// order[ends[2 i + 1]] outside; counter-clockwise from outside in a positive piece.
  void add(int32_t number, const MixedComplex::Cell &cell, const Piece &p,
           const std::array<int, 4> &order, const std::array<int, 6> &ends, bool positive) {
    check_count(mesh_.triangles.size() + 1);
    const auto corner = [&](int at) {
      return MixedComplex::Corner{cell.simplex[p.low[order[at]]], cell.simplex[p.high[order[at]]]};
    };
    const uint32_t t = uint32_t(mesh_.triangles.size());
    mesh_.triangles.push_back({{}, number, cell.simplex[p.ball]});
    for (int i = 0; i < 3; ++i)
      uses_.push_back(
          {corner(ends[2 * i]), corner(ends[2 * i + 1]), t, positive || i == 0 ? i : 3 - i});
  }

  const MixedComplex &mixed_;
  Progress &progress_;
  const std::vector<Piece> pieces_;
  std::deque<Use> uses_; // by far the most memory: never copied as it grows
  SkinMesh mesh_;
};

/// Halves marked edges once, and splits triangles at them.
class Halving {
public:
  Halving(SkinMesh &mesh, const MixedComplex &mixed, const SkinDetail &detail, Progress &progress)
      : mesh_(mesh), mixed_(mixed), least_(detail.least), progress_(progress) {}

  /// False if no edge needs it.
  bool run() {
    const std::vector<int32_t> twin = twins_of(mesh_, progress_);
    middle_.assign(twin.size(), -1);
    bool any = false;
    for (std::size_t h = 0; h < twin.size(); ++h) {
      progress_.tick(h, twin.size());
      if (twin[h] < int32_t(h)) continue;
      const int32_t m = middle_of(int32_t(h), twin[h]);
      middle_[h] = middle_[twin[h]] = m;
      any |= m >= 0;
    }
    const std::size_t count = mesh_.triangles.size();
    std::size_t added = 0; // every mark adds one
    for (int32_t m : middle_) added += m >= 0;
    check_count(count + added);
    if (any)
      for (std::size_t t = 0; t < count; ++t) {
        progress_.tick(t, count);
        split(t);
      }
    return any;
  }

private:
  /// The vertex in the middle of the edge that both half-edges are, -1 if it needs none.
  int32_t middle_of(int32_t h, int32_t g) {
    const SkinMesh::Triangle &s = mesh_.triangles[h / 3], &t = mesh_.triangles[g / 3];
    const Vec3 p = mesh_.position[s.vertex[h % 3]], q = mesh_.position[t.vertex[g % 3]];
    const Vec3 straight = (p + q) * 0.5;
    // What would move farther than half the edge is on another sheet.
    const double reach = 0.5 * distance(p, q), least = std::min(least_[s.ball], least_[t.ball]);
    Vec3 x = straight, normal;
    if (reach <= least || !mixed_.project(std::min(s.cell, t.cell), reach, x, normal)) return -1;
    if (distance(x, straight) <= least) return -1;
    mesh_.position.push_back(x);
    mesh_.normal.push_back(normal);
    return int32_t(mesh_.position.size()) - 1;
  }

  void split(std::size_t t) {
    const SkinMesh::Triangle old = mesh_.triangles[t];
    const int32_t *m = &middle_[3 * t];
    const int marks = (m[0] >= 0) + (m[1] >= 0) + (m[2] >= 0);
    if (marks == 0) return;
    const auto make = [&](std::size_t at, int32_t a, int32_t b, int32_t c) {
      const SkinMesh::Triangle made{{a, b, c}, old.cell, old.ball};
      if (at == t)
        mesh_.triangles[t] = made;
      else
        mesh_.triangles.push_back(made);
    };
    constexpr std::size_t kNew = ~std::size_t(0);
    // Turned so that the marked edges come first: m of v0 v1, v1 v2, v2 v0.
    int turn = 0;
    if (marks == 1) turn = m[0] >= 0 ? 0 : m[1] >= 0 ? 1 : 2;
    if (marks == 2) turn = m[2] < 0 ? 0 : m[0] < 0 ? 1 : 2;
    const int32_t v[3] = {old.vertex[turn], old.vertex[(turn + 1) % 3], old.vertex[(turn + 2) % 3]};
    const int32_t n[3] = {m[turn], m[(turn + 1) % 3], m[(turn + 2) % 3]};
    if (marks == 3) {
      make(t, n[0], n[1], n[2]);
      make(kNew, v[0], n[0], n[2]);
      make(kNew, v[1], n[1], n[0]);
      make(kNew, v[2], n[2], n[1]);
    } else if (marks == 2) {
      make(t, n[0], v[1], n[1]);
      const auto &x = mesh_.position;
      if (distance(x[v[0]], x[n[1]]) < distance(x[n[0]], x[v[2]])) {
        make(kNew, v[0], n[0], n[1]);
        make(kNew, v[0], n[1], v[2]);
      } else {
        make(kNew, v[0], n[0], v[2]);
        make(kNew, n[0], n[1], v[2]);
      }
    } else {
      make(t, v[0], n[0], v[2]);
      make(kNew, n[0], v[1], v[2]);
    }
  }

  SkinMesh &mesh_;
  const MixedComplex &mixed_;
  const std::vector<double> &least_;
  Progress &progress_;
  std::vector<int32_t> middle_; // by half-edge
};

/// Each pass halves edges; an arc of half a circle with a bulge of 0.001 needs 6.
constexpr int kMostPasses = 8;

} // namespace

SkinMesh march(const MixedComplex &mixed, Progress &progress) {
  return March(mixed, progress).run();
}

void refine(SkinMesh &mesh, const MixedComplex &mixed, const SkinDetail &detail,
            Progress &progress) {
  for (int pass = 0; pass < kMostPasses; ++pass)
    if (!Halving(mesh, mixed, detail, progress).run()) return;
}

} // namespace vbm::impl
