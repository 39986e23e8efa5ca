// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 7.4 and 8.3.3: where four balls or more meet in one point, several triangles give the same
// singular point, and they are told to be the same by incidence: their balls touch one sample. Of
// bare lists of balls nothing is known but their numbers; there an arc that is shorter than what
// the balls' changed radii can have moved its ends by is one point.
//
// It differs in that nothing is merged that would change the surface: arcs are contracted one by
// one, none that ends where it begins, so that the surface stays what it is; a disk with one arc
// round it is contracted, and one with two is closed like a mouth. What stands at one place and
// hangs together in no such way are two vertices: that is how places where the surface touches
// itself are kept apart.
#include "ball_surface/merge_points.h"

#include "core/disjoint_sets.h"
#include "core/progress.h"
#include "dual/orthospheres.h"

#include <algorithm>
#include <numeric>

namespace vbm::impl {

int32_t TouchedSamples::common(const DualShape &shape, int32_t code) const {
  if (!lists) return -1;
  const DualShape::Triangle &t = shape.triangles[code / 2];
  const int32_t *at[3], *end[3];
  for (int i = 0; i < 3; ++i) {
    const int32_t b = (*ball)[t.ball[i]];
    at[i] = lists->index.data() + lists->offset[b];
    end[i] = lists->index.data() + lists->offset[b + 1];
  }
  while (at[0] != end[0] && at[1] != end[1] && at[2] != end[2]) {
    const int32_t most = std::max({*at[0], *at[1], *at[2]});
    if (*at[0] == most && *at[1] == most && *at[2] == most) {
      const Vec3 a = center_of(shape.site[t.ball[0]]), b = center_of(shape.site[t.ball[1]]),
                 c = center_of(shape.site[t.ball[2]]);
      const double over = dot(cross(b - a, c - a), (*position)[most] - a);
      if (code & 1 ? over >= 0 : over <= 0) return most;
      ++at[0];
      continue;
    }
    for (int i = 0; i < 3; ++i)
      while (at[i] != end[i] && *at[i] < most) ++at[i];
  }
  return -1;
}

namespace {

class Merge {
public:
  Merge(PatchComplex &complex, const DualShape &shape, const PatchOptions &options,
        Progress &progress)
      : c_(complex), shape_(shape), options_(options), progress_(progress),
        place_(complex.position.size()), alive_(complex.darts.size(), 1) {}

  std::size_t run(const TouchedSamples &touched, std::vector<int32_t> &sample) {
    sample.assign(c_.position.size(), -1);
    for (std::size_t v = 0; v < c_.singular_points; ++v) {
      progress_.tick(v, 3 * c_.singular_points);
      sample[v] = touched.common(shape_, c_.code[v]);
    }
    std::size_t merged = contract(sample);
    // Patches left with one or two darts, and those that become so when these are taken out.
    list_first_darts();
    for (std::size_t p = 0; p < c_.patches.size(); ++p) look_at(int32_t(p));
    while (!work_.empty()) {
      progress_.tick(1, 2);
      const int32_t p = work_.back();
      work_.pop_back();
      if (c_.patches[p].loops == 1 && c_.patches[p].darts == 1)
        fill_loop(p);
      else if (c_.patches[p].loops == 1 && c_.patches[p].darts == 2)
        close_mouth(p);
    }
    for (PatchComplex::Dart &d : c_.darts) d.from = place_.find(d.from);
    split_double_arcs();
    compact(sample);
    return merged;
  }

private:
  using Dart = PatchComplex::Dart;

  /// Whether an arc is nothing but two names for its place.
  bool is_null(const Dart &d, const std::vector<int32_t> &sample) const {
    const int32_t u = d.from, v = c_.darts[d.twin].from;
    if (std::size_t(u) >= c_.singular_points || std::size_t(v) >= c_.singular_points) return false;
    if (sample[u] >= 0 && sample[v] >= 0) return sample[u] == sample[v];
    return distance(c_.position[u], c_.position[v]) <= c_.blur[u] + c_.blur[v];
  }

  std::size_t contract(const std::vector<int32_t> &sample) {
    std::size_t merged = 0;
    for (std::size_t d = 0; d < c_.darts.size(); d += 2) {
      progress_.tick(c_.darts.size() + d, 3 * c_.darts.size());
      const Dart &dart = c_.darts[d];
      if (!is_null(dart, sample)) continue;
      // A vertex that is a sample keeps its place; else the one that is known better gives it.
      const int32_t u = place_.find(dart.from), v = place_.find(c_.darts[d + 1].from);
      if (u == v) continue;
      place_.unite(u, v);
      ++merged;
      take_out(int32_t(d));
      take_out(int32_t(d) + 1);
    }
    return merged;
  }

