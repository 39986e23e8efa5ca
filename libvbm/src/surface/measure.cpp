// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/measure.h"

#include "core/error.h"
#include "core/frame.h"
#include "core/sort_edges.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace vbm::impl {

namespace {

struct HalfEdge {
  int32_t low, high; // ends, ascending
  uint32_t id;       // 3 * triangle + corner; runs from that corner to the next
};

int32_t find(std::vector<int32_t> &parent, int32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

/// Half-edges grouped by their lower end: a counting sort, then small sorts.
std::vector<HalfEdge> sorted_edges(const Surface &surface, Progress &progress) {
  std::vector<uint32_t> first(surface.vertices.size() + 1, 0);
  for (const auto &t : surface.triangles)
    for (int i = 0; i < 3; ++i) ++first[std::min(t[i], t[(i + 1) % 3]) + 1];
  for (std::size_t v = 0; v + 1 < first.size(); ++v) first[v + 1] += first[v];
  std::vector<HalfEdge> edges(3 * surface.triangles.size());
  std::vector<uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    progress.tick(t, 4 * surface.triangles.size());
    for (int i = 0; i < 3; ++i) {
      const int32_t a = surface.triangles[t][i], b = surface.triangles[t][(i + 1) % 3];
      edges[next[std::min(a, b)]++] = {std::min(a, b), std::max(a, b), uint32_t(3 * t + i)};
    }
  }
  for (std::size_t v = 0; v + 1 < first.size(); ++v) {
    progress.tick(first.size(), 4 * first.size());
    sort_by_high(edges.begin() + first[v], edges.begin() + first[v + 1]);
  }
  return edges;
}

[[noreturn]] void broken(const char *what, std::size_t where) {
  throw Error(VBM_ERROR_INTERNAL, std::string("the surface came out wrong: ") + what +
                                      std::to_string(where) + "; please report this");
}

} // namespace

void measure(Surface &surface, Progress &progress) {
  const auto &triangles = surface.triangles;
  const std::vector<HalfEdge> edges = sorted_edges(surface, progress);
  std::vector<uint32_t> twin(edges.size());
  for (std::size_t e = 0; e < edges.size(); e += 2) {
    progress.tick(edges.size() + e, 4 * edges.size());
    const bool pair = e + 1 < edges.size() && edges[e].low == edges[e + 1].low &&
                      edges[e].high == edges[e + 1].high;
    const bool third = pair && e + 2 < edges.size() && edges[e].low == edges[e + 2].low &&
                       edges[e].high == edges[e + 2].high;
    if (!pair || third) broken("not two triangles at an edge of vertex ", edges[e].low);
    const uint32_t a = edges[e].id, b = edges[e + 1].id;
    if (triangles[a / 3][a % 3] == triangles[b / 3][b % 3])
      broken("contradicting triangles at an edge of vertex ", edges[e].low);
    twin[a] = b;
    twin[b] = a;
  }

  // Components by vertices; corners at a vertex must form one fan.
  std::vector<int32_t> parent(surface.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  std::vector<int32_t> valence(surface.vertices.size(), 0);
  std::vector<uint32_t> corner(surface.vertices.size(), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    progress.tick(2 * triangles.size() + t, 4 * triangles.size());
    for (int i = 0; i < 3; ++i) {
      const int32_t v = triangles[t][i];
      ++valence[v];
      corner[v] = uint32_t(3 * t + i);
      const int32_t a = find(parent, v), b = find(parent, triangles[t][(i + 1) % 3]);
      if (a != b) parent[std::max(a, b)] = std::min(a, b);
    }
  }
  uint64_t used = 0, components = 0;
  for (std::size_t v = 0; v < valence.size(); ++v) {
    progress.tick(3 * valence.size() + v, 4 * valence.size());
    if (!valence[v]) continue;
    ++used;
    components += parent[v] == int32_t(v);
    int32_t fan = 0;
    uint32_t c = corner[v];
    do {
      ++fan;
      c = twin[c];                     // ends at v, in the next triangle of the fan
      c = c / 3 * 3 + (c % 3 + 1) % 3; // starts at v
    } while (c != corner[v] && fan <= valence[v]);
    if (fan != valence[v]) broken("more than one fan of triangles at vertex ", v);
  }

  // In the unit frame: the square of an area in the input's units may be no double at all.
  std::vector<Vec3> position(surface.vertices.size());
  const Frame frame =
      frame_of(position.empty() ? nullptr : &surface.vertices[0].x, position.size());
  for (std::size_t v = 0; v < position.size(); ++v)
    position[v] = frame.to_unit(surface.vertices[v]);
  double area = 0, volume = 0;
  for (const auto &t : triangles) {
    progress.tick(1, 1);
    const Vec3 a = position[t[0]], b = position[t[1]], c = position[t[2]];
    const Vec3 n = cross(b - a, c - a);
    area += length(n) / 2;
    volume += dot(a, n) / 6;
  }
  vbm_surface_report &report = surface.report;
  report.vertices = surface.vertices.size();
  report.triangles = triangles.size();
  report.polygons = surface.polygons.offset.size() - 1;
  report.components = components;
  report.euler = int64_t(used) - int64_t(edges.size() / 2) + int64_t(triangles.size());
  report.genus = int64_t(components) - report.euler / 2;
  report.area = std::ldexp(area, 2 * frame.exponent);
  report.volume = std::ldexp(volume, 3 * frame.exponent);
  if (report.split_vertices)
    surface.notes +=
        std::to_string(report.split_vertices) +
        (report.split_vertices == 1 ? " vertex stands" : " vertices stand") +
        " where another one stands, as the surface touches itself there: merged they would "
        "not be manifold\n";
}

} // namespace vbm::impl
