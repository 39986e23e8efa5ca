// SPDX-License-Identifier: GPL-3.0-or-later
// What makes the surface free of crossings: points of a ball's patches lie in its power cell, which
// is convex, so that its triangles stay in there and cross no other ball's. Those of one ball are
// seen apart from its centre (sphere_patch.h) if the chords of its patches' borders are, which is
// what is seen to here. Where nothing was moved it can be had always: arcs do not cross, and chords
// are the nearer to them the shorter they are.
#include "ball_surface/fine_arcs.h"

#include "core/progress.h"
#include "dual/orthospheres.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

/// A ball's chords are looked through so often; each time those that cross are halved.
constexpr int kRounds = 40;

/// Radians: pieces shorter than this are not cut any more.
constexpr double kShortest = 1e-6;

/// Ratio to the number of arcs at first: a ball gets no more pieces than that, and some.
constexpr std::size_t kMostPieces = 8, kSomePieces = 200;

/// Below this a determinant of unit vectors may have any sign.
constexpr double kRounding = 1e-15;

/// Length of the mean of directions: less than that and a loop's do not tell its way round.
constexpr double kCompact = 0.8;

/// Ratio to how far arcs are from their chords: chords reach no farther beyond each other than that
/// where arcs do not cross; if they do, points have been moved and shorter chords are no help.
constexpr double kSlack = 1.5;

/// Ratio to the same: ends that were moved farther may be what is wrong.
constexpr double kStill = 0.1;

/// Squared: ends nearer than this are one.
constexpr double kSamePlace = 1e-24;

/// Below this a determinant of unit vectors is not surely positive, and a corner not on the left.
constexpr double kLeft = 1e-12;

/// Ratio of the distance of two patches' middles to how far they reach: with more than the square
/// root of 2, no two chords' diametral balls meet.
constexpr double kApart = 1.42;

/// A ball with more patches is not looked at pair by pair.
constexpr int kManyPatches = 8;

struct Chord {
  int32_t dart;
  Vec3 from, to, middle; // from the ball's centre, in radii; middle is not on the sphere
  double half, low;      // its length, halved; the least x of where it may be
};

/// How far beyond each other chords reach that cross: the least distance, in radii, of an end from
/// the other's great circle. Negative if they do not.
double overlap(const Chord &a, const Chord &b) {
  const double reach = a.half + b.half;
  const Vec3 gap = a.middle - b.middle;
  if (dot(gap, gap) > reach * reach) return -1;
  const auto same = [](const Vec3 &p, const Vec3 &q) { return dot(p - q, p - q) < kSamePlace; };
  if (same(a.from, b.from) || same(a.from, b.to) || same(a.to, b.from) || same(a.to, b.to))
    return -1;
  const auto depth = [](const Vec3 &p, const Vec3 &q, const Vec3 &r, const Vec3 &s) {
    const Vec3 n = cross(p, q);
    const double u = dot(n, r), v = dot(n, s);
    if ((u > kRounding && v > kRounding) || (u < -kRounding && v < -kRounding)) return -1.0;
    return std::min(std::fabs(u), std::fabs(v)) / std::max(length(n), kRounding);
  };
  const double first = depth(a.from, a.to, b.from, b.to);
  if (first < 0) return -1;
  const double second = depth(b.from, b.to, a.from, a.to);
  return second < 0 ? -1 : std::min(first, second);
}

class Uncrossing {
public:
  Uncrossing(ComplexEditor &editor, Progress &progress) : editor_(editor), progress_(progress) {}

  void run() {
    const std::size_t balls = editor_.shape.vertex.size();
    darts_.resize(balls);
    listed_.assign(balls, 0);
    most_.assign(balls, 0);
    queued_.assign(balls, 0);
    find_doubtful();
    list_darts();
    std::vector<int32_t> work;
    for (std::size_t b = balls; b-- > 0;)
      if (darts_[b].size() > 2) queue(int32_t(b), work);
    while (!work.empty()) {
      progress_.tick(1, 2);
      const int32_t b = work.back();
      work.pop_back();
      queued_[b] = 0;
      clear(b, work);
    }
  }

private:
  int32_t ball_of(int32_t d) const {
    return editor_.complex.patches[editor_.complex.darts[d].patch].ball;
  }

