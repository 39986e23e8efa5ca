// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 8.3.4: a polygon round every vertex of the dual shape's hull. It differs where one polygon
// through the singular points would not be like its patch: where its middle would be farther from
// the sphere than `bulge`, the patch gets a vertex in its middle, or several; so do patches with
// more than one loop, or none. So balls that hardly overlap, or not at all, keep their bodies.
#include "ball_surface/patch_mesh.h"

#include "ball_surface/geodesic.h"
#include "ball_surface/sphere_patch.h"
#include "core/progress.h"
#include "core/sort_edges.h"
#include "dual/orthospheres.h"
#include "dual/wedges.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vbm::impl {
namespace {

/// Gaps, in bulges, up to which one vertex in the middle is enough: it divides the gap by four.
constexpr double kFanGap = 4;

/// Share of the shorter way round a face from one corner to another: where they are nearer than
/// that it is narrow.
constexpr double kNarrow = 0.5;

/// Steradians: triangles that cover so much more than is bare of their ball are on the wrong side
/// of a loop that runs the wrong way, as moved points make some do.
constexpr double kWrongSide = 3;

class Meshing {
public:
  Meshing(const PatchComplex &complex, const DualShape &shape, std::vector<int32_t> sample,
          const PatchOptions &options, Progress &progress)
      : c_(complex), shape_(shape), options_(options), progress_(progress),
        coarse_(geodesic_sphere(options.bulge)) {
    mesh_.position = complex.position;
    mesh_.sample = std::move(sample);
  }

  PatchMesh run() {
    start_.assign(c_.patches.size(), -1);
    for (std::size_t d = c_.darts.size(); d-- > 0;) start_[c_.darts[d].patch] = int32_t(d);
    seen_.assign(mesh_.position.size(), -1);
    side_.reserve(c_.darts.size());
    face_end_.reserve(c_.patches.size());
    face_patch_.reserve(c_.patches.size());
    for (std::size_t p = 0; p < c_.patches.size(); ++p) {
      progress_.tick(p, c_.patches.size());
      add_patch(int32_t(p));
    }
    split_shared_diagonals();
    mesh_.sample.resize(mesh_.position.size(), -1);
    return std::move(mesh_);
  }

private:
  /// A side of a face: the vertex it begins at, and the number of the diagonal it is, -1 if it is
  /// none: those lie within a patch with both ends on its border.
  struct Side {
    int32_t vertex;
    int32_t diagonal = -1;
  };

  const Geodesic &grid_of(int32_t ball) {
    if (!c_.wide(ball)) return coarse_;
    if (fine_.points.empty()) fine_ = geodesic_sphere(bulge_of(c_, options_, ball));
    return fine_;
  }

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
    const bool simple = patch.loops == 1 && !patch.wraps && is_simple(p);
    if (!simple || !add_disk(p, false)) build(p, simple);
  }

