// SPDX-License-Identifier: GPL-3.0-or-later
// The ball that touches a face at a probe and holds nothing of the mesh is found by shrinking it
// (Ma, Bae and Choi, "3D medial axis point approximation using nearest neighbors and the normal
// field", 2012). Where a face lies opposite the probe, next to the ball's far end, there is a wall.
// Unlike a ray alone, the ball tells the small faces round a plate from its large ones: a ray from
// its rim runs through the whole of it.
#include "sampling/thin_walls.h"

#include "core/progress.h"
#include "sampling/tolerances.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

/// Probes by area, along the triangles' longest sides, and by triangle (all fewer on fine meshes).
constexpr double kProbes = 1000, kMostProbes = 2000;
/// Probes' distances along a triangle's longest side, in parts of the whole shape's size.
constexpr double kProbesAcross = 40;
/// Ratio to the ball's radius: how near to the ball's far end the face opposite must be.
constexpr double kOpposite = 0.5;
/// Cosine (60 degrees): faces at a wall turn their backs at each other by at most this much.
constexpr double kBackToBack = 0.5;
/// Ratio to the spacing: where two faces meet at a tip nearer than this, it is no wall.
constexpr double kTipReach = 10;
/// Ratio to the probes' distance: how far a site reaches, so that nothing between two is left out.
constexpr double kSiteReach = 1.2;
/// Sites at sharp edges.
constexpr double kMostEdgeSites = 20000;
/// Steps of a shrinking ball; it takes three or four.
constexpr int kMostSteps = 24;

class Search {
public:
  Search(const TriangleMesh &mesh, const std::vector<Vec3> &position,
         const std::vector<Vec3> &face_normal, const TriangleTree &tree, const BuriedTest *buried,
         double most, Progress &progress)
      : mesh_(mesh), position_(position), face_normal_(face_normal), tree_(tree), buried_(buried),
        most_(most), progress_(progress) {}

  ThinWalls run() {
    probe_faces();
    if (!out_.site.empty()) mark_edges();
    return std::move(out_);
  }

private:
  struct Size {
    double area, longest;
    int from; // the corner the longest side begins at
  };

  Size size_of(std::size_t t) const {
    const Triangle &v = mesh_.triangle[t];
    Size size{length(cross(position_[v[1]] - position_[v[0]], position_[v[2]] - position_[v[0]])) /
                  2,
              0, 0};
    for (int c = 0; c < 3; ++c)
      if (const double l = distance(position_[v[c]], position_[v[(c + 1) % 3]]); l > size.longest)
        size.longest = l, size.from = c;
    return size;
  }

  void probe_faces() {
    Vec3 low = position_[0], high = position_[0];
    for (const Vec3 &p : position_)
      for (int a = 0; a < 3; ++a)
        low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
    const double step = distance(low, high) / kProbesAcross;
    double lengths = 0;
    for (std::size_t t = 0; t < mesh_.triangle.size(); ++t) {
      progress_.tick(0, 1);
      const Size size = size_of(t);
      out_.area += size.area;
      lengths += size.longest;
    }
    if (!(out_.area > 0) || !(step > 0)) return;
    const double all = kProbes + lengths / step + double(mesh_.triangle.size());
    const double share = std::min(1.0, kMostProbes / all);
    double due = 0.5;
    for (std::size_t t = 0; t < mesh_.triangle.size(); ++t) {
      progress_.tick(0, 1);
      const Size size = size_of(t);
      if (!(size.area > 0)) continue;
      due += share * (kProbes * size.area / out_.area + size.longest / step + 1);
      const double count = std::floor(due);
      due -= count;
      if (count > 0) probe_triangle(t, size, int(count), share);
    }
  }

  void probe_triangle(std::size_t t, const Size &size, int count, double share) {
    const Triangle &v = mesh_.triangle[t];
    const Vec3 a = position_[v[size.from]], b = position_[v[(size.from + 1) % 3]],
               c = position_[v[(size.from + 2) % 3]];
    const double across = std::sqrt(size.area / count), along = size.longest / count;
    // On a mesh with fewer probes than triangles each stands for its neighbours, too.
    const double apart = std::max({across, along, share < 1 ? size.longest : 0.0});
    for (int i = 0; i < count; ++i) {
      const double s = std::sqrt((i + 0.5) / count), r = (i + 0.5) * 0.6180339887498949;
      const double u = s * (r - std::floor(r));
      const Vec3 p = a + (b - a) * (s - u) + (c - a) * u;
      out_.probe.push_back({p, size.area / count});
      const double wall = thickness(p, face_normal_[t]);
      if (!(wall > 0)) continue;
      out_.thin_area += size.area / count;
      out_.thinnest = out_.site.empty() ? wall : std::min(out_.thinnest, wall);
      out_.site.push_back({p, wall / kSamplesThrough, std::max(wall, kSiteReach * apart)});
    }
  }

