// SPDX-License-Identifier: GPL-3.0-or-later
// Surgery of maps on surfaces: arcs are contracted, patches cut in two or closed, in ways that keep
// the surface what it is, whatever the places of its points.
#include "ball_surface/complex_editor.h"

#include "core/progress.h"
#include "dual/orthospheres.h"

#include <algorithm>

namespace vbm::impl {

ComplexEditor::ComplexEditor(PatchComplex &c, const DualShape &dual, const BoundaryMap &map,
                             MergedPoints vertices)
    : complex(c), shape(dual), points(std::move(vertices)), singular_(map.position),
      alive_(c.darts.size(), 1) {
  list_first_darts();
}

bool ComplexEditor::contract(int32_t d) {
  const int32_t u = from(d), v = to(d), twin = complex.darts[d].twin;
  if (u == v) return false;
  points.unite(u, v);
  take_out(d);
  take_out(twin);
  look_at(complex.darts[d].patch);
  look_at(complex.darts[twin].patch);
  return true;
}

int32_t ComplexEditor::zip(int32_t d, int32_t e) {
  LargeList<Dart> &darts = complex.darts;
  points.unite(from(d), from(e));
  const int32_t p = darts[d].patch, before_d = darts[d].previous, before_e = darts[e].previous;
  const bool disk = complex.patches[p].loops == 1;
  darts[before_d].next = e;
  darts[e].previous = before_d;
  darts[before_e].next = d;
  darts[d].previous = before_e;
  if (!disk) {
    --complex.patches[p].loops;
    return -1;
  }
  const int32_t fresh = int32_t(complex.patches.size());
  PatchComplex::Patch second = complex.patches[p];
  second.darts = 0;
  for (int32_t at = e; darts[at].patch != fresh; at = darts[at].next) {
    darts[at].patch = fresh;
    ++second.darts;
  }
  // Only one side of a wide disk can be wide, and neither is where it is nearly closed.
  second.wraps = false;
  complex.patches[p].darts -= second.darts;
  complex.patches.push_back(second);
  first_.push_back(e);
  first_[p] = d;
  look_at(p);
  look_at(fresh);
  return fresh;
}

void ComplexEditor::take_out(int32_t d) {
  Dart &dart = complex.darts[d];
  complex.darts[dart.previous].next = dart.next;
  complex.darts[dart.next].previous = dart.previous;
  alive_[d] = 0;
  --complex.patches[dart.patch].darts;
  if (first_[dart.patch] == d) first_[dart.patch] = dart.next;
}

void ComplexEditor::list_first_darts() {
  first_.assign(complex.patches.size(), -1);
  for (std::size_t d = 0; d < complex.darts.size(); ++d)
    if (alive_[d] && first_[complex.darts[d].patch] < 0)
      first_[complex.darts[d].patch] = int32_t(d);
}

int32_t ComplexEditor::dart_of(int32_t p) {
  // A whole loop of several may be gone: then the others' darts are looked for.
  if (first_[p] >= 0 && (!alive_[first_[p]] || complex.darts[first_[p]].patch != p))
    list_first_darts();
  return first_[p];
}

void ComplexEditor::look_at(int32_t p) {
  const PatchComplex::Patch &patch = complex.patches[p];
  if (patch.loops == 1 && patch.darts <= 2 && patch.darts > 0) work_.push_back(p);
}

void ComplexEditor::close(double bulge, Progress &progress) {
  while (!work_.empty()) {
    progress.tick(1, 2);
    const int32_t p = work_.back();
    work_.pop_back();
    if (complex.patches[p].loops == 1 && complex.patches[p].darts == 1)
      fill_loop(p);
    else if (complex.patches[p].loops == 1 && complex.patches[p].darts == 2)
      close_mouth(p, bulge);
  }
}

/// A disk with one arc round it becomes the point its arc begins and ends at.
void ComplexEditor::fill_loop(int32_t p) {
  const int32_t d = dart_of(p), t = complex.darts[d].twin, q = complex.darts[t].patch;
  PatchComplex::Patch &other = complex.patches[q];
  if (other.loops == 1 && other.darts == 1) return; // nothing else there: stays
  if (complex.patches[p].wraps) return;             // all but a point of its ball: stays
  const bool alone = complex.darts[t].next == t;    // one of several loops
  take_out(d);
  complex.patches[p].loops = -1;
  const int32_t before = complex.darts[t].previous;
  take_out(t);
  if (alone)
    --other.loops;
  else
    trim(before);
  look_at(q);
}

/// What is left of an arc with the same patch all round it: it ends nowhere.
void ComplexEditor::trim(int32_t d) {
  LargeList<Dart> &darts = complex.darts;
  while (alive_[d] && darts[d].next == darts[d].twin) {
    const int32_t t = darts[d].twin, before = darts[d].previous;
    PatchComplex::Patch &patch = complex.patches[darts[d].patch];
    if (before == t) { // nothing else in this loop: the patch is whole there
      alive_[d] = alive_[t] = 0;
      patch.darts -= 2;
      --patch.loops;
      if (patch.loops == 0) patch.wraps = true;
      return;
    }
    contract(d);
    d = before;
  }
}

/// A disk with two arcs round it becomes an arc, unless it is wide.
void ComplexEditor::close_mouth(int32_t p, double bulge) {
  LargeList<Dart> &darts = complex.darts;
  const int32_t d = dart_of(p), e = darts[d].next, t = darts[d].twin, u = darts[e].twin;
  if (t == e) { // nothing else there
    trim(d);
    return;
  }
  if (darts[t].next == u && darts[u].next == t) return; // the other's whole loop: stays
  if (complex.patches[p].wraps) return;
  const auto middle = [&](int32_t i) {
    const PatchComplex::Arc &arc = complex.arcs[darts[i].arc];
    return piece_point(i, (arc.from + arc.to) / 2);
  };
  const double most = std::min(bulge, kMostNarrow) * shape.site[complex.patches[p].ball].r;
  if (distance(middle(d), middle(e)) > most) return;
  take_out(d);
  take_out(e);
  complex.patches[p].loops = -1;
  darts[t].twin = u;
  darts[u].twin = t;
  trim(t);
  trim(u);
}

Vec3 ComplexEditor::piece_point(int32_t d, double angle) {
  return piece_point(d, angle, PatchComplex::point(complex.circle(complex.darts[d]), angle));
}

Vec3 ComplexEditor::piece_point(int32_t d, double angle, const Vec3 &p) {
  const Dart &dart = complex.darts[d];
  const PatchComplex::Arc &arc = complex.arcs[dart.arc];
  const int32_t begin = dart.forward ? from(d) : to(d), end = dart.forward ? to(d) : from(d);
  const double span = arc.to - arc.from, w = span > 0 ? (angle - arc.from) / span : 0;
  const Vec3 moved_begin = points.at(begin) - place(arc.begin),
             moved_end = points.at(end) - place(arc.end);
  return p + moved_begin * (1 - w) + moved_end * w;
}

/// Two copies of an arc, the part a dart begins with and the rest.
void ComplexEditor::divide(PatchComplex::Arc &near, PatchComplex::Arc &far, bool forward,
                           double angle, const Vec3 &p) {
  const int32_t number = int32_t(singular_.size() + complex.position.size());
  complex.position.push_back(p);
  PatchComplex::Arc &low = forward ? near : far, &high = forward ? far : near;
  low.to = high.from = angle;
  low.end = high.begin = number;
}

int32_t ComplexEditor::split(int32_t d, double angle) {
  return split(d, angle, PatchComplex::point(complex.circle(complex.darts[d]), angle));
}

int32_t ComplexEditor::split(int32_t d, double angle, const Vec3 &p) {
  LargeList<Dart> &darts = complex.darts;
  const int32_t t = darts[d].twin, d2 = int32_t(darts.size()), t2 = d2 + 1;
  const int32_t m = points.add(piece_point(d, angle, p));
  PatchComplex::Arc near = complex.arcs[darts[d].arc], far = near;
  const double span = near.to - near.from;
  const double part =
      span > 0 ? (darts[d].forward ? angle - near.from : near.to - angle) / span : 0.5;
  divide(near, far, darts[d].forward, angle, p);
  const int32_t near_arc = int32_t(complex.arcs.size());
  complex.arcs.push_back(near);
  complex.arcs.push_back(far);
  // d: u to m, d2: m to v; t: v to m, t2: m to u. Twins of a closed mouth keep the arc they were
  // on for what they know of it, but it is the same piece from here on.
  const bool along = complex.darts[t].forward == !complex.darts[d].forward &&
                     complex.darts[t].arc == complex.darts[d].arc;
  Dart second = darts[d], back = darts[t];
  second.from = back.from = m;
  second.twin = t;
  back.twin = d;
  darts[d].arc = near_arc;
  second.arc = near_arc + 1;
  if (along) {
    back.arc = near_arc;
    darts[t].arc = near_arc + 1;
  } else {
    const PatchComplex::Arc whole = complex.arcs[darts[t].arc];
    // As far along it, from t's end.
    const double share = part < 1e-9 || part > 1 - 1e-9 ? 0.5 : part;
    const double there = darts[t].forward ? whole.to - share * (whole.to - whole.from)
                                          : whole.from + share * (whole.to - whole.from);
    PatchComplex::Arc first = whole, last = whole; // t's: to the vertex, and on from there
    divide(first, last, darts[t].forward, there,
           PatchComplex::point(complex.circles[whole.circle], there));
    darts[t].arc = int32_t(complex.arcs.size());
    back.arc = darts[t].arc + 1;
    complex.arcs.push_back(first);
    complex.arcs.push_back(last);
  }
  second.previous = d;
  back.previous = t;
  darts.push_back(second);
  darts.push_back(back);
  alive_.resize(darts.size(), 1);
  darts[darts[d].next].previous = d2;
  darts[d].next = d2;
  darts[d].twin = t2;
  darts[darts[t].next].previous = t2;
  darts[t].next = t2;
  darts[t].twin = d2;
  ++complex.patches[darts[d].patch].darts;
  ++complex.patches[darts[t].patch].darts;
  return m;
}

void ComplexEditor::join(int32_t d) {
  // before: u to w, d: w to v; on the other side t: v to w, after: w to u.
  LargeList<Dart> &darts = complex.darts;
  const int32_t before = darts[d].previous, t = darts[d].twin, after = darts[before].twin;
  const PatchComplex::Arc &a = complex.arcs[darts[before].arc], &b = complex.arcs[darts[d].arc];
  if (a.circle == b.circle && darts[before].forward == darts[d].forward) {
    const PatchComplex::Arc &low = a.from < b.from ? a : b, &high = a.from < b.from ? b : a;
    const PatchComplex::Arc both{a.circle, low.begin, high.end, low.from, high.to};
    if (darts[t].arc == darts[d].arc) darts[t].arc = int32_t(complex.arcs.size());
    darts[before].arc = int32_t(complex.arcs.size());
    complex.arcs.push_back(both);
  }
  take_out(d);
  take_out(after);
  darts[before].twin = t;
  darts[t].twin = before;
}

void ComplexEditor::split_double_arcs(Progress &progress) {
  struct Arc {
    int32_t high, next; // its upper end, and the arc before it with the same lower one
  };
  struct Key {
    int32_t low, high, dart;
    bool operator<(const Key &other) const {
      if (low != other.low) return low < other.low;
      return high != other.high ? high < other.high : dart < other.dart;
    }
  };
  constexpr int kLongChain = 64;
  std::vector<int32_t> last(points.size(), -1); // by lower end
  LargeList<Arc> arcs;
  std::vector<Key> keys; // of arcs that are loops, or have the ends of one before
  std::vector<Key> many; // of those whose chains are long: told by sorting
  arcs.reserve(complex.darts.size() / 2);
  for (std::size_t d = 0; d < complex.darts.size(); ++d) {
    progress.tick(d, complex.darts.size());
    if (!alive_[d] || complex.darts[d].twin < int32_t(d)) continue;
    const int32_t u = from(int32_t(d)), v = to(int32_t(d));
    const int32_t low = std::min(u, v), high = std::max(u, v);
    int32_t same = u == v ? 0 : last[low];
    int steps = 0;
    while (same >= 0 && u != v && arcs[same].high != high && ++steps < kLongChain)
      same = arcs[same].next;
    if (steps == kLongChain) {
      many.push_back({low, high, int32_t(d)});
      continue;
    }
    if (same >= 0) {
      keys.push_back({low, high, int32_t(d)});
      continue;
    }
    arcs.push_back({high, last[low]});
    last[low] = int32_t(arcs.size()) - 1;
  }
  // Of two in long chains the first may be in the chain; those all came before the others.
  if (!many.empty()) {
    std::vector<uint8_t> is_long(points.size(), 0);
    for (const Key &key : many) is_long[key.low] = 1;
    for (std::size_t v = 0; v < last.size(); ++v)
      for (int32_t a = is_long[v] ? last[v] : -1; a >= 0; a = arcs[a].next)
        many.push_back({int32_t(v), arcs[a].high, -1});
    progress.tick_slow(0, 1);
    std::sort(many.begin(), many.end());
    for (std::size_t k = 1; k < many.size(); ++k)
      if (many[k].low == many[k - 1].low && many[k].high == many[k - 1].high)
        keys.push_back(many[k]);
  }
  std::sort(keys.begin(), keys.end());
  const auto halve = [&](int32_t d) {
    const PatchComplex::Arc &arc = complex.arcs[complex.darts[d].arc];
    split(d, (arc.from + arc.to) / 2);
  };
  for (const Key &key : keys) {
    progress.tick(1, 1);
    if (key.low == key.high) halve(key.dart);
    halve(key.dart);
  }
}

std::vector<int32_t> ComplexEditor::finish() {
  PatchComplex &c = complex;
  std::vector<int32_t> dart(c.darts.size()), patch(c.patches.size());
  std::size_t patches = 0, darts = 0;
  for (std::size_t p = 0; p < c.patches.size(); ++p) {
    if (c.patches[p].loops < 0) continue;
    patch[p] = int32_t(patches);
    c.patches[patches++] = c.patches[p];
  }
  c.patches.resize(patches);
  std::vector<int32_t> vertex(points.size(), -1), sample; // of those that are used, numbers
  for (std::size_t d = 0; d < c.darts.size(); ++d)
    if (alive_[d]) {
      dart[d] = int32_t(darts++);
      c.darts[d].from = from(int32_t(d));
      vertex[c.darts[d].from] = 0;
    }
  c.position.clear();
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (vertex[v] < 0) continue;
    vertex[v] = int32_t(c.position.size());
    c.position.push_back(points.at(int32_t(v)));
    sample.push_back(points.sample(int32_t(v)));
  }
  for (std::size_t d = 0; d < dart.size(); ++d) {
    if (!alive_[d]) continue;
    Dart moved = c.darts[d];
    moved.from = vertex[moved.from];
    moved.next = dart[moved.next];
    moved.previous = dart[moved.previous];
    moved.twin = dart[moved.twin];
    moved.patch = patch[moved.patch];
    c.darts[dart[d]] = moved;
  }
  c.darts.resize(darts);
  return sample;
}

} // namespace vbm::impl