  /// Reads a patch's one loop; whether no vertex is in it twice.
  bool is_simple(int32_t p) {
    loop_.clear();
    bool simple = true;
    const int32_t first = start_[p];
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

  void add_face(const Side *side, std::size_t count, int32_t p) {
    side_.insert(side_.end(), side, side + count);
    face_end_.push_back(side_.size());
    face_patch_.push_back(p);
  }

  /// The patch of the loop that was read. Long ones are cut across where they are narrow until each
  /// piece may be one face, or get a vertex in its middle. False, and nothing added, if that leaves
  /// one that is too large for it, unless `any` is to do.
  bool add_disk(int32_t p, bool any) {
    const Site &ball = shape_.site[c_.patches[p].ball];
    const Vec3 c = center_of(ball);
    whole_.clear();
    for (int32_t v : loop_) whole_.push_back({v});
    const int32_t diagonals = diagonals_;
    const double share = bulge_of(c_, options_, c_.patches[p].ball);
    const double bulge = share * ball.r, most = 2 * std::sqrt(share) * ball.r;
    const bool pillow = is_pillow(p);
    // Most are one face, and nothing else is to be thought of.
    if (!pillow && ((any && whole_.size() == 3) || gap_of(whole_, ball) <= bulge)) {
      if (!any && !is_outward(whole_, c)) return false;
      add_face(whole_.data(), whole_.size(), p);
      return true;
    }
    std::vector<std::vector<Side>> stack(1, whole_), faces, fans;
    while (!stack.empty()) {
      std::vector<Side> piece = std::move(stack.back());
      stack.pop_back();
      const double gap = gap_of(piece, ball);
      const bool is_cut = diagonals_ > diagonals;
      if (pillow && (any || gap <= kFanGap * bulge)) {
        fans.push_back(std::move(piece));
      } else if (pillow) {
        return false;
      } else if (gap <= bulge ||
                 (piece.size() == 3 && (any || (is_cut && gap <= kFanGap * bulge)))) {
        faces.push_back(std::move(piece));
      } else if (bisect(piece, any ? ball.r : most, stack)) {
        continue;
      } else if (any || gap <= kFanGap * bulge) {
        fans.push_back(std::move(piece));
      } else {
        diagonals_ = diagonals;
        return false;
      }
    }
    // The middle of a large patch may be in another ball.
    const bool has_room = fans.empty() || pillow || c_.finer == 0 || !c_.wide(c_.patches[p].ball);
    if (!any && !(has_room && are_outward(faces, c) && are_star_shaped(fans, c))) {
      diagonals_ = diagonals;
      return false;
    }
    for (const std::vector<Side> &f : faces) add_face(f.data(), f.size(), p);
    for (const std::vector<Side> &f : fans) add_fan(f, unit(middle_of(f) - c), ball, p);
    return true;
  }

  /// How far a face's middle is from its ball, or may be on it from the face.
  double gap_of(const std::vector<Side> &face, const Site &ball) const {
    const Vec3 middle = middle_of(face);
    double far = 0;
    for (const Side &s : face) far = std::max(far, distance(mesh_.position[s.vertex], middle));
    return std::max(std::fabs(distance(middle, center_of(ball)) - ball.r),
                    far * far / (2 * ball.r));
  }

  bool is_outward(const Vec3 &p, const Vec3 &q, const Vec3 &r) const {
    return dot(cross(p, q), r) > 0;
  }

  /// Whether a face that is a triangle faces away from its ball's centre. Larger ones can be cut in
  /// other ways yet.
  bool is_outward(const std::vector<Side> &f, const Vec3 &c) const {
    return f.size() > 3 ||
           is_outward(mesh_.position[f[0].vertex] - c, mesh_.position[f[1].vertex] - c,
                      mesh_.position[f[2].vertex] - c);
  }

  bool are_outward(const std::vector<std::vector<Side>> &faces, const Vec3 &c) const {
    return std::all_of(faces.begin(), faces.end(),
                       [&](const std::vector<Side> &f) { return is_outward(f, c); });
  }

  /// Whether triangles between all sides and the middle do.
  bool are_star_shaped(const std::vector<std::vector<Side>> &fans, const Vec3 &c) const {
    for (const std::vector<Side> &f : fans) {
      const Vec3 middle = middle_of(f) - c;
      for (std::size_t i = 0; i < f.size(); ++i)
        if (!is_outward(mesh_.position[f[i].vertex] - c,
                        mesh_.position[f[(i + 1) % f.size()].vertex] - c, middle))
          return false;
    }
    return true;
  }

  Vec3 middle_of(const std::vector<Side> &face) const {
    Vec3 sum;
    for (const Side &s : face) sum += mesh_.position[s.vertex];
    return sum * (1.0 / double(face.size()));
  }

  /// Whether there is nothing but this patch and one more, with the same arcs round it: two faces
  /// with the same corners are none.
  bool is_pillow(int32_t p) const {
    const int32_t first = start_[p], other = c_.darts[c_.darts[first].twin].patch;
    if (other == p || c_.patches[other].darts != c_.patches[p].darts) return false;
    for (int32_t at = c_.darts[first].next; at != first; at = c_.darts[at].next)
      if (c_.darts[c_.darts[at].twin].patch != other) return false;
    return true;
  }

  /// Cuts a face in two where that is narrowest for its length; false if it is not narrow there, or
  /// wider than `most`, so that it needs points between its sides.
  bool bisect(const std::vector<Side> &face, double most, std::vector<std::vector<Side>> &out) {
    const std::size_t n = face.size();
    run_.assign(1, 0);
    for (std::size_t i = 0; i < n; ++i)
      run_.push_back(run_.back() + distance(mesh_.position[face[i].vertex],
                                            mesh_.position[face[(i + 1) % n].vertex]));
    double best = kNarrow;
    std::size_t from = 0, to = 0;
    for (std::size_t i = 0; i + 2 < n; ++i)
      for (std::size_t j = i + 2; j < n; ++j) {
        if (i == 0 && j + 1 == n) continue;
        const double half = std::min(run_[j] - run_[i], run_[n] - (run_[j] - run_[i]));
        const double width =
            distance(mesh_.position[face[i].vertex], mesh_.position[face[j].vertex]);
        if (width >= best * half || width > most) continue;
        best = width / half;
        from = i;
        to = j;
      }
    if (from == to) return false;
    std::vector<Side> first(face.begin() + from, face.begin() + to + 1), second;
    first.back().diagonal = diagonals_;
    second.assign(face.begin() + to, face.end());
    second.insert(second.end(), face.begin(), face.begin() + from + 1);
    second.back().diagonal = diagonals_++;
    out.push_back(std::move(second));
    out.push_back(std::move(first));
    return true;
  }

  void add_fan(const std::vector<Side> &face, const Vec3 &direction, const Site &ball, int32_t p) {
    const int32_t middle = add_vertex(ball, direction);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Side t[3] = {face[i], {face[(i + 1) % face.size()].vertex}, {middle}};
      add_face(t, 3, p);
    }
  }

