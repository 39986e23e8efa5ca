// SPDX-License-Identifier: GPL-3.0-or-later
// Making and reading surfaces.
#include "capi/guard.h"
#include "capi/views.h"
#include "surface/interpolating.h"
#include "surface/power_crust.h"

#include <string>

using namespace vbm::impl;

namespace {

const Model &model_of(const vbm_model *model) {
  if (!model) throw Error(VBM_ERROR_ARGUMENT, "model is NULL");
  return model->model;
}

/// Vec3 is three doubles and nothing else, so that an array of it is an array of doubles.
static_assert(sizeof(Vec3) == 3 * sizeof(double));
static_assert(sizeof(std::array<int32_t, 3>) == 3 * sizeof(int32_t));

} // namespace

extern "C" {

vbm_status vbm_model_surface(vbm_context *context, const vbm_model *model, vbm_surface **out) {
  return guarded(context, out, [&](Progress &progress) {
    const Model &m = model_of(model);
    progress.stage("interpolating surface", 1);
    return new vbm_surface{interpolating_surface(m, progress)};
  });
}

vbm_status vbm_model_power_crust(vbm_context *context, const vbm_model *model, const uint8_t *keep,
                                 size_t keep_count, vbm_surface **out) {
  return guarded(context, out, [&](Progress &progress) {
    const Model &m = model_of(model);
    if (keep && keep_count != m.inner)
      throw Error(VBM_ERROR_ARGUMENT, "keep has " + std::to_string(keep_count) +
                                          " entries, but the model has " + std::to_string(m.inner) +
                                          " inner balls");
    return new vbm_surface{power_crust(m, keep, nullptr, progress)};
  });
}

void vbm_surface_free(vbm_surface *surface) { delete surface; }

vbm_status vbm_surface_get_report(const vbm_surface *surface, vbm_surface_report *report) {
  return copy_report(surface ? &surface->surface.report : nullptr, report);
}

const char *vbm_surface_notes(const vbm_surface *s) { return s ? s->surface.notes.c_str() : ""; }
const double *vbm_surface_vertices(const vbm_surface *s, size_t *count) {
  if (!s) return none<double>(count);
  if (count) *count = s->surface.vertices.size();
  return s->surface.vertices.empty() ? nullptr : &s->surface.vertices[0].x;
}
const int32_t *vbm_surface_triangles(const vbm_surface *s, size_t *count) {
  if (!s) return none<int32_t>(count);
  if (count) *count = s->surface.triangles.size();
  return s->surface.triangles.empty() ? nullptr : s->surface.triangles[0].data();
}
const int32_t *vbm_surface_polygons(const vbm_surface *s, const uint64_t **offsets, size_t *count) {
  return s ? view(s->surface.polygons, offsets, count) : none(offsets, count);
}
const int32_t *vbm_surface_triangle_polygon(const vbm_surface *s, size_t *count) {
  return s ? view(s->surface.triangle_polygon, 1, count) : none<int32_t>(count);
}
const int32_t *vbm_surface_polygon_ball(const vbm_surface *s, size_t *count) {
  return s ? view(s->surface.polygon_ball, 1, count) : none<int32_t>(count);
}
const int32_t *vbm_surface_vertex_sample(const vbm_surface *s, size_t *count) {
  return s ? view(s->surface.vertex_sample, 1, count) : none<int32_t>(count);
}
const int32_t *vbm_surface_vertex_input(const vbm_surface *s, size_t *count) {
  return s ? view(s->surface.vertex_input, 1, count) : none<int32_t>(count);
}
const double *vbm_surface_vertex_radius(const vbm_surface *s, size_t *count) {
  return s ? view(s->surface.vertex_radius, 1, count) : none<double>(count);
}

} // extern "C"
