// SPDX-License-Identifier: GPL-3.0-or-later
// Making and reading medial meshes.
#include "medial/medial_mesh.h"

#include "capi/guard.h"
#include "capi/views.h"

using namespace vbm::impl;

namespace {

const Axis &axis_of(const vbm_axis *axis) {
  if (!axis) throw Error(VBM_ERROR_ARGUMENT, "axis is NULL");
  return axis->axis;
}

} // namespace

extern "C" {

vbm_status vbm_axis_simplify(vbm_context *context, const vbm_axis *axis,
                             const vbm_simplify_options *options, vbm_medial_mesh **out) {
  return guarded(context, out, [&](Progress &progress) {
    const Axis &a = axis_of(axis);
    const vbm_simplify_options o = read_options(options);
    return new vbm_medial_mesh{simplify_axis(a, o, progress)};
  });
}

vbm_status vbm_axis_curve_skeleton(vbm_context *context, const vbm_axis *axis,
                                   const vbm_curve_skeleton_options *options,
                                   vbm_medial_mesh **out) {
  return guarded(context, out, [&](Progress &progress) {
    const Axis &a = axis_of(axis);
    const vbm_curve_skeleton_options o = read_options(options);
    return new vbm_medial_mesh{curve_skeleton(a, o, progress)};
  });
}

void vbm_medial_mesh_free(vbm_medial_mesh *mesh) { delete mesh; }

vbm_status vbm_medial_mesh_get_report(const vbm_medial_mesh *mesh, vbm_medial_mesh_report *report) {
  return copy_report(mesh ? &mesh->mesh.report : nullptr, report);
}
const char *vbm_medial_mesh_notes(const vbm_medial_mesh *m) {
  return m ? m->mesh.notes.c_str() : "";
}
const double *vbm_medial_mesh_vertices(const vbm_medial_mesh *m, size_t *count) {
  return m ? view(m->mesh.vertices, 3, count) : none<double>(count);
}
const double *vbm_medial_mesh_radii(const vbm_medial_mesh *m, size_t *count) {
  return m ? view(m->mesh.radii, 1, count) : none<double>(count);
}
const int32_t *vbm_medial_mesh_triangles(const vbm_medial_mesh *m, size_t *count) {
  return m ? view(m->mesh.triangles, 3, count) : none<int32_t>(count);
}
const int32_t *vbm_medial_mesh_edges(const vbm_medial_mesh *m, size_t *count) {
  return m ? view(m->mesh.edges, 2, count) : none<int32_t>(count);
}

} // extern "C"
