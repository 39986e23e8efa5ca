// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of crust vertices become one vertex each. That is safe where a group is connected and the
// part of the surface it spans (its vertices, the edges and faces with all their ends in it) has
// Euler characteristic 1: a connected part of a closed surface with that characteristic is
// contractible, and shrinking such parts to points leaves the surface what it was (Moore,
// "Concerning upper semi-continuous collections of continua", 1925). What is left to check is that
// the result can be written as polygons: no polygon that comes to a vertex twice, no two edges
// between the same two vertices; and that none of them is folded. A group that fails is made again
// from closer vertices, in the end only from those that are one sample, or not at all, until all is
// well. With nothing merged it is: the complex is part of a triangulation's dual.
#include "surface/crust_merge.h"

#include "core/progress.h"
#include "core/tolerances.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vbm::impl {
namespace {

// How much may be merged: vertices within parts of the tolerances, those that are one sample,
// nothing.
constexpr uint8_t kNear[] = {0, 1, 2};
constexpr double kPart[] = {1, 0.5, 0.25};
constexpr uint8_t kSame = 3, kSingle = 4;

class Merging {
public:
  Merging(const CrustComplex &crust, const CrustVertices &vertices, const std::vector<Ball> &balls,
          const Model &model, Progress &progress)
      : crust_(crust), vertices_(vertices), balls_(balls), model_(model), progress_(progress) {
    const std::size_t count = crust.vertices.size(), rings = crust.ring_inner.size();
    for (std::vector<int32_t> *v : {&group_, &next_, &ring_of_}) {
      v->assign(count, -1);
      progress.tick_slow(0, 1);
    }
    edges_.assign(count, 0);
    level_.assign(count, kNear[0]);
    kind_.assign(count, kSingle);
    progress.tick_slow(0, 1);
    corners_.assign(rings, 0);
    ring_at_.assign(rings, -1);
    progress.tick_slow(0, 1);
  }

  void run() {
    std::vector<int32_t> pending(crust_.vertices.size()), rings(crust_.ring_inner.size()), groups;
    std::iota(pending.begin(), pending.end(), 0);
    std::iota(rings.begin(), rings.end(), 0);
    std::vector<int32_t> seen_group(pending.size(), -1),
        seen_ring(rings.size(), -1); // in which round
    for (int32_t round = 0; !pending.empty(); ++round) {
      progress_.tick_slow(0, 1);
      make_groups(pending);
      groups.clear();
      const auto suspect = [&](int32_t g) {
        if (kind_[g] == kSingle || seen_group[g] == round) return;
        seen_group[g] = round;
        groups.push_back(g);
      };
      for (int32_t v : pending) {
        progress_.tick(0, 1);
        suspect(group_[v]);
      }
      if (round > 0) {
        rings.clear();
        for (int32_t v : pending) {
          for (int32_t code : crust_.vertices[v].neighbor)
            if (code >= 0) suspect(group_[code >> 2]);
          for (int32_t r : crust_.rings_at[v])
            if (r >= 0 && seen_ring[r] != round) {
              seen_ring[r] = round;
              rings.push_back(r);
            }
        }
      }
      bad_.clear();
      for (std::size_t i = 0; i < rings.size(); ++i) {
        progress_.tick(i, rings.size());
        check_ring(rings[i]);
      }
      for (std::size_t i = 0; i < groups.size(); ++i) {
        progress_.tick(i, groups.size());
        check_group(groups[i]);
      }
      dissolve(pending);
    }
  }

  CrustMesh mesh() {
    CrustMesh mesh;
    std::vector<int32_t> number(group_.size(), -1);
    for (std::size_t v = 0; v < group_.size(); ++v) {
      progress_.tick(1, 1);
      if (group_[v] == int32_t(v)) {
        number[v] = int32_t(mesh.position.size());
        mesh.position.push_back(vertices_.position[v]);
        mesh.sample.push_back(vertices_.sample[v]);
      }
    }
    for (std::size_t r = 0; r < crust_.ring_inner.size(); ++r) {
      progress_.tick(r, crust_.ring_inner.size());
      if (corners_[r] < 3) continue;
      reduce(int32_t(r));
      for (int32_t g : polygon_) mesh.polygons.index.push_back(number[g]);
      mesh.polygons.offset.push_back(mesh.polygons.index.size());
      mesh.inner.push_back(crust_.ring_inner[r]);
      mesh.outer.push_back(crust_.ring_outer[r]);
    }
    return mesh;
  }

private:
  /// Put the pending vertices into groups, each named by one of its vertices: where it will be.
  void make_groups(const std::vector<int32_t> &pending) {
    for (const bool samples : {true, false})
      for (std::size_t i = 0; i < pending.size(); ++i) {
        progress_.tick(i, pending.size());
        const int32_t v = pending[i];
        if (group_[v] < 0 && (vertices_.sample[v] >= 0 || !samples)) grow(v);
      }
  }