  /// Leave a dart out of its loop.
  void take_out(int32_t d) {
    Dart &dart = c_.darts[d];
    c_.darts[dart.previous].next = dart.next;
    c_.darts[dart.next].previous = dart.previous;
    alive_[d] = 0;
    --c_.patches[dart.patch].darts;
  }

  void list_first_darts() {
    first_.assign(c_.patches.size(), -1);
    for (std::size_t d = 0; d < c_.darts.size(); ++d)
      if (alive_[d] && first_[c_.darts[d].patch] < 0) first_[c_.darts[d].patch] = int32_t(d);
  }

  /// A dart of a patch that has one or two.
  int32_t dart_of(int32_t p) {
    if (first_[p] >= 0 && alive_[first_[p]]) return first_[p];
    // Its first dart went: what was its neighbours' is found from there.
    int32_t at = first_[p];
    for (std::size_t steps = 0; !alive_[at] && steps < c_.darts.size(); ++steps)
      at = c_.darts[at].next;
    return first_[p] = at;
  }

  void look_at(int32_t p) {
    if (c_.patches[p].loops == 1 && c_.patches[p].darts <= 2 && c_.patches[p].darts > 0)
      work_.push_back(p);
  }

  /// A disk with one arc round it becomes the point its arc begins and ends at.
  void fill_loop(int32_t p) {
    const int32_t d = dart_of(p), t = c_.darts[d].twin, q = c_.darts[t].patch;
    PatchComplex::Patch &other = c_.patches[q];
    if (other.loops == 1 && other.darts == 1) return; // nothing else there: stays
    const bool alone = c_.darts[t].next == t;         // one of several loops
    take_out(d);
    c_.patches[p].loops = -1;
    take_out(t);
    if (alone) {
      --other.loops;
      if (other.loops == 1) list_first_darts();
    }
    look_at(q);
  }

  /// A disk with two arcs round it becomes an arc, unless it is wide.
  void close_mouth(int32_t p) {
    const int32_t d = dart_of(p), e = c_.darts[d].next;
    const int32_t t = c_.darts[d].twin, u = c_.darts[e].twin;
    if (t == e || (c_.darts[t].next == u && c_.darts[u].next == t))
      return; // nothing else there, or the other's whole loop: stays
    if (c_.patches[p].wraps) return;
    const Site &ball = shape_.site[c_.patches[p].ball];
    if (distance(middle(c_.darts[d]), middle(c_.darts[e])) > options_.bulge * ball.r) return;
    take_out(d);
    take_out(e);
    c_.patches[p].loops = -1;
    c_.darts[t].twin = u;
    c_.darts[u].twin = t;
  }

  Vec3 middle(const Dart &d) const {
    const PatchComplex::Arc &arc = c_.arcs[d.arc];
    return arc_point(shape_, arc, (arc.from + arc.to) / 2);
  }

  /// Arcs that end where they begin, or where another one does: all but the first get a vertex in
  /// their middle, or two.
  void split_double_arcs() {
    struct Key {
      int32_t low, high, dart;
    };
    std::vector<Key> keys;
    for (std::size_t d = 0; d < c_.darts.size(); ++d) {
      if (!alive_[d] || c_.darts[d].twin < int32_t(d)) continue;
      const int32_t u = c_.darts[d].from, v = c_.to(c_.darts[d]);
      keys.push_back({std::min(u, v), std::max(u, v), int32_t(d)});
    }
    progress_.tick_slow(2, 3);
    std::sort(keys.begin(), keys.end(), [](const Key &a, const Key &b) {
      if (a.low != b.low) return a.low < b.low;
      return a.high != b.high ? a.high < b.high : a.dart < b.dart;
    });
    for (std::size_t k = 0; k < keys.size(); ++k) {
      progress_.tick(2 * keys.size() + k, 3 * keys.size());
      const Key &key = keys[k];
      const bool loop = key.low == key.high;
      const bool again = k > 0 && keys[k - 1].low == key.low && keys[k - 1].high == key.high;
      if (loop) split(key.dart);
      if (loop || again) split(key.dart);
    }
  }