  /// What is known of a ball's patch that is easily seen to be free of crossings, from the ball's
  /// centre and in radii.
  struct Place {
    Vec3 middle;
    double reach;
  };

  /// Most patches are small and seen wholly from their first corners, and each ball's are apart. Of
  /// the other balls all chords are to be looked at.
  void find_doubtful() {
    const PatchComplex &c = editor_.complex;
    const std::size_t balls = listed_.size();
    first_patch_.assign(balls, -1);
    next_patch_.assign(c.patches.size(), -1);
    std::vector<Place> place(c.patches.size());
    for (std::size_t p = 0; p < c.patches.size(); ++p) {
      progress_.tick(1, 2);
      const PatchComplex::Patch &patch = c.patches[p];
      if (patch.loops <= 0) continue;
      uint8_t &doubtful = listed_[patch.ball];
      doubtful =
          doubtful || patch.loops > 1 || patch.wraps || !is_star_shaped(int32_t(p), place[p]);
      int count = 0;
      for (int32_t q = first_patch_[patch.ball]; q >= 0 && !doubtful; q = next_patch_[q]) {
        const double reach = kApart * (place[p].reach + place[q].reach);
        const Vec3 gap = place[p].middle - place[q].middle;
        doubtful = dot(gap, gap) <= reach * reach || ++count > kManyPatches;
      }
      next_patch_[p] = first_patch_[patch.ball];
      first_patch_[patch.ball] = int32_t(p);
    }
  }

  /// Whether all corners of a patch's one loop are left of its first chord, and seen one after the
  /// other from the first corner; and the loop runs the right way round.
  bool is_star_shaped(int32_t p, Place &place) {
    const PatchComplex &c = editor_.complex;
    const Site &ball = editor_.shape.site[c.patches[p].ball];
    const Vec3 center = center_of(ball);
    const int32_t first = editor_.dart_of(p);
    corner_.clear();
    int32_t at = first;
    do {
      corner_.push_back(unit(editor_.points.at(editor_.from(at)) - center));
      at = c.darts[at].next;
    } while (at != first);
    const std::size_t n = corner_.size();
    if (n < 3) return false;
    const Vec3 side = cross(corner_[0], corner_[1]);
    Vec3 sum = corner_[0] + corner_[1], turn = side;
    Vec3 from = side; // the plane of the first corner and the last one seen
    for (std::size_t i = 2; i < n; ++i) {
      if (dot(side, corner_[i]) < kLeft || dot(from, corner_[i]) < kLeft) return false;
      from = cross(corner_[0], corner_[i]);
      sum += corner_[i];
      turn += cross(corner_[i - 1], corner_[i]);
    }
    turn += cross(corner_[n - 1], corner_[0]);
    place.middle = sum * (1.0 / double(n));
    place.reach = 0;
    for (const Vec3 &x : corner_) {
      const Vec3 gap = x - place.middle;
      place.reach = std::max(place.reach, dot(gap, gap));
    }
    place.reach = std::sqrt(place.reach);
    return dot(turn, sum) > 0;
  }

  void list_darts() {
    for (std::size_t d = 0; d < editor_.complex.darts.size(); ++d) {
      progress_.tick(1, 2);
      if (editor_.alive(int32_t(d)) && listed_[ball_of(int32_t(d))])
        darts_[ball_of(int32_t(d))].push_back(int32_t(d));
    }
    for (std::size_t b = 0; b < darts_.size(); ++b)
      most_[b] = kMostPieces * darts_[b].size() + kSomePieces;
  }

