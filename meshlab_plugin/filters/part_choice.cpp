// SPDX-License-Identifier: GPL-3.0-or-later
#include "part_choice.h"

#include <algorithm>
#include <set>

namespace vbm_filters {

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
  return result;
}

} // namespace vbm_filters
