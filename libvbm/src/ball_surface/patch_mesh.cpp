// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 8.3.4: a polygon round every vertex of the dual shape's hull. It differs where one polygon
// through the singular points would not be like its patch: where its middle would be farther from
// the sphere than `bulge`, the patch gets a vertex in its middle, or several; so do patches with
// more than one loop, or none. So balls that hardly overlap, or not at all, keep their bodies.
#include "ball_surface/patch_mesh.h"

#include "ball_surface/geodesic.h"
#include "ball_surface/sphere_patch.h"
#include "core/progress.h"
#include "dual/orthospheres.h"
#include "dual/wedges.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

/// Gaps, in bulges, up to which one vertex in the middle is enough: it divides the gap by four.
constexpr double kFanGap = 4;

class Meshing {
public:
  Meshing(const PatchComplex &complex, const DualShape &shape, std::vector<int32_t> sample,
          const PatchOptions &options, Progress &progress)
      : c_(complex), shape_(shape), options_(options), progress_(progress),
        grid_(geodesic_sphere(options.bulge)) {
    mesh_.position = complex.position;
    mesh_.sample = std::move(sample);
  }

  PatchMesh run() {
    list_darts();
    seen_.assign(mesh_.position.size(), -1);
    for (std::size_t p = 0; p < c_.patches.size(); ++p) {
      progress_.tick(p, c_.patches.size());
      add_patch(int32_t(p));
    }
    split_shared_diagonals();
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      progress_.tick(t, triangles_.size());
      add_polygon(triangles_[t].vertex.data(), 3, c_.patches[triangles_[t].patch].ball);
    }
    mesh_.sample.resize(mesh_.position.size(), -1);
    return std::move(mesh_);
  }