  /// The thickness of the wall at a point of a face; 0 where there is none, or no thin one.
  double thickness(const Vec3 &p, const Vec3 &normal) {
    progress_.tick_slow(0, 1);
    if (dot(normal, normal) == 0) return 0;
    const double thick = most_ * 2 * kSamplesThrough;
    double radius = thick / 2;
    bool touched = false;
    for (int step = 0; step < kMostSteps; ++step) {
      TriangleTree::Nearest found{radius * (1 - 1e-6), {}, -1};
      if (!tree_.nearest(p - normal * radius, found)) break;
      const Vec3 d = found.point - p;
      const double depth = -dot(normal, d);
      if (!(depth > kNearDuplicate)) return 0;
      radius = std::min(radius * (1 - 1e-6), dot(d, d) / (2 * depth));
      touched = true;
    }
    if (!touched) return 0;
    TriangleTree::Nearest found{kOpposite * radius, {}, -1};
    if (!tree_.nearest(p - normal * (2 * radius), found)) return 0;
    const Vec3 there = tree_.normal_at(found.point);
    const double wall = dot(normal, p - found.point), cosine = -dot(normal, there);
    if (!(wall > kNearDuplicate) || wall > thick || cosine < kBackToBack) return 0;
    const double half_angle = std::sqrt(std::max(0.0, 1 - cosine) / (1 + cosine)); // its tangent
    if (wall / 2 < half_angle * kTipReach * most_) return 0;
    if (buried_ && (buried_->buried(p, normal) || buried_->buried(found.point, there))) return 0;
    return wall;
  }

  /// Sharp convex edges, where sheets of the axis end: these need twice the samples.
  void mark_edges() {
    std::vector<int32_t> sharp;
    double length = 0;
    for (std::size_t i = 0; i < mesh_.edge.size(); ++i) {
      progress_.tick(0, 1);
      const Edge &e = mesh_.edge[i];
      if (e.faces() != 2) continue;
      const int32_t s = mesh_.side[e.begin] / 3, t = mesh_.side[e.begin + 1] / 3;
      if (dot(face_normal_[s], face_normal_[t]) > kGentle) continue;
      const Triangle &far = mesh_.triangle[t];
      const int32_t top = far[0] ^ far[1] ^ far[2] ^ e.a ^ e.b; // its third corner
      if (dot(face_normal_[s], position_[top] - position_[e.a]) >= 0) continue;
      sharp.push_back(int32_t(i));
      length += distance(position_[e.a], position_[e.b]);
    }
    const SpacingField walls(HUGE_VAL, out_.site);
    const double least = length / kMostEdgeSites;
    for (int32_t i : sharp) {
      const Vec3 a = position_[mesh_.edge[i].a], ab = position_[mesh_.edge[i].b] - a;
      const double all = vbm::impl::length(ab);
      for (double x = 0; x < all;) {
        progress_.tick(0, 1);
        double spacing = walls.at(a + ab * (x / all));
        const double step = std::min(all - x, std::max(least, kSamplesThrough * spacing));
        const Vec3 at = a + ab * ((x + step / 2) / all);
        spacing = walls.at(at);
        if (spacing / 2 < most_) {
          const double reach = kSamplesThrough * spacing + step / 2;
          out_.edge_site.push_back({at, spacing / 2, reach});
        }
        x += step > 0 ? step : all;
      }
    }
  }

  const TriangleMesh &mesh_;
  const std::vector<Vec3> &position_;
  const std::vector<Vec3> &face_normal_;
  const TriangleTree &tree_;
  const BuriedTest *buried_;
  double most_;
  Progress &progress_;
  ThinWalls out_;
};

} // namespace

ThinWalls find_thin_walls(const TriangleMesh &mesh, const std::vector<Vec3> &position,
                          const std::vector<Vec3> &face_normal, const TriangleTree &tree,
                          const BuriedTest *buried, double most, Progress &progress) {
  return Search(mesh, position, face_normal, tree, buried, most, progress).run();
}

} // namespace vbm::impl
