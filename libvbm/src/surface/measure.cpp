// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/measure.h"

#include "core/error.h"
#include "core/frame.h"

#include <algorithm>
#include <string>

namespace vbm::impl {

namespace {

/// A triangle as one of its corners sees it: the ends of its sides there, counter-clockwise.
struct Corner {
  int32_t next, last;
};

/// Corners by their vertex: those of v are from first[v] to first[v + 1].
std::vector<Corner> corners_of(const Surface &surface, std::vector<uint32_t> &first,
                               Progress &progress) {
  const std::size_t count = surface.vertices.size();
  first.assign(count + 2, 0);
  for (const auto &t : surface.triangles)
    for (int32_t v : t) ++first[std::size_t(v) + 2];
  for (std::size_t v = 0; v <= count; ++v) first[v + 1] += first[v];
  std::vector<Corner> corners(3 * surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    progress.tick(t, 4 * surface.triangles.size());
    const auto &[a, b, c] = surface.triangles[t];
    corners[first[std::size_t(a) + 1]++] = {b, c};
    corners[first[std::size_t(b) + 1]++] = {c, a};
    corners[first[std::size_t(c) + 1]++] = {a, b};
  }
  return corners;
}

/// Whether the triangles at vertex v are one fan that closes: going from side to side, one comes to
/// all of them. So every edge there is in two, one of which it leaves v in.
bool is_fan(Corner *begin, Corner *end, int32_t v) {
  constexpr std::ptrdiff_t kMany = 32; // from which on searches are worth a sort
  const auto is_before = [](const Corner &c, int32_t next) { return c.next < next; };
  const bool sorts = end - begin >= kMany;
  if (sorts)
    std::sort(begin, end, [](const Corner &a, const Corner &b) { return a.next < b.next; });
  const Corner *at = begin;
  std::ptrdiff_t seen = 0;
  do {
    if (at->next == v || at->last == v || at->next == at->last || ++seen > end - begin)
      return false;
    const int32_t side = at->last;
    at = sorts ? std::lower_bound(begin, end, side, is_before) : begin;
    while (at != end && at->next != side) ++at;
  } while (at != begin && at != end);
  return at == begin && seen == end - begin;
}

[[noreturn]] void broken(const char *what, std::size_t where) {
  throw Error(VBM_ERROR_INTERNAL, std::string("the surface came out wrong: ") + what +
                                      std::to_string(where) + "; please report this");
}

/// How many there are of vertices that hang together.
uint64_t count_components(const std::vector<Corner> &corners, const std::vector<uint32_t> &first,
                          Progress &progress) {
  std::vector<uint8_t> seen(first.size(), 0);
  std::vector<int32_t> stack;
  uint64_t components = 0;
  for (std::size_t v = 0; v + 2 < first.size(); ++v) {
    if (seen[v] || first[v] == first[v + 1]) continue;
    ++components;
    seen[v] = 1;
    stack.push_back(int32_t(v));
    while (!stack.empty()) {
      progress.tick(2, 3);
      const int32_t u = stack.back();
      stack.pop_back();
      for (uint32_t c = first[u]; c < first[std::size_t(u) + 1]; ++c) {
        const int32_t w = corners[c].next;
        if (seen[w]) continue;
        seen[w] = 1;
        stack.push_back(w);
      }
    }
  }
  return components;
}

} // namespace

void measure(Surface &surface, Progress &progress) {
  const auto &triangles = surface.triangles;
  std::vector<uint32_t> first;
  std::vector<Corner> corners = corners_of(surface, first, progress);
  uint64_t used = 0;
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    progress.tick(surface.vertices.size() + v, 3 * surface.vertices.size());
    if (first[v] == first[v + 1]) continue;
    ++used;
    if (!is_fan(corners.data() + first[v], corners.data() + first[v + 1], int32_t(v)))
      broken("not one closed fan of triangles at vertex ", v);
  }
  const uint64_t components = count_components(corners, first, progress);

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
  report.euler = int64_t(used) - int64_t(corners.size() / 2) + int64_t(triangles.size());
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
