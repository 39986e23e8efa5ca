// SPDX-License-Identifier: GPL-3.0-or-later
#include "snapshot.h"

#include <cstring>

namespace {

template <class T> void append(std::string &out, const T *data, size_t count) {
  out.append(reinterpret_cast<const char *>(&count), sizeof count);
  if (count) out.append(reinterpret_cast<const char *>(data), count * sizeof(T));
}

/// A view of `width` numbers an element.
template <class Handle, class T>
void append(std::string &out, const Handle *handle, const T *(*get)(const Handle *, size_t *),
            size_t width = 1) {
  size_t count = 0;
  const T *data = get(handle, &count);
  append(out, data, width * count);
}

template <class Handle>
void append(std::string &out, const Handle *handle,
            const int32_t *(*get)(const Handle *, const uint64_t **, size_t *), size_t lists) {
  size_t count = 0;
  const uint64_t *offsets = nullptr;
  const int32_t *data = get(handle, &offsets, &count);
  append(out, offsets, offsets ? lists + 1 : 0);
  append(out, data, count);
}

} // namespace

std::string snapshot(const vbm_model *model) {
  std::string out;
  vbm_model_report report;
  std::memset(&report, 0, sizeof report);
  report.struct_size = sizeof report;
  vbm_model_get_report(model, &report);
  append(out, reinterpret_cast<const char *>(&report), sizeof report);
  append(out, vbm_model_notes(model), std::strlen(vbm_model_notes(model)));
  append(out, model, vbm_model_centers, 3);
  append(out, model, vbm_model_radii);
  append(out, model, vbm_model_inside);
  size_t balls = 0;
  vbm_model_radii(model, &balls);
  append(out, model, vbm_model_ball_samples, balls);
  append(out, model, vbm_model_ball_neighbors, balls);
  append(out, model, vbm_model_samples, 3);
  append(out, model, vbm_model_sample_input);
  append(out, model, vbm_model_input_sample);
  append(out, model, vbm_model_undersampled);
  append(out, model, vbm_model_inner_radius);
  append(out, model, vbm_model_outer_radius);
  return out;
}

std::string snapshot(const vbm_surface *surface) {
  std::string out;
  vbm_surface_report report;
  std::memset(&report, 0, sizeof report);
  report.struct_size = sizeof report;
  vbm_surface_get_report(surface, &report);
  append(out, reinterpret_cast<const char *>(&report), sizeof report);
  append(out, surface, vbm_surface_vertices, 3);
  append(out, surface, vbm_surface_triangles, 3);
  append(out, surface, vbm_surface_polygons, report.polygons);
  append(out, surface, vbm_surface_triangle_polygon);
  append(out, surface, vbm_surface_polygon_ball);
  append(out, surface, vbm_surface_vertex_sample);
  append(out, surface, vbm_surface_vertex_input);
  append(out, surface, vbm_surface_vertex_radius);
  return out;
}

std::string snapshot(const vbm_axis *axis) {
  std::string out;
  vbm_axis_report report;
  std::memset(&report, 0, sizeof report);
  report.struct_size = sizeof report;
  vbm_axis_get_report(axis, &report);
  append(out, reinterpret_cast<const char *>(&report), sizeof report);
  append(out, vbm_axis_notes(axis), std::strlen(vbm_axis_notes(axis)));
  append(out, axis, vbm_axis_vertices, 3);
  append(out, axis, vbm_axis_radii);
  append(out, axis, vbm_axis_triangles, 3);
  append(out, axis, vbm_axis_triangle_samples, 2);
  append(out, axis, vbm_axis_triangle_part);
  append(out, axis, vbm_axis_curves, 2);
  append(out, axis, vbm_axis_curve_part);
  append(out, axis, vbm_axis_triangle_width);
  append(out, axis, vbm_axis_triangle_angle);
  append(out, axis, vbm_axis_curve_width);
  append(out, axis, vbm_axis_curve_angle);
  append(out, axis, vbm_axis_contact_edges, 2);
  append(out, axis, vbm_axis_contact_node);
  append(out, axis, vbm_axis_kept_balls);
  append(out, axis, vbm_axis_nodes, 3);
  append(out, axis, vbm_axis_part_balls, report.parts);
  append(out, axis, vbm_axis_part_nodes, report.parts);
  size_t count = 0;
  const vbm_part *parts = vbm_axis_parts(axis, &count);
  for (size_t p = 0; p < count; ++p) { // without what lies between fields
    append(out, &parts[p].level, 2);
    append(out, &parts[p].triangles, 2);
    append(out, &parts[p].area, 8);
  }
  const int32_t *locks = nullptr;
  const int32_t *stayed = vbm_axis_stayed(axis, &locks, &count);
  append(out, stayed, count);
  append(out, locks, count);
  return out;
}
