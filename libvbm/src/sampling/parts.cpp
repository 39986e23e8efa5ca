// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/parts.h"

#include "core/progress.h"
#include "sampling/checks.h"
#include "core/disjoint_sets.h"
#include "sampling/tolerances.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

void measure(const Triangle &t, const std::vector<Vec3> &position, double &area, Part &part) {
  const Vec3 a = position[t[0]], b = position[t[1]], c = position[t[2]];
  area += length(cross(b - a, c - a)) / 2;
  // About the part's own corner, not the frame's middle: small parts far off lose no digits.
  part.volume += dot(a - part.low, cross(b - part.low, c - part.low)) / 6;
}

void grow(Part &part, const Vec3 &p) {
  for (int a = 0; a < 3; ++a) {
    part.low[a] = std::min(part.low[a], p[a]);
    part.high[a] = std::max(part.high[a], p[a]);
  }
}

bool boxes_overlap(const Part &p, const Part &q) {
  for (int a = 0; a < 3; ++a)
    if (!(p.low[a] < q.high[a] && q.low[a] < p.high[a])) return false;
  return true;
}

bool box_within(const Part &p, const Part &q) {
  for (int a = 0; a < 3; ++a)
    if (!(q.low[a] <= p.low[a] && p.high[a] <= q.high[a])) return false;
  return true;
}

/// Whether any two parts may lie within or across each other. An open part that hangs on another at
/// a vertex is a piece of the same surface, with holes all round.
bool any_overlap(const TriangleMesh &mesh, const Parts &parts) {
  const std::size_t count = parts.part.size();
  if (count < 2) return false;
  if (count > kManyParts) return true; // so every ball is asked for
  DisjointSets touching(count);
  std::vector<int32_t> part_at(parts.position.size(), -1);
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t)
    for (int32_t v : mesh.triangle[t]) {
      if (part_at[v] >= 0) touching.unite(part_at[v], parts.part_of[t]);
      part_at[v] = parts.part_of[t];
    }
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Part &p = parts.part[i], &q = parts.part[j];
      const bool one_surface = (!p.solid || !q.solid) && touching.find(static_cast<int32_t>(i)) ==
                                                             touching.find(static_cast<int32_t>(j));
      if (!one_surface && boxes_overlap(p, q)) return true;
    }
  return false;
}

void number_parts(const TriangleMesh &mesh, Parts &parts, Progress &progress) {
  DisjointSets sets(mesh.triangle.size());
  for (const Edge &e : mesh.edge) {
    if ((e.begin & 1023) == 0) progress.tick(0, 1);
    for (int32_t s = e.begin + 1; s < e.end; ++s)
      sets.unite(mesh.side[e.begin] / 3, mesh.side[s] / 3);
  }
  progress.tick_slow(0, 1);
  std::size_t count;
  parts.part_of = sets.numbers(count);
  parts.part.resize(count);
}

void measure_all(const TriangleMesh &mesh, const Holes &holes, Parts &parts, Progress &progress) {
  for (Part &p : parts.part) p.low = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, p.high = -p.low;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t)
    for (int32_t v : mesh.triangle[t]) grow(parts.part[parts.part_of[t]], parts.position[v]);
  progress.tick_slow(0, 1);
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    Part &part = parts.part[parts.part_of[t]];
    measure(mesh.triangle[t], parts.position, part.area, part);
  }
  progress.tick_slow(0, 1);
  for (const Edge &e : mesh.edge) { // a border that a cap closes is only "not closed"
    if (e.balance == 0) continue;
    Part &part = parts.part[parts.part_of[mesh.side[e.begin] / 3]];
    part.closed = false;
    if (e.faces() > 1) part.solid = false;
  }
  std::vector<int32_t> loop_of_cap, part_of_loop(holes.loops);
  for (std::size_t i = 0; i < holes.side.size(); ++i) {
    part_of_loop[holes.loop[i]] = parts.part_of[holes.side[i] / 3];
    if (!holes.closes[holes.loop[i]]) parts.part[part_of_loop[holes.loop[i]]].solid = false;
  }
  parts.caps = cap_holes(mesh, holes, parts.position, loop_of_cap);
  for (std::size_t c = 0; c < parts.caps.size(); ++c) {
    const int32_t p = part_of_loop[loop_of_cap[c]];
    parts.cap_part.push_back(p);
    measure(parts.caps[c], parts.position, parts.part[p].cap_area, parts.part[p]);
  }
}

void turn_marked(const std::vector<uint8_t> &marked, TriangleMesh &mesh, Parts &parts) {
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t)
    if (marked[parts.part_of[t]]) mesh.turn(static_cast<int32_t>(t));
  for (std::size_t c = 0; c < parts.caps.size(); ++c)
    if (marked[parts.cap_part[c]]) std::swap(parts.caps[c][1], parts.caps[c][2]);
  for (std::size_t p = 0; p < marked.size(); ++p)
    if (marked[p]) parts.part[p].volume = -parts.part[p].volume;
}

} // namespace

Parts find_parts(const TriangleMesh &mesh, const std::vector<Vec3> &position, const Holes &holes,
                 Progress &progress) {
  Parts parts;
  parts.position.reserve(position.size() + holes.loops);
  parts.position = position;
  number_parts(mesh, parts, progress);
  measure_all(mesh, holes, parts, progress);
  double open = 0, all = 0;
  for (Part &p : parts.part) {
    p.solid = p.solid && p.cap_area <= kMostOpenArea * p.area;
    all += p.area;
    open += p.solid ? 0 : p.area;
  }
  parts.usable = all > 0 && open <= kMostOpenArea * all;
  parts.overlap = any_overlap(mesh, parts);
  return parts;
}

void turn_upright(TriangleMesh &mesh, Parts &parts, Samples &samples) {
  if (!parts.usable) return;
  double volume = 0;
  for (const Part &p : parts.part) volume += p.solid ? p.volume : 0;
  if (volume < 0) {
    turn_marked(std::vector<uint8_t>(parts.part.size(), 1), mesh, parts);
    samples.flipped = true;
    samples.notes.push_back("the mesh was inside out and was taken as upright");
  }
  if (parts.part.size() > kManyParts) return;
  std::vector<uint8_t> marked(parts.part.size(), 0);
  std::size_t turned = 0;
  for (std::size_t i = 0; i < parts.part.size(); ++i) {
    const Part &p = parts.part[i];
    if (!p.solid || !(p.volume < 0)) continue;
    const auto holds_p = [&](const Part &q) { return &q != &p && q.solid && box_within(p, q); };
    if (std::any_of(parts.part.begin(), parts.part.end(), holds_p)) continue;
    ++turned;
    for (std::size_t j = 0; j < parts.part.size(); ++j)
      if (box_within(parts.part[j], p)) marked[j] = 1;
  }
  if (!turned) return;
  turn_marked(marked, mesh, parts);
  samples.notes.push_back(counted(turned, "part of the mesh was", "parts of the mesh were") +
                          " inside out beside others and taken as upright");
}

} // namespace vbm::impl