  /// Put a vertex in the middle of a dart and its twin: it and its twin end and begin there.
  void split(int32_t d) {
    const int32_t t = c_.darts[d].twin;
    const int32_t m = int32_t(c_.position.size()), d2 = int32_t(c_.darts.size()), t2 = d2 + 1;
    PatchComplex::Arc near = c_.arcs[c_.darts[d].arc], far = near;
    const double half = (near.from + near.to) / 2;
    c_.position.push_back(arc_point(shape_, near, half));
    c_.blur.push_back(0);
    const bool forward = c_.darts[d].forward;
    (forward ? near.to : near.from) = half; // from d's beginning to the middle
    (forward ? far.from : far.to) = half;
    const int32_t near_arc = int32_t(c_.arcs.size());
    c_.arcs.push_back(near);
    c_.arcs.push_back(far);
    // d: u to m, d2: m to v; t: v to m, t2: m to u.
    Dart second = c_.darts[d], back = c_.darts[t];
    const bool same_arc = c_.darts[d].arc == c_.darts[t].arc;
    second.from = back.from = m;
    second.twin = t;
    back.twin = d;
    c_.darts[d].arc = near_arc;
    second.arc = near_arc + 1;
    if (same_arc) {
      back.arc = near_arc;
      c_.darts[t].arc = near_arc + 1;
    }
    second.previous = d;
    back.previous = t;
    c_.darts.push_back(second);
    c_.darts.push_back(back);
    alive_.resize(c_.darts.size(), 1);
    c_.darts[c_.darts[d].next].previous = d2;
    c_.darts[d].next = d2;
    c_.darts[d].twin = t2;
    c_.darts[c_.darts[t].next].previous = t2;
    c_.darts[t].next = t2;
    c_.darts[t].twin = d2;
    ++c_.patches[c_.darts[d].patch].darts;
    ++c_.patches[c_.darts[t].patch].darts;
  }

  /// Number what is left.
  void compact(std::vector<int32_t> &sample) {
    std::vector<int32_t> dart(c_.darts.size(), -1), patch(c_.patches.size(), -1);
    std::size_t patches = 0, darts = 0;
    for (std::size_t p = 0; p < c_.patches.size(); ++p) {
      if (c_.patches[p].loops < 0) continue;
      patch[p] = int32_t(patches);
      c_.patches[patches++] = c_.patches[p];
    }
    c_.patches.resize(patches);
    std::vector<uint8_t> used(c_.position.size(), 0);
    for (std::size_t d = 0; d < c_.darts.size(); ++d)
      if (alive_[d]) {
        dart[d] = int32_t(darts++);
        used[c_.darts[d].from] = 1;
      }
    // A place is where its best known point is.
    sample.resize(c_.position.size(), -1);
    std::vector<int32_t> best(c_.position.size());
    std::iota(best.begin(), best.end(), 0);
    for (std::size_t v = 0; v < singular_; ++v) {
      int32_t &b = best[place_.find(int32_t(v))];
      if (sample[b] < 0 && (sample[v] >= 0 || c_.blur[v] < c_.blur[b])) b = int32_t(v);
    }
    std::vector<int32_t> vertex(c_.position.size(), -1), new_sample;
    std::vector<Vec3> position;
    for (std::size_t v = 0; v < c_.position.size(); ++v) {
      if (!used[v]) continue;
      vertex[v] = int32_t(position.size());
      position.push_back(c_.position[best[v]]);
      new_sample.push_back(sample[best[v]]);
    }
    c_.position = std::move(position);
    sample = std::move(new_sample);
    for (std::size_t d = 0; d < c_.darts.size(); ++d) {
      if (!alive_[d]) continue;
      Dart moved = c_.darts[d];
      moved.from = vertex[moved.from];
      moved.next = dart[moved.next];
      moved.previous = dart[moved.previous];
      moved.twin = dart[moved.twin];
      moved.patch = patch[moved.patch];
      c_.darts[dart[d]] = moved;
    }
    c_.darts.resize(darts);
    c_.blur.clear();
    c_.code.clear();
  }

  PatchComplex &c_;
  const DualShape &shape_;
  PatchOptions options_;
  Progress &progress_;
  DisjointSets place_; // vertices that became one
  std::vector<uint8_t> alive_;
  std::vector<int32_t> first_, work_; // per patch one of its darts; patches to look at
  std::size_t singular_ = c_.singular_points;
};

} // namespace

std::size_t merge_points(PatchComplex &complex, const DualShape &shape, const PatchOptions &options,
                         const TouchedSamples &touched, std::vector<int32_t> &sample,
                         Progress &progress) {
  return Merge(complex, shape, options, progress).run(touched, sample);
}

} // namespace vbm::impl