  /// Of a ball that was not doubtful: its patches have one loop each.
  void list_ball(int32_t b) {
    listed_[b] = 1;
    for (int32_t p = first_patch_[b]; p >= 0; p = next_patch_[p]) {
      const int32_t first = editor_.dart_of(p);
      int32_t at = first;
      do {
        darts_[b].push_back(at);
        at = editor_.complex.darts[at].next;
      } while (at != first);
    }
    most_[b] = kMostPieces * darts_[b].size() + kSomePieces;
  }

  void queue(int32_t b, std::vector<int32_t> &work) {
    if (queued_[b]) return;
    queued_[b] = 1;
    work.push_back(b);
  }

  /// Cuts a ball's arcs until their chords are apart, or that cannot be had.
  void clear(int32_t b, std::vector<int32_t> &work) {
    for (int round = 0; round < kRounds; ++round) {
      progress_.tick(1, 2);
      find_crossing(b);
      if (cut_.empty()) find_reversed(b);
      if (cut_.empty()) return;
      bool any = false;
      for (int32_t d : cut_) any |= halve(d, work);
      if (!any || darts_[b].size() > most_[b]) return;
    }
  }

  /// Of each two chords that cross, the one that is farther from its arc.
  void find_crossing(int32_t b) {
    const double r = editor_.shape.site[b].r;
    read(b);
    cut_.clear();
    for (std::size_t i = 0; i < chords_.size(); ++i)
      for (std::size_t j = i + 1; j < chords_.size(); ++j) {
        if (chords_[j].low > chords_[i].middle.x + chords_[i].half) break;
        const double depth = overlap(chords_[i], chords_[j]);
        if (depth < 0) continue;
        const int32_t a = chords_[i].dart, c = chords_[j].dart;
        const double sa = sagitta(a), sc = sagitta(c);
        const double most = std::max(sa, sc);
        if (depth * r <= kSlack * most && std::max(moved(a), moved(c)) <= kStill * most)
          cut_.push_back(sa >= sc ? a : c);
      }
    std::sort(cut_.begin(), cut_.end());
    cut_.erase(std::unique(cut_.begin(), cut_.end()), cut_.end());
  }

  /// Of thin patches whose chords run round them the wrong way, those that are farthest from their
  /// arcs: an arc may curve more than the one across.
  void find_reversed(int32_t b) {
    const double r = editor_.shape.site[b].r;
    const PatchComplex &c = editor_.complex;
    std::sort(chords_.begin(), chords_.end(), [&](const Chord &p, const Chord &q) {
      const int32_t a = c.darts[p.dart].patch, b = c.darts[q.dart].patch;
      return a != b ? a < b : p.dart < q.dart;
    });
    for (std::size_t i = 0, end = 0; i < chords_.size(); i = end) {
      const int32_t p = c.darts[chords_[i].dart].patch;
      Vec3 turn, sum;
      for (end = i; end < chords_.size() && c.darts[chords_[end].dart].patch == p; ++end) {
        turn += cross(chords_[end].from, chords_[end].to);
        sum += chords_[end].from;
      }
      if (c.patches[p].loops != 1 || c.patches[p].wraps || dot(turn, sum) > 0 ||
          length(sum) < kCompact * double(end - i))
        continue;
      double most = 0, round = 0, off = 0;
      for (std::size_t k = i; k < end; ++k) {
        most = std::max(most, sagitta(chords_[k].dart));
        off = std::max(off, moved(chords_[k].dart));
        round += 2 * chords_[k].half;
      }
      // It is that wide, the wrong way.
      if (length(turn) / round * r > kSlack * most || off > kStill * most) continue;
      for (std::size_t k = i; k < end; ++k)
        if (2 * sagitta(chords_[k].dart) >= most) cut_.push_back(chords_[k].dart);
    }
  }

