// SPDX-License-Identifier: GPL-3.0-or-later
// Edge contraction under the link condition (Dey, Edelsbrunner, Guha, Nekhayev, "Topology
// preserving edge contraction", 1999): the ends have two neighbours in common, those of the edge's
// triangles, and these have more than three neighbours. Marching makes many triangles of no size,
// where a mixed cell's pieces have none.
#include "ball_surface/skin_mesh.h"
#include "core/progress.h"
#include "core/sort_edges.h"
#include "match/sort_in_pieces.h"

#include <algorithm>

namespace vbm::impl {
namespace {

constexpr int kMostPasses = 12;
/// Share of the short edges that a pass has to contract for another one to be made.
constexpr double kWorthwhile = 0.03;
constexpr std::size_t kMostNeighbors = 24;
/// Cosine between a triangle's normal and the skin's, which contraction must not bring it below.
constexpr double kTurned = 0.5;

class Contraction {
public:
  Contraction(SkinMesh &mesh, const SkinDetail &detail, Progress &progress)
      : mesh_(mesh), detail_(detail), progress_(progress), twin_(twins_of(mesh, progress)),
        mark_(mesh.position.size(), 0) {}

  void run() {
    for (int pass = 0; pass < kMostPasses && contract_once() >= kWorthwhile; ++pass) {
    }
    compact();
  }

