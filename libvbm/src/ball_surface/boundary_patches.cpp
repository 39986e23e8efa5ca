// SPDX-License-Identifier: GPL-3.0-or-later
// Where the thesis takes a vertex of the hull to have one polygon (8.3.4), every component of its
// sphere outside the other balls is a patch of its own, with as many loops of arcs as there are
// components of the shape round it; those are found by searching the tetrahedra outside the shape
// at the vertex.
#include "ball_surface/boundary_map.h"

#include "ball_surface/patch_area.h"
#include "core/progress.h"
#include "dual/orthospheres.h"
#include "dual/wedges.h"

#include <algorithm>
#include <utility>

namespace vbm::impl {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Steradians: a loop that turns the wrong way and has less on its left is of a patch that is
/// thinner than rounding.
constexpr double kWraps = 3.14;

/// Radians: an arc of more than that is not like its chord.
constexpr double kLongArc = 1;

class Patching {
public:
  Patching(BoundaryMap &map, const DualShape &shape, Progress &progress)
      : map_(map), shape_(shape), progress_(progress) {}

  void run() {
    const std::size_t sides = map_.next.size();
    std::vector<int32_t> loops(shape_.vertex.size(), 0);
    map_.patch_of.assign(sides, -1);
    std::vector<int32_t> doubtful; // patches whose angle is to tell whether they wrap
    for (std::size_t s = 0; s < sides; ++s) {
      progress_.tick(3 * sides + s, 4 * sides);
      if (map_.patch_of[s] >= 0) continue;
      const int32_t ball = map_.ball_of(shape_, int32_t(s)), patch = int32_t(map_.patches.size());
      if (!is_plain(int32_t(s), ball, patch)) doubtful.push_back(patch);
      map_.patches.push_back({ball, 1, false});
      first_.push_back(int32_t(s));
      map_.bare[ball] += 2 * kPi;
      ++loops[ball];
    }
    std::vector<int32_t> sum(loops);
    for (const DualShape::Edge &e : shape_.edges) {
      progress_.tick(1, 1);
      ++sum[e.a], ++sum[e.b];
    }
    std::vector<int32_t> alone; // balls without an edge
    for (std::size_t b = 0; b < sum.size(); ++b)
      if (shape_.vertex[b] && sum[b] == 0) alone.push_back(int32_t(b));
    join_split_links(loops, sum);
    for (int32_t p : doubtful) {
      progress_.tick(1, 1);
      if (map_.patches[p].loops == 1) map_.patches[p].wraps = wraps(first_[p]);
    }
    drop_joined();
    for (int32_t b : alone) {
      map_.patches.push_back({b, 0, true});
      map_.bare[b] = 4 * kPi;
    }
  }

private:
  /// Balls round which the shape is not connected: only these can have patches of several loops.
  /// Round a ball that is not hidden, a thickened shape has as many borders, which are the loops,
  /// as it has components and, together, independent cycles; and the difference of these is its
  /// Euler characteristic. `sum` is that of each ball's loops and edges.
  void join_split_links(const std::vector<int32_t> &loops, std::vector<int32_t> &sum) {
    if (std::none_of(loops.begin(), loops.end(), [](int32_t n) { return n > 1; })) return;
    for (const DualShape::Triangle &t : shape_.triangles) {
      progress_.tick(1, 1);
      for (int32_t b : t.ball) --sum[b];
    }
    for (std::size_t c = 0; c < shape_.cells.size(); ++c) {
      progress_.tick(1, 1);
      if (shape_.cell_in[c])
        for (int32_t b : shape_.cells[c].ball) ++sum[b];
    }
    std::vector<std::pair<int32_t, int32_t>> split; // ball, and a side of each of its loops
    for (std::size_t p = 0; p < map_.patches.size(); ++p) {
      const int32_t b = map_.patches[p].ball;
      if (sum[b] > 2 && loops[b] > 1) split.emplace_back(b, first_[p]);
    }
    std::sort(split.begin(), split.end());
    std::vector<int32_t> of_ball;
    for (std::size_t i = 0; i < split.size(); ++i) {
      progress_.tick(1, 1);
      of_ball.push_back(split[i].second);
      if (i + 1 < split.size() && split[i + 1].first == split[i].first) continue;
      join_loops(of_ball);
      of_ball.clear();
    }
  }