private:
  struct Triangle {
    std::array<int32_t, 3> vertex;
    int32_t patch;
    uint8_t diagonals; // bit k: side k lies within the patch and has both ends on its border
  };

  /// Darts by patch.
  void list_darts() {
    first_.assign(c_.patches.size() + 1, 0);
    for (const PatchComplex::Dart &d : c_.darts) ++first_[d.patch + 1];
    for (std::size_t p = 0; p < c_.patches.size(); ++p) first_[p + 1] += first_[p];
    dart_.resize(c_.darts.size());
    std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t d = 0; d < c_.darts.size(); ++d) dart_[next[c_.darts[d].patch]++] = int32_t(d);
  }

  void add_patch(int32_t p) {
    const PatchComplex::Patch &patch = c_.patches[p];
    if (patch.loops == 0) {
      add_sphere(p);
      return;
    }
    if (patch.loops == 1 && !patch.wraps && is_simple(p)) {
      const Site &ball = shape_.site[patch.ball];
      Vec3 sum;
      for (int32_t v : loop_) sum += mesh_.position[v];
      const Vec3 middle = sum * (1.0 / double(loop_.size())) - center_of(ball);
      const double gap = std::fabs(length(middle) - ball.r), bulge = options_.bulge * ball.r;
      if (gap <= bulge) {
        add_polygon(loop_.data(), loop_.size(), patch.ball);
        return;
      }
      if (gap <= kFanGap * bulge) {
        add_fan(unit(middle), ball, patch.ball);
        return;
      }
    }
    build(p);
  }

  /// Reads a patch's one loop; whether no vertex is in it twice.
  bool is_simple(int32_t p) {
    loop_.clear();
    bool simple = true;
    const int32_t first = dart_[first_[p]];
    int32_t at = first;
    do {
      const int32_t v = c_.darts[at].from;
      simple &= seen_[v] != p;
      seen_[v] = p;
      loop_.push_back(v);
      at = c_.darts[at].next;
    } while (at != first);
    return simple && loop_.size() >= 3;
  }

  int32_t add_vertex(const Site &ball, const Vec3 &direction) {
    mesh_.position.push_back(center_of(ball) + direction * ball.r);
    return int32_t(mesh_.position.size()) - 1;
  }

  void add_polygon(const int32_t *vertex, std::size_t count, int32_t ball) {
    mesh_.polygons.index.insert(mesh_.polygons.index.end(), vertex, vertex + count);
    mesh_.polygons.offset.push_back(mesh_.polygons.index.size());
    mesh_.ball.push_back(ball);
  }

  void add_fan(const Vec3 &direction, const Site &ball, int32_t number) {
    const int32_t middle = add_vertex(ball, direction);
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      const int32_t t[3] = {loop_[i], loop_[(i + 1) % loop_.size()], middle};
      add_polygon(t, 3, number);
    }
  }

  void add_sphere(int32_t p) {
    const int32_t number = c_.patches[p].ball, first = int32_t(mesh_.position.size());
    for (const Vec3 &d : grid_.points) add_vertex(shape_.site[number], d);
    for (const auto &t : grid_.triangles)
      triangles_.push_back({{first + t[0], first + t[1], first + t[2]}, p, 0});
  }

  /// Triangles of a patch that has several loops, or a large one, or one that touches itself.
  void build(int32_t p) {
    const int32_t number = c_.patches[p].ball;
    const Site &ball = shape_.site[number];
    SpherePatch patch;
    std::vector<int32_t> corner, next; // next: of each corner, the one after it in its loop
    done_.resize(c_.darts.size(), 0);
    for (uint32_t i = first_[p]; i < first_[p + 1]; ++i) {
      if (done_[dart_[i]]) continue;
      patch.loops.emplace_back();
      for (int32_t at = dart_[i]; !done_[at]; at = c_.darts[at].next) {
        done_[at] = 1;
        corner.push_back(c_.darts[at].from);
        patch.loops.back().push_back(unit(mesh_.position[corner.back()] - center_of(ball)));
        next.push_back(int32_t(corner.size()));
      }
      next.back() = int32_t(corner.size() - patch.loops.back().size());
    }
    patch.caps = caps_of(number);
    PatchTriangles built;
    if (!triangulate_patch(patch, grid_, built, progress_))
      ring_patch(patch, patch_middle(patch, grid_), built);
    const int32_t corners = int32_t(corner.size()), first = int32_t(mesh_.position.size());
    for (const Vec3 &d : built.points) add_vertex(ball, d);
    for (std::array<int32_t, 3> t : built.triangles) {
      uint8_t diagonals = 0;
      for (int k = 0; k < 3; ++k) {
        const int32_t u = t[k], v = t[(k + 1) % 3];
        if (u < corners && v < corners && next[u] != v) diagonals |= uint8_t(1 << k);
      }
      for (int32_t &v : t) v = v < corners ? corner[v] : first + v - corners;
      triangles_.push_back({t, p, diagonals});
    }
  }

  /// What other balls cover of a sphere.
  std::vector<SpherePatch::Cap> caps_of(int32_t ball) {
    if (edge_first_.empty()) list_edges();
    std::vector<SpherePatch::Cap> caps;
    for (uint32_t i = edge_first_[ball]; i < edge_first_[ball + 1]; ++i) {
      const DualShape::Edge &e = shape_.edges[edge_[i]];
      const Axis3 axis(shape_.site[e.a], shape_.site[e.b]);
      if (e.a == ball)
        caps.push_back({axis.direction, axis.height_a / shape_.site[ball].r});
      else
        caps.push_back({-axis.direction, axis.height_b / shape_.site[ball].r});
    }
    return caps;
  }

  void list_edges() {
    edge_first_.assign(shape_.vertex.size() + 1, 0);
    for (const DualShape::Edge &e : shape_.edges) ++edge_first_[e.a + 1], ++edge_first_[e.b + 1];
    for (std::size_t b = 0; b < shape_.vertex.size(); ++b) edge_first_[b + 1] += edge_first_[b];
    edge_.resize(2 * shape_.edges.size());
    std::vector<uint32_t> next(edge_first_.begin(), edge_first_.end() - 1);
    for (std::size_t e = 0; e < shape_.edges.size(); ++e) {
      edge_[next[shape_.edges[e].a]++] = int32_t(e);
      edge_[next[shape_.edges[e].b]++] = int32_t(e);
    }
  }

  struct Key {
    int32_t low, high, patch; // patch -1: an arc
    bool same(const Key &k) const { return low == k.low && high == k.high; }
    bool operator<(const Key &k) const {
      if (low != k.low) return low < k.low;
      return high != k.high ? high < k.high : patch < k.patch;
    }
  };

  /// Triangles of two patches may have a side between the same two vertices, or where an arc is;
  /// but an edge has two faces. All but one of them get a vertex in their middle.
  void split_shared_diagonals() {
    if (triangles_.empty()) return;
    std::vector<Key> keys;
    for (const Triangle &t : triangles_)
      for (int k = 0; k < 3; ++k) {
        const int32_t u = t.vertex[k], v = t.vertex[(k + 1) % 3];
        if (u < v && (t.diagonals >> k & 1)) keys.push_back({u, v, t.patch});
      }
    if (keys.empty()) return;
    for (const PatchComplex::Dart &d : c_.darts) {
      const int32_t to = c_.to(d);
      if (d.from < to) keys.push_back({d.from, to, -1});
    }
    progress_.tick_slow(1, 1);
    std::sort(keys.begin(), keys.end());
    progress_.tick_slow(1, 1);
    std::vector<std::pair<Key, int32_t>> middle; // sides that are split, and their middles
    for (std::size_t i = 1; i < keys.size(); ++i)
      if (keys[i].patch >= 0 && keys[i].same(keys[i - 1]))
        middle.emplace_back(keys[i], middle_of(keys[i]));
    if (middle.empty()) return;
    std::vector<Triangle> old;
    old.swap(triangles_);
    for (const Triangle &t : old) {
      int32_t m[3];
      for (int k = 0; k < 3; ++k) {
        const int32_t u = t.vertex[k], v = t.vertex[(k + 1) % 3];
        const Key key{std::min(u, v), std::max(u, v), t.patch};
        const auto found = std::lower_bound(
            middle.begin(), middle.end(), key,
            [](const std::pair<Key, int32_t> &a, const Key &b) { return a.first < b; });
        const bool split = found != middle.end() && !(key < found->first);
        m[k] = split && (t.diagonals >> k & 1) ? found->second : -1;
      }
      emit(t.vertex[0], t.vertex[1], t.vertex[2], m[0], m[1], m[2], t.patch);
    }
  }

  int32_t middle_of(const Key &key) {
    const Site &ball = shape_.site[c_.patches[key.patch].ball];
    const Vec3 c = center_of(ball);
    const Vec3 d = unit((mesh_.position[key.low] - c) + (mesh_.position[key.high] - c));
    return add_vertex(ball, d);
  }

  void emit(int32_t a, int32_t b, int32_t c, int32_t ab, int32_t bc, int32_t ca, int32_t patch) {
    if (ab >= 0) {
      emit(a, ab, c, -1, -1, ca, patch);
      emit(ab, b, c, -1, bc, -1, patch);
    } else if (bc >= 0) {
      emit(b, bc, a, -1, -1, -1, patch);
      emit(bc, c, a, -1, ca, -1, patch);
    } else if (ca >= 0) {
      emit(c, ca, b, -1, -1, -1, patch);
      emit(ca, a, b, -1, -1, -1, patch);
    } else {
      triangles_.push_back({{a, b, c}, patch, 0});
    }
  }

  const PatchComplex &c_;
  const DualShape &shape_;
  PatchOptions options_;
  Progress &progress_;
  Geodesic grid_;
  PatchMesh mesh_;
  std::vector<uint32_t> first_; // per patch, in dart_
  std::vector<int32_t> dart_, loop_, seen_;
  std::vector<uint8_t> done_;
  std::vector<uint32_t> edge_first_; // per ball, in edge_
  std::vector<int32_t> edge_;
  std::vector<Triangle> triangles_;
};

} // namespace

PatchMesh patch_mesh(const PatchComplex &complex, const DualShape &shape,
                     std::vector<int32_t> sample, const PatchOptions &options, Progress &progress) {
  return Meshing(complex, shape, std::move(sample), options, progress).run();
}

} // namespace vbm::impl
