// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons are cut as if they were plane (surface/triangulate.h), and long ones round a ball are
// not. Seen from the ball's centre they are simple (fine_arcs.h), so that constrained Delaunay
// triangles on the sphere are without folds.
#include "ball_surface/turn_outwards.h"

#include "ball_surface/sphere_patch.h"
#include "core/progress.h"
#include "dual/orthospheres.h"

#include <algorithm>

namespace vbm::impl {
namespace {

class Turning {
public:
  Turning(const PatchMesh &mesh, const DualShape &shape, Triangles &triangles, Progress &progress)
      : mesh_(mesh), shape_(shape), t_(triangles), progress_(progress) {}

  void run() {
    find_folded();
    if (folded_.empty()) return;
    for (Polygon &p : folded_) cut(p);
    drop_shared();
    for (const Polygon &p : folded_)
      std::copy(p.made.begin(), p.made.end(), t_.corners.begin() + std::ptrdiff_t(p.first));
  }

private:
  using Edge = std::array<int32_t, 2>; // the lower vertex first
  struct Polygon {
    int32_t number;
    std::size_t first;                        // of its triangles
    std::vector<std::array<int32_t, 3>> made; // in their place
    std::vector<Edge> diagonals;
  };

  bool is_outward(std::size_t t) const {
    const auto &c = t_.corners[t];
    const std::size_t known = mesh_.position.size();
    for (int32_t v : c)
      if (std::size_t(v) >= known) return true; // made of triangles round a middle
    const Vec3 o = center_of(shape_.site[mesh_.ball[t_.polygon[t]]]);
    const Vec3 &p = mesh_.position[c[0]];
    return dot(cross(mesh_.position[c[1]] - p, mesh_.position[c[2]] - p), p - o) > 0;
  }

  void find_folded() {
    std::size_t first = 0;
    for (std::size_t t = 0; t < t_.corners.size(); ++t) {
      progress_.tick(t, t_.corners.size());
      if (t_.polygon[t] != t_.polygon[first]) first = t;
      if (is_outward(t)) continue;
      const int32_t p = t_.polygon[t];
      const uint64_t corners = mesh_.polygons.offset[p + 1] - mesh_.polygons.offset[p];
      if (corners > 3 && (folded_.empty() || folded_.back().number != p))
        folded_.push_back({p, first, {}, {}});
    }
  }

  void cut(Polygon &p) {
    const Site &ball = shape_.site[mesh_.ball[p.number]];
    const uint64_t begin = mesh_.polygons.offset[p.number],
                   end = mesh_.polygons.offset[p.number + 1];
    const int32_t *corner = mesh_.polygons.index.data() + begin;
    const int32_t count = int32_t(end - begin);
    SpherePatch patch;
    patch.loops.emplace_back();
    for (int32_t i = 0; i < count; ++i)
      patch.loops[0].push_back(unit(mesh_.position[corner[i]] - center_of(ball)));
    PatchTriangles built;
    Geodesic no_points;
    no_points.spacing = 1;
    if (!triangulate_patch(patch, no_points, built, progress_) || !built.points.empty()) return;
    for (const auto &t : built.triangles) {
      p.made.push_back({corner[t[0]], corner[t[1]], corner[t[2]]});
      for (int k = 0; k < 3; ++k) {
        const int32_t i = t[k], j = t[(k + 1) % 3];
        if (i < j && j - i > 1 && j - i < count - 1)
          p.diagonals.push_back({std::min(corner[i], corner[j]), std::max(corner[i], corner[j])});
      }
    }
  }

  /// Polygons with a diagonal that is an edge elsewhere stay as they are.
  void drop_shared() {
    std::vector<std::pair<Edge, int32_t>> edges; // and the polygon's place in folded_
    std::vector<uint8_t> marked(mesh_.position.size(), 0);
    for (std::size_t i = 0; i < folded_.size(); ++i)
      for (const Edge &e : folded_[i].diagonals) {
        edges.push_back({e, int32_t(i)});
        marked[e[0]] = marked[e[1]] = 1;
      }
    std::sort(edges.begin(), edges.end());
    const auto drop = [&](int32_t i) { folded_[i].made.clear(); };
    for (std::size_t i = 1; i < edges.size(); ++i)
      if (edges[i].first == edges[i - 1].first) drop(edges[i].second);
    for (std::size_t t = 0; t < t_.corners.size(); ++t) {
      progress_.tick(t, t_.corners.size());
      for (int k = 0; k < 3; ++k) {
        const int32_t u = t_.corners[t][k], v = t_.corners[t][(k + 1) % 3];
        if (std::size_t(std::max(u, v)) >= marked.size() || !marked[u] || !marked[v]) continue;
        const Edge e{std::min(u, v), std::max(u, v)};
        for (auto at = std::lower_bound(edges.begin(), edges.end(), std::make_pair(e, int32_t(-1)));
             at != edges.end() && at->first == e; ++at)
          if (folded_[at->second].number != t_.polygon[t]) drop(at->second);
      }
    }
  }

  const PatchMesh &mesh_;
  const DualShape &shape_;
  Triangles &t_;
  Progress &progress_;
  std::vector<Polygon> folded_;
};

} // namespace

void turn_outwards(const PatchMesh &mesh, const DualShape &shape, Triangles &triangles,
                   Progress &progress) {
  Turning(mesh, shape, triangles, progress).run();
}

std::vector<std::size_t> folded_triangles(const PatchMesh &mesh, const Triangles &triangles,
                                          const std::vector<Ball> &balls, Progress &progress) {
  std::vector<std::size_t> folded;
  for (std::size_t t = 0; t < triangles.corners.size(); ++t) {
    progress.tick(t, triangles.corners.size());
    const auto &c = triangles.corners[t];
    const Vec3 &p = mesh.position[c[0]];
    const Vec3 normal = cross(mesh.position[c[1]] - p, mesh.position[c[2]] - p);
    if (!(dot(normal, p - balls[mesh.ball[triangles.polygon[t]]].center) > 0)) folded.push_back(t);
  }
  return folded;
}

} // namespace vbm::impl
