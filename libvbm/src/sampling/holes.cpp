// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/holes.h"

#include "core/disjoint_sets.h"

namespace vbm::impl {
namespace {

bool ends_at(const Edge &e, int32_t v) { return e.a == v || e.b == v; }

/// From an open edge across the faces round its vertex v to the next open edge, or -1 if an edge
/// with three or more sides is in the way.
int32_t next_open_edge(const TriangleMesh &mesh, int32_t open, int32_t v) {
  int32_t e = open, t = mesh.side[mesh.edge[e].begin] / 3;
  for (;;) {
    int32_t next = -1;
    for (int32_t s = 3 * t; s < 3 * t + 3; ++s) {
      const int32_t f = mesh.edge_of_side[s];
      if (f != e && ends_at(mesh.edge[f], v)) next = f;
    }
    e = next;
    if (mesh.edge[e].faces() == 1) return e;
    if (mesh.edge[e].faces() != 2) return -1;
    t = mesh.other(mesh.edge[e], t);
  }
}

} // namespace

Holes find_holes(const TriangleMesh &mesh) {
  Holes holes;
  std::vector<int32_t> number(mesh.edge.size(), -1); // of an edge among the open ones
  for (std::size_t e = 0; e < mesh.edge.size(); ++e) {
    if (mesh.edge[e].faces() != 1) continue;
    number[e] = static_cast<int32_t>(holes.side.size());
    holes.side.push_back(mesh.side[mesh.edge[e].begin]);
  }
  if (holes.side.empty()) return holes;
  DisjointSets sets(holes.side.size());
  std::vector<uint8_t> whole(holes.side.size(), 1);
  for (std::size_t i = 0; i < holes.side.size(); ++i) {
    const int32_t s = holes.side[i], e = mesh.edge_of_side[s], a = mesh.start(s);
    for (const int32_t v : {mesh.edge[e].a, mesh.edge[e].b}) {
      const int32_t f = next_open_edge(mesh, e, v);
      if (f < 0) {
        whole[i] = 0;
        continue;
      }
      sets.unite(static_cast<int32_t>(i), number[f]);
      // One of two neighbours on a loop starts where the other ends, if their faces agree.
      if ((mesh.start(holes.side[number[f]]) == v) == (a == v)) whole[i] = 0;
    }
  }
  holes.loop = sets.numbers(holes.loops);
  holes.closes.assign(holes.loops, 1);
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (!whole[i]) holes.closes[holes.loop[i]] = 0;
  return holes;
}

std::vector<Triangle> cap_holes(const TriangleMesh &mesh, const Holes &holes,
                                std::vector<Vec3> &position, std::vector<int32_t> &loop_of_cap) {
  std::vector<Vec3> sum(holes.loops);
  std::vector<int32_t> count(holes.loops, 0);
  for (std::size_t i = 0; i < holes.side.size(); ++i) {
    sum[holes.loop[i]] += position[mesh.start(holes.side[i])];
    ++count[holes.loop[i]];
  }
  const int32_t first = static_cast<int32_t>(position.size());
  for (std::size_t l = 0; l < holes.loops; ++l) position.push_back(sum[l] * (1.0 / count[l]));
  std::vector<Triangle> caps;
  for (std::size_t i = 0; i < holes.side.size(); ++i) {
    const int32_t s = holes.side[i], l = holes.loop[i];
    if (!holes.closes[l]) continue;
    const int32_t a = mesh.start(s), b = mesh.triangle[s / 3][(s % 3 + 1) % 3];
    caps.push_back({b, a, first + l});
    loop_of_cap.push_back(l);
  }
  return caps;
}

} // namespace vbm::impl