  void add_sphere(int32_t p) {
    const int32_t first = int32_t(mesh_.position.size());
    const Geodesic &grid = grid_of(c_.patches[p].ball);
    for (const Vec3 &d : grid.points) add_vertex(shape_.site[c_.patches[p].ball], d);
    for (const auto &t : grid.triangles) {
      const Side side[3] = {{first + t[0]}, {first + t[1]}, {first + t[2]}};
      add_face(side, 3, p);
    }
  }

  /// Triangles of a patch that has several loops, or a large one, or one that touches itself.
  void build(int32_t p, bool simple) {
    const int32_t number = c_.patches[p].ball;
    const Site &ball = shape_.site[number];
    SpherePatch patch;
    std::vector<int32_t> corner, next; // next: of each corner, the one after it in its loop
    done_.resize(c_.darts.size(), 0);
    if (first_.empty()) list_darts();
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
    if (!triangulate_patch(patch, grid_of(number), built, progress_) ||
        solid_angle(patch, built) > c_.bare[number] + kWrongSide ||
        (built.points.empty() && simple && is_pillow(p))) {
      if (simple) {
        add_disk(p, true);
        return;
      }
      ring_patch(patch, patch_middle(patch, grid_of(number)), built);
    }
    const int32_t corners = int32_t(corner.size()), first = int32_t(mesh_.position.size());
    for (const Vec3 &d : built.points) add_vertex(ball, d);
    // Two corners may be one vertex: diagonals are told apart by their corners.
    std::map<std::pair<int32_t, int32_t>, int32_t> number_of;
    for (const std::array<int32_t, 3> &t : built.triangles) {
      Side side[3];
      for (int k = 0; k < 3; ++k) {
        const int32_t u = t[k], v = t[(k + 1) % 3];
        side[k] = {u < corners ? corner[u] : first + u - corners};
        if (u < corners && v < corners && next[u] != v)
          side[k].diagonal =
              number_of.emplace(std::minmax(u, v), diagonals_ + int32_t(number_of.size()))
                  .first->second;
      }
      add_face(side, 3, p);
    }
    diagonals_ += int32_t(number_of.size());
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
    int32_t low, high, diagonal, patch; // diagonal -1: an arc
  };

