// SPDX-License-Identifier: GPL-3.0-or-later
// Making, pruning and reading medial axes.
#include "medial/axis.h"

#include "capi/guard.h"
#include "capi/views.h"
#include "medial/axis_surface.h"
#include "medial/lock_text.h"

#include <string>
#include <vector>

using namespace vbm::impl;

namespace {

const Axis &axis_of(const vbm_axis *axis) {
  if (!axis) throw Error(VBM_ERROR_ARGUMENT, "axis is NULL");
  return axis->axis;
}

void check_array(const char *name, const void *values, size_t count) {
  if (!values && count)
    throw Error(VBM_ERROR_ARGUMENT,
                std::string(name) + " is NULL, but " + std::to_string(count) + " were announced");
}

} // namespace

extern "C" {

vbm_status vbm_model_medial_axis(vbm_context *context, const vbm_model *model,
                                 const vbm_axis_options *options, vbm_axis **out) {
  return guarded(context, out, [&](Progress &progress) {
    if (!model) throw Error(VBM_ERROR_ARGUMENT, "model is NULL");
    const vbm_axis_options o = read_options(options);
    return new vbm_axis{medial_axis(model->shared, o, progress)};
  });
}

vbm_status vbm_axis_prune(vbm_context *context, const vbm_axis *axis,
                          const vbm_prune_options *options, vbm_axis **out) {
  return guarded(context, out, [&](Progress &progress) {
    const Axis &a = axis_of(axis);
    return new vbm_axis{prune_axis(a, {read_options(options)}, progress)};
  });
}

vbm_status vbm_axis_prune_steps(vbm_context *context, const vbm_axis *axis,
                                const vbm_prune_options *const *steps, size_t count,
                                vbm_axis **out) {
  return guarded(context, out, [&](Progress &progress) {
    const Axis &a = axis_of(axis);
    check_array("steps", steps, count);
    std::vector<vbm_prune_options> read;
    for (size_t s = 0; s < count; ++s) try {
        read.push_back(read_options(steps[s]));
      } catch (Error &error) {
        if (count > 1) error.message = "step " + std::to_string(s) + ": " + error.message;
        throw;
      }
    return new vbm_axis{prune_axis(a, read, progress)};
  });
}

vbm_status vbm_axis_remove_parts(vbm_context *context, const vbm_axis *axis, const int32_t *parts,
                                 size_t count, vbm_axis **out) {
  return guarded(context, out, [&](Progress &progress) {
    const Axis &a = axis_of(axis);
    check_array("parts", parts, count);
    return new vbm_axis{remove_parts(a, parts, count, progress)};
  });
}

vbm_status vbm_axis_remove_triangles(vbm_context *context, const vbm_axis *axis,
                                     const int32_t *triangles, size_t count, vbm_axis **out) {
  return guarded(context, out, [&](Progress &progress) {
    const Axis &a = axis_of(axis);
    check_array("triangles", triangles, count);
    return new vbm_axis{remove_triangles(a, triangles, count, progress)};
  });
}

vbm_status vbm_axis_part_ball_volumes(vbm_context *context, const vbm_axis *axis,
                                      const double **shares, size_t *count) {
  if (shares) *shares = nullptr;
  if (count) *count = 0;
  return guarded(context, [&](Progress &progress) {
    if (!shares) throw Error(VBM_ERROR_ARGUMENT, "shares is NULL");
    const Axis &a = axis_of(axis);
    const std::vector<double> &found = part_ball_shares(a, progress);
    progress.finish();
    *shares = view(found, 1, count);
  });
}

vbm_status vbm_axis_surface(vbm_context *context, const vbm_axis *axis,
                            const vbm_axis_surface_options *options, vbm_surface **out) {
  return guarded(context, out, [&](Progress &progress) {
    const Axis &a = axis_of(axis);
    const vbm_axis_surface_options o = read_options(options);
    return new vbm_surface{axis_surface(a, o, progress)};
  });
}

void vbm_axis_free(vbm_axis *axis) { delete axis; }

vbm_status vbm_axis_get_report(const vbm_axis *axis, vbm_axis_report *report) {
  return copy_report(axis ? &axis->axis.report : nullptr, report);
}
const char *vbm_axis_notes(const vbm_axis *a) { return a ? a->axis.notes.c_str() : ""; }
const double *vbm_axis_vertices(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.vertices, 3, count) : none<double>(count);
}
const double *vbm_axis_radii(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.radii, 1, count) : none<double>(count);
}
const int32_t *vbm_axis_triangles(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.triangles, 3, count) : none<int32_t>(count);
}
const int32_t *vbm_axis_triangle_samples(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.triangle_samples, 2, count) : none<int32_t>(count);
}
const double *vbm_axis_triangle_points(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.triangle_points, 6, count) : none<double>(count);
}
const int32_t *vbm_axis_triangle_part(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.triangle_part, 1, count) : none<int32_t>(count);
}
const double *vbm_axis_triangle_width(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.triangle_width, 1, count) : none<double>(count);
}
const double *vbm_axis_triangle_angle(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.triangle_angle, 1, count) : none<double>(count);
}
const int32_t *vbm_axis_curves(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.curves, 2, count) : none<int32_t>(count);
}
const int32_t *vbm_axis_curve_part(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.curve_part, 1, count) : none<int32_t>(count);
}
const double *vbm_axis_curve_width(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.curve_width, 1, count) : none<double>(count);
}
const double *vbm_axis_curve_angle(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.curve_angle, 1, count) : none<double>(count);
}
const int32_t *vbm_axis_contact_edges(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.contact_edges, 2, count) : none<int32_t>(count);
}
const int32_t *vbm_axis_contact_node(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.contact_node, 1, count) : none<int32_t>(count);
}
const vbm_part *vbm_axis_parts(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.parts.list, 1, count) : none<vbm_part>(count);
}
const int32_t *vbm_axis_part_balls(const vbm_axis *a, const uint64_t **offsets, size_t *count) {
  return a ? view(a->axis.part_balls, offsets, count) : none(offsets, count);
}
const double *vbm_axis_nodes(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.nodes, 3, count) : none<double>(count);
}
const int32_t *vbm_axis_part_nodes(const vbm_axis *a, const uint64_t **offsets, size_t *count) {
  return a ? view(a->axis.part_nodes, offsets, count) : none(offsets, count);
}
const char *vbm_lock_text(int32_t lock) { return lock_text(lock); }
const int32_t *vbm_axis_stayed(const vbm_axis *a, const int32_t **locks, size_t *count) {
  if (locks) *locks = a ? a->axis.stayed_lock.data() : nullptr;
  return a ? view(a->axis.stayed, 1, count) : none<int32_t>(count);
}
const uint8_t *vbm_axis_kept_balls(const vbm_axis *a, size_t *count) {
  return a ? view(a->axis.kept, 1, count) : none<uint8_t>(count);
}

} // extern "C"