  void read(int32_t b) {
    const Site &ball = editor_.shape.site[b];
    const Vec3 c = center_of(ball);
    chords_.clear();
    for (int32_t d : darts_[b]) {
      Chord chord;
      chord.dart = d;
      chord.from = unit(editor_.points.at(editor_.from(d)) - c);
      chord.to = unit(editor_.points.at(editor_.to(d)) - c);
      chord.middle = (chord.from + chord.to) * 0.5;
      chord.half = distance(chord.from, chord.to) / 2;
      chord.low = chord.middle.x - chord.half;
      chords_.push_back(chord);
    }
    std::sort(chords_.begin(), chords_.end(), [](const Chord &p, const Chord &q) {
      return p.low != q.low ? p.low < q.low : p.dart < q.dart;
    });
  }

  double moved(int32_t d) {
    return std::max(editor_.points.moved(editor_.from(d)), editor_.points.moved(editor_.to(d)));
  }

  double sagitta(int32_t d) const {
    const PatchComplex::Arc &arc = editor_.complex.arcs[editor_.complex.darts[d].arc];
    const double angle = arc.to - arc.from;
    if (angle < kShortest) return 0;
    return length(editor_.complex.circles[arc.circle].u) * (1 - std::cos(std::min(angle, 6.0) / 2));
  }

  bool halve(int32_t d, std::vector<int32_t> &work) {
    PatchComplex &c = editor_.complex;
    const PatchComplex::Arc &arc = c.arcs[c.darts[d].arc];
    if (arc.to - arc.from < kShortest) return false;
    const int32_t t = c.darts[d].twin, other = ball_of(t);
    const bool known = listed_[other];
    editor_.split(d, (arc.from + arc.to) / 2);
    darts_[ball_of(d)].push_back(c.darts[d].next);
    if (known)
      darts_[other].push_back(c.darts[t].next);
    else
      list_ball(other);
    queue(other, work);
    return true;
  }

  ComplexEditor &editor_;
  Progress &progress_;
  std::vector<std::vector<int32_t>> darts_; // of each ball that is listed
  std::vector<uint8_t> listed_;
  std::vector<int32_t> first_patch_, next_patch_; // by ball; by patch
  std::vector<Vec3> corner_;
  std::vector<std::size_t> most_;
  std::vector<uint8_t> queued_;
  std::vector<Chord> chords_;
  std::vector<int32_t> cut_;
};

} // namespace

void refine_arcs(ComplexEditor &editor, const PatchOptions &options, Progress &progress) {
  PatchComplex &c = editor.complex;
  const auto ball_of = [&](int32_t d) { return c.patches[c.darts[d].patch].ball; };
  const std::size_t count = c.darts.size();
  for (std::size_t i = 0; i < count; ++i) {
    progress.tick(i, count);
    if (!editor.alive(int32_t(i)) || c.darts[i].twin < int32_t(i)) continue;
    const int32_t a = ball_of(int32_t(i)), b = ball_of(c.darts[i].twin);
    if (!c.wide(a) && !c.wide(b)) continue;
    int32_t d = c.darts[i].forward ? int32_t(i) : c.darts[i].twin;
    if (!c.darts[d].forward) continue; // sides that were made one and run against each other
    const PatchComplex::Arc arc = c.arcs[c.darts[d].arc];
    const double r = length(c.circles[arc.circle].u), angle = arc.to - arc.from;
    const double sagitta = std::min(bulge_of(c, options, a) * editor.shape.site[a].r,
                                    bulge_of(c, options, b) * editor.shape.site[b].r);
    if (r * (1 - std::cos(std::min(angle, 6.0) / 2)) <= sagitta) continue;
    const double most = 2 * std::acos(std::max(-1.0, 1 - sagitta / r));
    const int n = int(std::ceil(angle / most - 1e-9));
    for (int k = 1; k < n; ++k) {
      editor.split(d, arc.from + angle * k / n);
      d = c.darts[d].next;
    }
  }
}

void uncross_chords(ComplexEditor &editor, Progress &progress) {
  Uncrossing(editor, progress).run();
}

} // namespace vbm::impl