  void grow(int32_t seed) {
    const int32_t sample = vertices_.sample[seed];
    const uint8_t level = level_[seed];
    group_[seed] = seed;
    next_[seed] = -1;
    kind_[seed] = kSingle;
    if (level == kSingle || (level == kSame && sample < 0)) return;
    const double part = level < kSame ? kPart[level] : 0;
    double radius = 0; // squared
    if (sample < 0 && vertices_.near[seed] >= 0) {
      const Vec3 d = model_.samples.position[vertices_.near[seed]] - vertices_.position[seed];
      radius = kCrustMerge * kCrustMerge * part * part * dot(d, d);
    }
    queue_.assign(1, seed);
    for (std::size_t k = 0; k < queue_.size(); ++k)
      for (int32_t code : crust_.vertices[queue_[k]].neighbor) {
        const int32_t w = code >> 2;
        if (code < 0 || group_[w] >= 0 || level_[w] == kSingle) continue;
        const bool same = sample >= 0 && vertices_.sample[w] == sample;
        if (!same) {
          if (vertices_.sample[w] >= 0 || level_[w] >= kSame) continue;
          if (sample >= 0) {
            if (vertices_.near[w] != sample || vertices_.pull[w] > kCrustPull * kPart[level_[w]])
              continue;
          } else {
            const Vec3 d = vertices_.position[w] - vertices_.position[seed];
            if (dot(d, d) > radius) continue;
          }
        }
        group_[w] = seed;
        next_[w] = next_[seed];
        next_[seed] = w;
        kind_[seed] = std::min(kind_[seed], same ? kSame : std::max(level, level_[w]));
        queue_.push_back(w);
      }
  }

  /// Groups at which a ring fails go to bad_: those it comes to twice, and near ones if it is
  /// folded.
  void check_ring(int32_t r) {
    reduce(r);
    corners_[r] = uint8_t(std::min<std::size_t>(polygon_.size(), 3));
    if (polygon_.size() < 3) return;
    bool near = false;
    for (int32_t g : polygon_) {
      near |= kind_[g] < kSame;
      if (ring_of_[g] == r) bad_.push_back(g);
      ring_of_[g] = r;
    }
    for (int32_t g : polygon_) ring_of_[g] = -1;
    if (near && folded(r))
      for (int32_t g : polygon_)
        if (kind_[g] < kSame) bad_.push_back(g);
  }

  /// Whether a group may become one vertex; if not, it goes to bad_.
  void check_group(int32_t g) {
    int euler = 0, inside = 0;
    link_.clear();
    ring_.clear();
    for (int32_t v = g; v >= 0; v = next_[v]) {
      ++euler;
      for (int32_t code : crust_.vertices[v].neighbor) {
        if (code < 0) continue;
        const int32_t other = group_[code >> 2];
        if (other == g) {
          ++inside;
        } else {
          if (edges_[other]++ == 0) link_.push_back(other);
        }
      }
      for (int32_t r : crust_.rings_at[v]) {
        if (r < 0 || corners_[r] >= 3 || ring_at_[r] == g) continue;
        ring_at_[r] = g;
        ring_.push_back(r);
      }
    }
    euler -= inside / 2;
    for (int32_t r : ring_) {
      ring_at_[r] = -1;
      if (corners_[r] == 0) {
        ++euler;
      } else { // edges that a digon joins are one
        reduce(r);
        --edges_[polygon_[polygon_[0] == g]];
      }
    }
    if (euler != 1 || pillow(g)) bad_.push_back(g);
    for (int32_t other : link_) {
      // More than one, or none: these two groups are the whole component, with digons all round.
      // Rather the one that is less than a sample gives way.
      if (edges_[other] != 1) bad_.push_back(kind_[other] < kind_[g] ? other : g);
      edges_[other] = 0;
    }
  }

