// SPDX-License-Identifier: GPL-3.0-or-later
// Where balls are many, as in a tube whose balls have their centres nearly on a line, what is bare
// of each is a strip that may go half round the tube and be a hundred times longer than wide. No
// polygon through a few of its points is like it: its two sides' chords cross. So a strip is closed
// as a zip is: where a corner comes near an arc across the patch, it and the arc's nearest point
// become one vertex, which cuts the patch in two; its ends become mouths, and those arcs.
//
// Only moves that keep the surface what it is are used (complex_editor.h), whatever the distances
// say. Each is made of a patch whose own corners ask for it, in the order of the patches.
#include "ball_surface/close_narrow.h"

#include "ball_surface/merge_points.h"
#include "core/progress.h"
#include "dual/orthospheres.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vbm::impl {
namespace {

/// Darts of a patch from which on only every so many corners are tried, so that it takes no square
/// of their number.
constexpr std::size_t kManyDarts = 64;

/// Shares of the reach: a corner nearer than this to an arc's end becomes one with that; and how
/// far what is to be contracted may stray from the patch.
constexpr double kEnd = 0.7, kAcross = 0.25;

/// Share of a product of squares: what it may err by, and a thousand times more.
constexpr double kUnsure = 1e-12;

class Closing {
public:
  Closing(ComplexEditor &editor, const std::vector<double> &reach, double bulge, Progress &progress)
      : editor_(editor), reach_(reach), bulge_(bulge), progress_(progress) {}

  void run() {
    contract_short_arcs(true);
    editor_.close(bulge_, progress_);
    PatchComplex &c = editor_.complex;
    rings();
    for (std::size_t p = 0; p < c.patches.size(); ++p) { // those that come of it, too
      progress_.tick(p, c.patches.size());
      if (c.patches[p].loops != 1 || c.patches[p].darts < 3 || c.patches[p].wraps) continue;
      loops_.assign(1, editor_.dart_of(int32_t(p)));
      zip_patch(int32_t(p));
    }
    editor_.close(bulge_, progress_);
    contract_short_arcs(false);
    editor_.close(bulge_, progress_);
    join_arcs();
  }

private:
  using Dart = PatchComplex::Dart;

  double reach_beside(const Dart &d) const { return reach_[editor_.complex.patches[d.patch].ball]; }
  double reach_at(const Dart &d) const {
    return std::min(reach_beside(d), reach_beside(editor_.complex.darts[d.twin]));
  }

  /// The first time, corners of patches where nothing is to be closed are made to stay.
  void contract_short_arcs(bool fixes) {
    PatchComplex &c = editor_.complex;
    struct Short {
      double length;
      int32_t dart;
    };
    std::vector<Short> arcs;
    for (std::size_t d = 0; d < c.darts.size(); ++d) {
      progress_.tick(d, c.darts.size());
      if (!editor_.alive(int32_t(d)) || c.darts[d].twin < int32_t(d)) continue;
      const Dart &dart = c.darts[d], &twin = c.darts[dart.twin];
      const double here = reach_beside(dart), there = reach_beside(twin);
      const int32_t u = editor_.from(int32_t(d)), v = editor_.from(dart.twin);
      if (fixes && here == 0) editor_.points.fix(u);
      if (fixes && there == 0) editor_.points.fix(v);
      const double l = distance(editor_.points.at(u), editor_.points.at(v));
      if (l <= std::min(here, there)) arcs.push_back({l, int32_t(d)});
    }
    std::sort(arcs.begin(), arcs.end(), [](const Short &a, const Short &b) {
      return a.length != b.length ? a.length < b.length : a.dart < b.dart;
    });
    for (const Short &s : arcs) {
      progress_.tick(1, 1);
      const int32_t u = editor_.from(s.dart), v = editor_.to(s.dart);
      if (!editor_.alive(s.dart) || u == v || is_round(s.dart)) continue;
      if (editor_.points.stays(u) && editor_.points.stays(v)) continue;
      if (editor_.points.reach_of(u, v) <= kDrift * reach_at(c.darts[s.dart]))
        editor_.contract(s.dart);
    }
  }

  /// Whether an arc with little between its ends goes all the way round.
  bool is_round(int32_t d) const {
    const PatchComplex::Arc &arc = editor_.complex.arcs[editor_.complex.darts[d].arc];
    return arc.to - arc.from > kRound;
  }