  /// Loops of one ball that are of one patch: between them there are only tetrahedra outside.
  void join_loops(const std::vector<int32_t> &loops) {
    const int32_t ball = map_.ball_of(shape_, loops[0]);
    mark_.resize(shape_.cells.size(), -1);
    std::vector<int32_t> stack, seen;
    for (int32_t loop : loops) {
      const BoundaryMap::Span &span = map_.spans[loop / 2];
      const DualShape::Edge &edge = shape_.edges[span.edge];
      const int32_t cell = span.turn == edge.end ? edge.cell : shape_.cell_of(span.turn);
      const int32_t patch = map_.patch_of[loop];
      if (mark_[cell] >= 0) {
        join(loop, mark_[cell]);
        continue;
      }
      stack.assign(1, cell);
      mark_[cell] = patch;
      seen.push_back(cell);
      while (!stack.empty()) {
        const int32_t at = stack.back();
        stack.pop_back();
        const PowerDiagram::Cell &c = shape_.cells[at];
        for (int k = 0; k < 4; ++k) {
          if (c.ball[k] == ball || (shape_.facet_in[at] >> k & 1)) continue;
          const int32_t there = c.neighbor[k] >> 2;
          if (mark_[there] >= 0) continue;
          mark_[there] = patch;
          seen.push_back(there);
          stack.push_back(there);
        }
      }
    }
    for (int32_t cell : seen) mark_[cell] = -1;
  }

  void join(int32_t loop, int32_t patch) {
    BoundaryMap::Patch &gone = map_.patches[map_.patch_of[loop]], &kept = map_.patches[patch];
    map_.bare[kept.ball] -= 4 * kPi;
    ++kept.loops;
    gone.loops = -1;
    for (int32_t at = loop; map_.patch_of[at] != patch; at = map_.next[at])
      map_.patch_of[at] = patch;
  }

  /// How a loop of a ball's runs round.
  struct Run {
    Vec3 normal, sum; // of triangles, and of corners from the ball's centre
    bool is_long;     // whether one of its arcs is

    bool is_right() const { return dot(normal, sum) > 0; }
  };

  /// Sets the patch of a loop's sides on the way.
  Run run_of(int32_t first, const Vec3 &c, int32_t patch) {
    const Vec3 origin = map_.position[map_.from[first]];
    Run run{{}, origin - c, map_.spans[first / 2].angle > kLongArc};
    map_.patch_of[first] = patch;
    Vec3 p, from; // the corner, and from the first one
    int32_t at = map_.next[first];
    if (at != first) p = map_.position[map_.from[at]], from = p - origin;
    while (at != first) {
      map_.patch_of[at] = patch;
      run.is_long |= map_.spans[at / 2].angle > kLongArc;
      at = map_.next[at];
      const Vec3 &q = map_.position[map_.from[at]];
      const Vec3 to = q - origin;
      run.normal += cross(from, to);
      run.sum += p - c;
      p = q;
      from = to;
    }
    return run;
  }

  /// Whether a loop is sure not to be that of a patch of more than half a sphere. It becomes a
  /// patch's.
  bool is_plain(int32_t first, int32_t ball, int32_t patch) {
    if (map_.from[first] < 0) {
      map_.patch_of[first] = patch;
      return false;
    }
    const Run run = run_of(first, center_of(shape_.site[ball]), patch);
    return run.is_right() && !run.is_long;
  }

  /// Whether a loop is that of a patch of more than half a sphere. One that turns the wrong way is,
  /// or its patch is thinner than rounding; where arcs are long their ends do not tell which way.
  bool wraps(int32_t first) {
    if (map_.from[first] < 0) { // a whole circle
      const DualShape::Edge &edge = shape_.edges[map_.spans[first / 2].edge];
      const Axis3 axis(shape_.site[edge.a], shape_.site[edge.b]);
      return (first & 1 ? axis.height_b : axis.height_a) >= 0;
    }
    const Vec3 c = center_of(shape_.site[map_.ball_of(shape_, first)]);
    const bool is_right = run_of(first, c, map_.patch_of[first]).is_right();
    return loop_angle(map_, shape_, first) > (is_right ? 2 * kPi : kWraps);
  }

  void drop_joined() {
    std::vector<int32_t> number(map_.patches.size());
    std::size_t kept = 0;
    for (std::size_t p = 0; p < map_.patches.size(); ++p) {
      number[p] = int32_t(kept);
      if (map_.patches[p].loops > 0) map_.patches[kept++] = map_.patches[p];
    }
    if (kept == map_.patches.size()) return;
    map_.patches.resize(kept);
    for (int32_t &p : map_.patch_of) p = number[p];
  }

  BoundaryMap &map_;
  const DualShape &shape_;
  Progress &progress_;
  std::vector<int32_t> first_; // of each patch, of each of its loops before they are joined: a side
  std::vector<int32_t> mark_;  // per cell: the patch that is searched from
};

} // namespace

void find_patches(BoundaryMap &map, const DualShape &shape, Progress &progress) {
  Patching(map, shape, progress).run();
}

} // namespace vbm::impl