  /// Faces of two patches may have a side between the same two vertices, or where an arc is; but an
  /// edge has two faces. All but one of them get a vertex in their middle.
  void split_shared_diagonals() {
    const std::vector<int32_t> middle = middles();
    mesh_.polygons.index.reserve(side_.size());
    mesh_.polygons.offset.reserve(face_end_.size() + 1);
    mesh_.ball.reserve(face_end_.size());
    std::size_t at = 0;
    for (std::size_t f = 0; f < face_end_.size(); ++f) {
      progress_.tick(f, face_end_.size());
      for (; at < face_end_[f]; ++at) {
        mesh_.polygons.index.push_back(side_[at].vertex);
        const int32_t d = side_[at].diagonal;
        if (d >= 0 && middle[d] >= 0) mesh_.polygons.index.push_back(middle[d]);
      }
      mesh_.polygons.offset.push_back(mesh_.polygons.index.size());
      mesh_.ball.push_back(c_.patches[face_patch_[f]].ball);
    }
  }

  /// Per diagonal: the vertex in its middle, -1 if it has none.
  std::vector<int32_t> middles() {
    std::vector<int32_t> middle(diagonals_, -1);
    std::vector<Key> sides, keys;
    std::size_t at = 0;
    for (std::size_t f = 0; f < face_end_.size(); ++f) {
      const std::size_t first = at;
      for (; at < face_end_[f]; ++at) {
        const int32_t u = side_[at].vertex,
                      v = side_[at + 1 < face_end_[f] ? at + 1 : first].vertex;
        if (u <= v && side_[at].diagonal >= 0)
          sides.push_back({u, v, side_[at].diagonal, face_patch_[f]});
      }
    }
    if (sides.empty()) return middle;
    for (const PatchComplex::Dart &d : c_.darts) {
      const int32_t to = c_.to(d);
      if (d.from < to) keys.push_back({d.from, to, -1, -1});
    }
    keys.insert(keys.end(), sides.begin(), sides.end());
    progress_.tick_slow(1, 1);
    sort_edges(keys, mesh_.position.size(), progress_);
    progress_.tick_slow(1, 1);
    for (std::size_t i = 1; i < keys.size(); ++i) {
      const Key &k = keys[i];
      if (k.diagonal >= 0 && k.low == keys[i - 1].low && k.high == keys[i - 1].high &&
          middle[k.diagonal] < 0)
        middle[k.diagonal] = middle_of(k);
    }
    return middle;
  }

  int32_t middle_of(const Key &key) {
    const Site &ball = shape_.site[c_.patches[key.patch].ball];
    const Vec3 c = center_of(ball);
    const Vec3 d = unit((mesh_.position[key.low] - c) + (mesh_.position[key.high] - c));
    return add_vertex(ball, d);
  }

  const PatchComplex &c_;
  const DualShape &shape_;
  PatchOptions options_;
  Progress &progress_;
  Geodesic coarse_, fine_; // for wide balls, when there are any
  PatchMesh mesh_;
  std::vector<int32_t> start_;  // per patch: its first dart
  std::vector<uint32_t> first_; // per patch, in dart_, where that is asked for
  std::vector<int32_t> dart_, loop_, seen_;
  std::vector<Side> whole_;
  std::vector<uint8_t> done_;
  std::vector<uint32_t> edge_first_; // per ball, in edge_
  std::vector<int32_t> edge_;
  std::vector<double> run_;
  int32_t diagonals_ = 0;
  std::vector<Side> side_; // of faces, one after the other
  std::vector<std::size_t> face_end_;
  std::vector<int32_t> face_patch_;
};

} // namespace

PatchMesh patch_mesh(const PatchComplex &complex, const DualShape &shape,
                     std::vector<int32_t> sample, const PatchOptions &options, Progress &progress) {
  return Meshing(complex, shape, std::move(sample), options, progress).run();
}

} // namespace vbm::impl