  /// Whether group g and the two groups of link_ are a whole component: two triangles back to back.
  bool pillow(int32_t g) const {
    if (link_.size() != 2) return false;
    for (int32_t other : link_)
      for (int32_t v = other; v >= 0; v = next_[v])
        for (int32_t code : crust_.vertices[v].neighbor) {
          const int32_t w = code < 0 ? g : group_[code >> 2];
          if (w != g && w != link_[0] && w != link_[1]) return false;
        }
    return true;
  }

  /// The groups round ring r, neighbours that are the same made one.
  void reduce(int32_t r) {
    const Incidence &rings = crust_.rings;
    polygon_.clear();
    int32_t last = group_[rings.index[rings.offset[r + 1] - 1]];
    for (uint64_t i = rings.offset[r]; i < rings.offset[r + 1]; ++i) {
      const int32_t g = group_[rings.index[i]];
      if (g != last) polygon_.push_back(g);
      last = g;
    }
  }

  /// Whether polygon_ (of ring r) turns inwards at a corner.
  bool folded(int32_t r) const {
    const std::size_t size = polygon_.size();
    const Vec3 normal = unit(center(crust_.ring_outer[r]) - center(crust_.ring_inner[r]));
    const Vec3 origin = vertices_.position[polygon_[0]];
    Vec3 a = vertices_.position[polygon_[size - 2]], b = vertices_.position[polygon_[size - 1]];
    double area = 0;
    for (int32_t g : polygon_) {
      const Vec3 c = vertices_.position[g];
      const Vec3 u = b - a, v = c - b;
      const double turn = dot(cross(u, v), normal);
      if (turn < 0 && turn * turn > kCrustFold * kCrustFold * dot(u, u) * dot(v, v)) return true;
      area += dot(cross(b - origin, v), normal);
      a = b;
      b = c;
    }
    return !(area > 0);
  }

  Vec3 center(int32_t ball) const {
    return std::size_t(ball) < crust_.balls ? balls_[ball].center
                                            : crust_.corner[ball - crust_.balls];
  }

  /// The vertices of bad groups become pending, to be merged less.
  void dissolve(std::vector<int32_t> &pending) {
    pending.clear();
    for (int32_t g : bad_) {
      progress_.tick(1, 1);
      if (group_[g] != g || kind_[g] == kSingle) continue; // dissolved already, or nothing to undo
      const uint8_t level = uint8_t(kind_[g] + 1);
      for (int32_t v = g; v >= 0;) {
        const int32_t next = next_[v];
        level_[v] = std::max(level_[v], level);
        group_[v] = -1;
        next_[v] = -1;
        pending.push_back(v);
        v = next;
      }
    }
    std::sort(pending.begin(), pending.end());
  }

  const CrustComplex &crust_;
  const CrustVertices &vertices_;
  const std::vector<Ball> &balls_;
  const Model &model_;
  Progress &progress_;
  std::vector<int32_t> group_; // of each vertex: the vertex that names its group
  std::vector<int32_t> next_;  // of each vertex: another one of its group; -1: no more
  std::vector<uint8_t> level_; // of each vertex: how much it may be merged
  std::vector<uint8_t> kind_;  // of each group, by the vertex that names it: how much it is merged
  std::vector<int32_t> bad_;   // groups
  std::vector<uint8_t> corners_; // of each ring once merged: 0, 2, or 3 for more
  std::vector<int32_t> ring_at_; // of each ring: scratch of check_group()
  std::vector<int32_t> ring_of_; // of each group: scratch of check_ring()
  std::vector<int32_t> edges_;   // of each group: scratch of check_group()
  std::vector<int32_t> queue_, polygon_, link_, ring_;
};

} // namespace

CrustMesh merge_crust(const CrustComplex &crust, const CrustVertices &vertices,
                      const std::vector<Ball> &balls, const Model &model, Progress &progress) {
  Merging merging(crust, vertices, balls, model, progress);
  merging.run();
  return merging.mesh();
}

} // namespace vbm::impl