  std::size_t unfold() {
    std::size_t went = 0;
    for (int32_t t = 0; t < int32_t(mesh_.triangles.size()); ++t) {
      progress_.tick(0, 1);
      if (!gone(3 * t) && upright(mesh_, mesh_.triangles[t].vertex) < kFolded)
        went += straighten(t);
    }
    compact();
    return went;
  }

private:
  // Half-edge 3 t + i runs from corner i of triangle t to the next one.
  static int32_t next(int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int32_t previous(int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int32_t &vertex(int32_t h) { return mesh_.triangles[h / 3].vertex[h % 3]; }
  const Vec3 &at(int32_t v) const { return mesh_.position[v]; }

  struct Edge {
    double length;
    int32_t h;
  };

  double limit(int32_t h) const {
    const SkinMesh::Triangle &s = mesh_.triangles[h / 3], &t = mesh_.triangles[twin_[h] / 3];
    return std::min(detail_.shortest[s.ball], detail_.shortest[t.ball]);
  }

  bool gone(int32_t h) const { return mesh_.triangles[h / 3].vertex[0] < 0; }

  /// The share of the short edges that went.
  double contract_once() {
    std::vector<Edge> edges;
    for (int32_t h = 0; h < int32_t(twin_.size()); ++h) {
      progress_.tick(0, 1);
      if (h > twin_[h] || gone(h)) continue;
      const double length = distance(at(vertex(h)), at(vertex(next(h))));
      if (length < limit(h)) edges.push_back({length, h});
    }
    sort_in_pieces(
        edges,
        [](const Edge &a, const Edge &b) {
          return a.length != b.length ? a.length < b.length : a.h < b.h;
        },
        progress_);
    std::size_t went = 0;
    for (const Edge &e : edges) {
      progress_.tick(0, 1);
      if (gone(e.h) || distance(at(vertex(e.h)), at(vertex(next(e.h)))) > 2 * e.length) continue;
      went += contract(e.h) || contract(twin_[e.h]);
    }
    return edges.empty() ? 0 : double(went) / double(edges.size());
  }

  /// Half-edges from the first vertex of h, h first.
  void list_fan(int32_t h, std::vector<int32_t> &fan) {
    fan.clear();
    int32_t k = h;
    do {
      fan.push_back(k);
      k = twin_[previous(k)];
    } while (k != h && fan.size() <= kMostNeighbors);
  }

  /// Moves the first vertex of h into its second.
  bool contract(int32_t h) {
    const int32_t from = vertex(h), to = vertex(next(h)), g = twin_[h];
    list_fan(h, fan_);
    list_fan(g, other_);
    if (fan_.size() + other_.size() > kMostNeighbors + 4) return false;
    if (!link_holds(h, g) || !stays_upright(from, to) || !stays_near(from, to)) return false;
    take_out(h);
    return true;
  }

  void take_out(int32_t h) { // its fans are listed
    const int32_t to = vertex(next(h)), g = twin_[h];
    for (int32_t k : fan_) vertex(k) = to;
    // The triangles on both sides of h go; what was beyond their other edges is joined.
    for (int32_t k : {h, g}) {
      const int32_t a = twin_[next(k)], b = twin_[previous(k)];
      twin_[a] = b;
      twin_[b] = a;
      mesh_.triangles[k / 3].vertex = {-1, -1, -1};
    }
  }

  /// Contracts that edge of a folded triangle by which the worst triangle round its end gains most.
  bool straighten(int32_t t) {
    int32_t chosen = -1;
    double best = 0;
    for (int32_t i = 3 * t; i < 3 * t + 3; ++i)
      for (int32_t h : {i, twin_[i]}) {
        list_fan(h, fan_);
        list_fan(twin_[h], other_);
        if (fan_.size() + other_.size() > kMostNeighbors + 4 || !link_holds(h, twin_[h])) continue;
        const double gain = worst_after(vertex(next(h))) - worst_before();
        if (gain > best) best = gain, chosen = h;
      }
    if (chosen < 0) return false;
    list_fan(chosen, fan_);
    list_fan(twin_[chosen], other_);
    take_out(chosen);
    return true;
  }

  /// How folded the worst triangle of the first fan is; and without its first and last, which an
  /// edge's contraction takes out, with the fan's vertex at another place.
  double worst_before() const {
    double worst = 1;
    for (int32_t k : fan_) worst = std::min(worst, upright(mesh_, mesh_.triangles[k / 3].vertex));
    return worst;
  }
  double worst_after(int32_t to) {
    double worst = 1;
    for (std::size_t i = 1; i + 1 < fan_.size(); ++i)
      worst =
          std::min(worst, upright(mesh_, {to, vertex(next(fan_[i])), vertex(previous(fan_[i]))}));
    return worst;
  }

  bool link_holds(int32_t h, int32_t g) {
    ++stamp_;
    for (int32_t k : fan_) mark_[vertex(next(k))] = stamp_;
    int common = 0;
    for (int32_t k : other_) common += mark_[vertex(next(k))] == stamp_;
    if (common != 2) return false;
    for (int32_t k : {h, g}) {
      const int32_t corner = previous(k);
      int count = 0;
      int32_t i = corner;
      do {
        ++count;
        i = twin_[previous(i)];
      } while (i != corner && count < 4);
      if (count < 4) return false;
    }
    return true;
  }

  bool stays_upright(int32_t from, int32_t to) {
    if (at(from) == at(to)) return true;
    for (std::size_t i = 1; i + 1 < fan_.size(); ++i) { // all but both triangles at h
      const int32_t k = fan_[i];
      std::array<int32_t, 3> v{vertex(k), vertex(next(k)), vertex(previous(k))};
      const double before = upright(mesh_, v);
      v[0] = to;
      const double after = upright(mesh_, v);
      if (!(after >= kTurned || after >= before)) return false;
    }
    return true;
  }

  /// No edge gets farther from the skin than it may be, or than it was.
  bool stays_near(int32_t from, int32_t to) {
    for (std::size_t i = 2; i + 1 < fan_.size(); ++i) { // the others are there already
      const int32_t k = fan_[i], v = vertex(next(k));
      const double there = bend(mesh_, to, v);
      if (there > detail_.least[mesh_.triangles[k / 3].ball] && there > bend(mesh_, from, v))
        return false;
    }
    return true;
  }

  /// Drops what is gone.
  void compact() {
    std::vector<int32_t> number(mesh_.position.size(), -1);
    SkinMesh out;
    for (const SkinMesh::Triangle &t : mesh_.triangles) {
      progress_.tick(0, 1);
      if (t.vertex[0] < 0) continue;
      out.triangles.push_back(t);
      for (int32_t &v : out.triangles.back().vertex) {
        if (number[v] < 0) {
          number[v] = int32_t(out.position.size());
          out.position.push_back(mesh_.position[v]);
          out.normal.push_back(mesh_.normal[v]);
        }
        v = number[v];
      }
    }
    mesh_ = std::move(out);
  }

  SkinMesh &mesh_;
  const SkinDetail &detail_;
  Progress &progress_;
  std::vector<int32_t> twin_; // of each half-edge
  std::vector<int32_t> fan_, other_;
  std::vector<uint32_t> mark_; // of vertices: the stamp of the last look
  uint32_t stamp_ = 0;
};

} // namespace

void contract(SkinMesh &mesh, const SkinDetail &detail, Progress &progress) {
  Contraction(mesh, detail, progress).run();
}

std::size_t unfold(SkinMesh &mesh, const SkinDetail &detail, Progress &progress) {
  return Contraction(mesh, detail, progress).unfold();
}

std::vector<int32_t> twins_of(const SkinMesh &mesh, Progress &progress) {
  struct Half {
    int32_t low, high, h;
  };
  std::vector<Half> halves;
  halves.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    progress.tick(0, 1);
    const auto &v = mesh.triangles[t].vertex;
    for (int i = 0; i < 3; ++i) {
      const int32_t a = v[i], b = v[(i + 1) % 3];
      halves.push_back({std::min(a, b), std::max(a, b), int32_t(3 * t) + i});
    }
  }
  sort_edges(halves, mesh.position.size(), progress);
  std::vector<int32_t> twin(halves.size());
  for (std::size_t i = 0; i + 1 < halves.size(); i += 2) {
    progress.tick(0, 1);
    twin[halves[i].h] = halves[i + 1].h;
    twin[halves[i + 1].h] = halves[i].h;
  }
  return twin;
}

} // namespace vbm::impl
