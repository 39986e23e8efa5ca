// SPDX-License-Identifier: GPL-3.0-or-later
#include "axis_layer.h"

#include "orient.h"
#include "part_colors.h"
#include "text.h"

#include <map>

namespace vbm_filters {

NewLayer axis_layer(const vbm::Axis &axis, std::string name) {
  const auto vertices = axis.vertices();
  const auto radii = axis.radii();
  const auto triangles = axis.triangles();
  const auto curves = axis.curves();
  NewLayer layer;
  layer.name = std::move(name);
  layer.points.assign(vertices.begin(), vertices.end());
  layer.triangles.assign(triangles.begin(), triangles.end());
  orient_sheets(layer.triangles, layer.points);
  layer.radius.assign(radii.begin(), radii.end());
  layer.quality = layer.radius;

  const auto part = axis.triangle_part();
  const auto curve_part = axis.curve_part();
  layer.triangle_colors.reserve(part.size);
  for (std::int32_t p : part) layer.triangle_colors.push_back(part_color(p));
  if (part.empty() || !curve_part.empty()) {
    // Hosts show colours of vertices rather than those of faces, which tell sheets apart better;
    // but a curve has no faces to be coloured.
    layer.colors.assign(radii.size, part_color(0));
    for (std::size_t t = 0; t < part.size; ++t)
      for (int k = 0; k < 3; ++k) layer.colors[triangles[t][k]] = part_color(part[t]);
    for (std::size_t c = 0; c < curve_part.size; ++c)
      for (int k = 0; k < 2; ++k) layer.colors[curves[c][k]] = part_color(curve_part[c]);
  }
  layer.triangle_quality.assign(part.begin(), part.end());
  return layer;
}

void describe(const vbm::Axis &axis, std::vector<std::string> &log) {
  const vbm_axis_report report = axis.report();
  describe_simplices("Medial axis: " + count(report.vertices, "vertex", "vertices") + ", ", report,
                     log);
  std::map<std::int32_t, std::uint64_t> levels, locks;
  for (const vbm_part &part : axis.parts()) {
    ++levels[part.level];
    if (part.lock != VBM_LOCK_NONE) ++locks[part.lock];
  }
  std::string line = count(report.parts, "part", "parts");
  const char *separator = ": ";
  for (const auto &[level, parts] : levels) {
    line += separator + count(parts) + " of level " + std::to_string(level);
    separator = ", ";
  }
  log.push_back(line + ".");
  for (const auto &[lock, parts] : locks)
    log.push_back(count(parts, "part", "parts") + " cannot be removed now: " + vbm_lock_text(lock) +
                  ".");
}

std::string without_axis(const std::string &name) {
  // MeshLab numbers layers of the same name: "bunny axis(1)".
  const std::size_t at = name.rfind(" axis");
  if (at == std::string::npos || at == 0) return name;
  const std::string rest = name.substr(at + 5);
  const bool numbered = rest.size() > 2 && rest.front() == '(' && rest.back() == ')' &&
                        rest.find_first_not_of("0123456789", 1) == rest.size() - 1;
  return rest.empty() || numbered ? name.substr(0, at) : name;
}

} // namespace vbm_filters
