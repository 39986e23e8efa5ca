// SPDX-License-Identifier: GPL-3.0-or-later
#include "part_choice.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace vbm_filters {
namespace {

using Place = std::array<double, 3>;

// A cell is told by the places of its corners; a curve edge has its second corner twice.
std::array<Place, 3> cell(const vbm::Axis &axis, const std::int32_t *corners, int count) {
  std::array<Place, 3> places;
  for (int k = 0; k < 3; ++k) {
    const double *p = axis.vertices()[corners[std::min(k, count - 1)]];
    places[k] = {p[0], p[1], p[2]};
  }
  std::sort(places.begin(), places.end());
  return places;
}

// Triangles, then curve edges, each with its part.
template <class Visit> void each_cell(const vbm::Axis &axis, Visit visit) {
  const auto triangles = axis.triangles();
  const auto part = axis.triangle_part();
  for (std::size_t t = 0; t < triangles.size; ++t) visit(triangles[t], 3, part[t]);
  const auto curves = axis.curves();
  const auto curve_part = axis.curve_part();
  for (std::size_t c = 0; c < curves.size; ++c) visit(curves[c], 2, curve_part[c]);
}

// The locks that parts of an axis have on what is left of it, where parts are numbered anew: found
// by one cell of each, which keeps its corners.
std::vector<std::int32_t> locks_on(const vbm::Axis &rest, const vbm::Axis &axis,
                                   const std::vector<std::int32_t> &parts) {
  std::map<std::int32_t, std::int32_t> lock;
  for (std::int32_t part : parts) lock[part] = axis.parts()[part].lock;
  std::map<std::array<Place, 3>, std::int32_t> told;
  std::set<std::int32_t> waiting(parts.begin(), parts.end());
  std::set<Place> corners;
  each_cell(axis, [&](const std::int32_t *corner, int count, std::int32_t part) {
    if (!waiting.erase(part)) return;
    const auto places = cell(axis, corner, count);
    told.emplace(places, part);
    corners.insert(places.front());
  });
  std::vector<std::uint8_t> near(rest.radii().size, 0); // spares most cells the search
  for (std::size_t v = 0; v < near.size(); ++v) {
    const double *p = rest.vertices()[v];
    near[v] = corners.count({p[0], p[1], p[2]}) != 0;
  }
  each_cell(rest, [&](const std::int32_t *corner, int count, std::int32_t part) {
    if (!std::any_of(corner, corner + count, [&](std::int32_t v) { return near[v] != 0; })) return;
    const auto found = told.find(cell(rest, corner, count));
    if (found != told.end()) lock[found->second] = rest.parts()[part].lock;
  });
  std::vector<std::int32_t> locks;
  for (std::int32_t part : parts) locks.push_back(lock[part]);
  return locks;
}

} // namespace

std::vector<std::int32_t> chosen_parts(const vbm::Axis &axis, const Layer &layer) {
  std::set<std::int32_t> parts;
  const auto part = axis.triangle_part();
  for (std::size_t t = 0; t < part.size; ++t)
    if (layer.selected_triangles[t]) parts.insert(part[t]);
  const auto curves = axis.curves();
  const auto curve_part = axis.curve_part();
  for (std::size_t c = 0; c < curves.size; ++c)
    if (layer.selected_vertices[curves[c][0]] && layer.selected_vertices[curves[c][1]])
      parts.insert(curve_part[c]);
  return {parts.begin(), parts.end()};
}

PartsRemoved remove_parts(vbm::Context &context, const vbm::Axis &axis,
                          const std::vector<std::int32_t> &parts) {
  PartsRemoved result;
  result.gone = parts;
  // The library removes all or none, and lists those that cannot go, but not more than some
  // thousands at a time.
  while (!result.gone.empty()) {
    std::set<std::int32_t> refused;
    try {
      result.axis = axis.remove_parts(context, {result.gone.data(), result.gone.size()});
      break;
    } catch (const vbm::Error &error) {
      if (error.status != VBM_ERROR_INPUT || error.kind != "part" || error.elements.empty()) throw;
      for (std::int64_t part : error.elements) refused.insert(static_cast<std::int32_t>(part));
    }
    const auto stays = std::stable_partition(result.gone.begin(), result.gone.end(),
                                             [&](std::int32_t p) { return !refused.count(p); });
    if (stays == result.gone.end()) throw Failure("The library refused a part that was not named.");
    result.left.insert(result.left.end(), stays, result.gone.end());
    result.gone.erase(stays, result.gone.end());
  }
  std::sort(result.left.begin(), result.left.end());
  result.why = locks_on(result.gone.empty() ? axis : result.axis, axis, result.left);
  return result;
}

} // namespace vbm_filters