  /// Patches of two loops and more: each pair is joined where it is nearest.
  void rings() {
    const PatchComplex &c = editor_.complex;
    if (std::none_of(c.patches.begin(), c.patches.end(),
                     [](const PatchComplex::Patch &p) { return p.loops > 1; }))
      return;
    std::vector<std::pair<int32_t, int32_t>> starts; // patch, and a dart of each of its loops
    loop_.assign(c.darts.size(), -1);
    for (std::size_t d = 0; d < loop_.size(); ++d) {
      const int32_t p = c.darts[d].patch;
      if (c.patches[p].loops < 2 || !editor_.alive(int32_t(d)) || loop_[d] >= 0) continue;
      for (int32_t at = int32_t(d); loop_[at] < 0; at = c.darts[at].next)
        loop_[at] = int32_t(starts.size());
      starts.emplace_back(p, int32_t(d));
    }
    std::sort(starts.begin(), starts.end());
    loops_.clear();
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const int32_t p = starts[i].first;
      loops_.push_back(starts[i].second);
      if (i + 1 < starts.size() && starts[i + 1].first == p) continue;
      if (std::size_t(c.patches[p].loops) == loops_.size()) zip_patch(p);
      loops_.clear();
    }
  }

  /// A dart of a patch, and its chord.
  struct Piece {
    int32_t dart, loop, next; // the piece after it in its loop
    Vec3 from, to, along;
    double square;  // of the chord's length
    double sagitta; // or a little more
  };
  /// A corner that is near a piece across the patch.
  struct Near {
    double distance;
    int32_t corner, piece;
  };

  /// No less than the tangent of an angle from 0 to 1, by less than 0.06.
  static double most_tangent(double angle) { return angle * (1 + 0.5575 * angle * angle); }

  void read() {
    const PatchComplex &c = editor_.complex;
    pieces_.clear();
    for (std::size_t l = 0; l < loops_.size(); ++l) {
      const std::size_t first = pieces_.size();
      int32_t at = loops_[l];
      do { // where it ends the next begins
        pieces_.push_back({at,
                           int32_t(l),
                           int32_t(pieces_.size()) + 1,
                           editor_.points.at(editor_.from(at)),
                           {},
                           {},
                           0,
                           0});
        at = c.darts[at].next;
      } while (at != loops_[l]);
      pieces_.back().next = int32_t(first);
      for (std::size_t i = first; i < pieces_.size(); ++i) {
        Piece &piece = pieces_[i];
        const PatchComplex::Arc &arc = c.arcs[c.darts[piece.dart].arc];
        piece.to = pieces_[piece.next].from;
        piece.along = piece.to - piece.from;
        piece.square = dot(piece.along, piece.along);
        piece.sagitta =
            std::sqrt(piece.square) / 2 * most_tangent(std::min(arc.to - arc.from, 4.0) / 4);
      }
    }
  }

  /// The patch of the loops that these darts are of.
  void zip_patch(int32_t p) {
    const PatchComplex &c = editor_.complex;
    const double reach = reach_[c.patches[p].ball];
    read();
    find_near(reach, loops_.size() == 1);
    if (near_.empty()) return;
    find_planes(p);
    parts_.resize(std::max(parts_.size(), pieces_.size()));
    for (std::size_t i = 0; i < pieces_.size(); ++i) parts_[i].assign(1, pieces_[i].dart);
    std::sort(near_.begin(), near_.end(), [](const Near &a, const Near &b) {
      if (a.distance != b.distance) return a.distance < b.distance;
      return a.corner != b.corner ? a.corner < b.corner : a.piece < b.piece;
    });
    DisjointSets joined(loops_.size());
    for (const Near &n : near_) {
      progress_.tick(1, 1);
      const Piece &corner = pieces_[n.corner], &piece = pieces_[n.piece];
      if (!editor_.alive(corner.dart) || !editor_.alive(piece.dart)) continue;
      if (c.patches[c.darts[corner.dart].patch].loops > 1 &&
          joined.find(corner.loop) == joined.find(piece.loop))
        continue;
      const int32_t there = target(n, reach);
      if (there < 0) continue;
      editor_.zip(corner.dart, there);
      joined.unite(corner.loop, piece.loop);
    }
  }

  void find_near(double reach, bool disk) {
    near_.clear();
    const std::size_t n = pieces_.size(), step = 1 + n * n / (4 * kManyDarts * kManyDarts);
    for (std::size_t i = 0; i < n; i += step) {
      const Piece &a = pieces_[i];
      Near best{reach, int32_t(i), -1};
      for (std::size_t j = 0; j < n; ++j) {
        const Piece &b = pieces_[j];
        if (disk ? j == i || b.next == int32_t(i) : b.loop == a.loop) continue;
        if (!may_be_near(a.from, b, best.distance)) continue;
        double angle;
        const double gap = distance(a.from, nearest(a.from, b.dart, angle));
        if (gap < best.distance) best = {gap, int32_t(i), int32_t(j)};
      }
      if (best.piece >= 0) near_.push_back(best);
    }
  }

  static bool may_be_near(const Vec3 &x, const Piece &b, double reach) {
    const Vec3 w = x - b.from;
    const double l = b.square, s = dot(w, b.along), far = reach + b.sagitta;
    // Most are seen to be farther without a division, or a branch; by more than all rounding.
    const double most = dot(w, w) * l, within = std::min(std::max(s, 0.0), l);
    if (most - within * (2 * s - within) > far * far * l * (1 + kUnsure) + kUnsure * most)
      return false;
    const Vec3 gap = s <= 0 ? w : s >= l ? x - b.to : w - b.along * (s / l);
    return dot(gap, gap) <= far * far;
  }

  /// The point of a dart that is nearest, and its angle.
  Vec3 nearest(const Vec3 &x, int32_t d, double &angle) {
    const PatchComplex::Arc &arc = editor_.complex.arcs[editor_.complex.darts[d].arc];
    const PatchComplex::Circle &circle = editor_.complex.circles[arc.circle];
    const Vec3 w = x - circle.center;
    const Vec3 v = cross(circle.axis, circle.u);
    const double s = dot(w, v), c = dot(w, circle.u);
    constexpr double kTurn = 2 * 3.14159265358979323846;
    angle = std::atan2(s, c);
    angle += kTurn * std::ceil((arc.from - angle) / kTurn);
    if (angle <= arc.to) {
      const double h = 1 / std::sqrt(std::max(s * s + c * c, 1e-300)); // no need of cosine and sine
      return editor_.piece_point(d, angle, circle.center + circle.u * (c * h) + v * (s * h));
    }
    const bool end = angle - arc.to < arc.from + kTurn - angle;
    angle = end ? arc.to : arc.from;
    const bool head = end == editor_.complex.darts[d].forward;
    return editor_.points.at(head ? editor_.to(d) : editor_.from(d));
  }

  /// The corner across the patch for what is near to become one with, made where there is none; -1
  /// if it may not.
  int32_t target(const Near &n, double reach) {
    const PatchComplex &c = editor_.complex;
    const int32_t here = pieces_[n.corner].dart, u = editor_.from(here);
    const int32_t p = c.darts[here].patch;
    const Vec3 x = editor_.points.at(u);
    // Which part of what was the piece.
    int32_t d = -1;
    double angle = 0, gap = reach;
    for (int32_t part : parts_[n.piece]) {
      if (!editor_.alive(part) || c.darts[part].patch != p || part == here) continue;
      double there;
      const double away = distance(x, nearest(x, part, there));
      if (away > gap) continue;
      gap = away;
      angle = there;
      d = part;
    }
    if (d < 0) return -1;
    const Vec3 from = editor_.points.at(editor_.from(d)), to = editor_.points.at(editor_.to(d));
    const double to_from = distance(x, from), to_to = distance(x, to);
    const bool disk = c.patches[p].loops == 1;
    // One of its ends, where that is as near as may be.
    if (std::min(to_from, to_to) <= std::max(kEnd * reach, 1.01 * gap)) {
      const int32_t there = to_from <= to_to ? d : c.darts[d].next, v = editor_.from(there);
      if (v == u || (disk && (c.darts[here].next == there || c.darts[there].next == here)))
        return -1;
      if (editor_.points.stays(u) && editor_.points.stays(v)) return -1;
      if (editor_.points.reach_of(u, v) > kDrift * reach) return -1;
      return is_across(p, (x + editor_.points.at(v)) * 0.5, reach) ? there : -1;
    }
    if (disk && (c.darts[d].next == here || here == d)) return -1; // the arc before it
    const PatchComplex::Arc &arc = c.arcs[c.darts[d].arc];
    if (angle <= arc.from || angle >= arc.to || editor_.from(d) == u || editor_.to(d) == u)
      return -1;
    const Vec3 on = PatchComplex::point(c.circles[arc.circle], angle);
    if (!is_across(p, (x + editor_.piece_point(d, angle, on)) * 0.5, reach)) return -1;
    const int32_t made = editor_.split(d, angle, on);
    if (reach_at(c.darts[d]) == 0) editor_.points.fix(made);
    parts_[n.piece].push_back(c.darts[d].next);
    return c.darts[d].next;
  }

  /// The planes of a patch's circles.
  void find_planes(int32_t p) {
    const PatchComplex &c = editor_.complex;
    planes_.clear();
    int32_t last = -1;
    for (const Piece &b : pieces_) {
      const Dart &d = c.darts[b.dart];
      if (c.arcs[d.arc].circle == last) continue;
      last = c.arcs[d.arc].circle;
      const PatchComplex::Circle &circle = c.circles[last];
      const bool first = editor_.shape.edges[circle.edge].a == c.patches[p].ball;
      const Vec3 out = first ? circle.axis : -circle.axis;
      planes_.push_back({out, dot(out, circle.center)});
    }
  }

  /// Whether a place is in the patch, or as near as makes no difference.
  bool is_across(int32_t p, const Vec3 &x, double reach) const {
    const Site &ball = editor_.shape.site[editor_.complex.patches[p].ball];
    const Vec3 c = center_of(ball), on = c + unit(x - c) * ball.r;
    for (const Plane &plane : planes_)
      if (dot(plane.out, on) - plane.height > kAcross * reach) return false;
    return true;
  }

  /// Corners with two arcs, which were where a patch ended that is closed.
  void join_arcs() {
    PatchComplex &c = editor_.complex;
    std::vector<int32_t> arcs(editor_.points.size(), 0);
    for (std::size_t d = 0; d < c.darts.size(); ++d)
      if (editor_.alive(int32_t(d))) ++arcs[editor_.from(int32_t(d))];
    std::vector<float> off(c.darts.size(), 0); // how far from a dart corners are that it replaced
    for (std::size_t d = 0; d < c.darts.size(); ++d) {
      progress_.tick(d, c.darts.size());
      if (!editor_.alive(int32_t(d)) || arcs[editor_.from(int32_t(d))] != 2) continue;
      const int32_t before = c.darts[d].previous, t = c.darts[d].twin, after = c.darts[before].twin;
      if (c.darts[t].next != after || before == int32_t(d) || before == t) continue;
      const PatchComplex::Patch &p = c.patches[c.darts[d].patch], &q = c.patches[c.darts[t].patch];
      if (is_short_loop(int32_t(d)) || is_short_loop(t)) continue;
      const int32_t u = editor_.from(before), w = editor_.from(int32_t(d)),
                    v = editor_.to(int32_t(d));
      if (u == v || editor_.points.stays(w)) continue;
      const double gap = sag(int32_t(d), before, w);
      const double least = std::min(editor_.shape.site[p.ball].r, editor_.shape.site[q.ball].r);
      const double total = gap + std::max(off[d], off[before]);
      if (total > bulge_ * least) continue;
      editor_.join(int32_t(d));
      off[before] = off[t] = float(total);
    }
  }

  /// Whether it would be left with less than four darts.
  bool is_short_loop(int32_t d) const {
    const PatchComplex &c = editor_.complex;
    int32_t at = d;
    for (int k = 0; k < 4; ++k) {
      at = c.darts[at].next;
      if (at == d) return true;
    }
    return false;
  }

  double sag(int32_t d, int32_t before, int32_t w) {
    const Vec3 a = editor_.points.at(editor_.from(before)), b = editor_.points.at(editor_.to(d)),
               x = editor_.points.at(w);
    const Vec3 along = b - a;
    const double l = dot(along, along);
    const double s = l > 0 ? std::clamp(dot(x - a, along) / l, 0.0, 1.0) : 0;
    return distance(x, a + along * s);
  }

  ComplexEditor &editor_;
  const std::vector<double> &reach_;
  double bulge_;
  Progress &progress_;
  struct Plane {
    Vec3 out;
    double height;
  };
  std::vector<int32_t> loop_;  // by dart
  std::vector<int32_t> loops_; // of the patch at work: a dart of each
  std::vector<Piece> pieces_;
  std::vector<Near> near_;
  std::vector<std::vector<int32_t>> parts_; // of each piece: its darts since it was cut
  std::vector<Plane> planes_;
};

} // namespace

void close_narrow(ComplexEditor &editor, const std::vector<double> &reach, double bulge,
                  Progress &progress) {
  Closing(editor, reach, bulge, progress).run();
}

} // namespace vbm::impl
