// SPDX-License-Identifier: GPL-3.0-or-later
// Making, reading and measuring clusters.
#include "match/clusters.h"

#include "capi/guard.h"
#include "capi/views.h"

#include <memory>
#include <string>
#include <vector>

using namespace vbm::impl;

extern "C" {

vbm_status vbm_cluster_balls(vbm_context *context, const double *centers, const double *radii,
                             size_t count, const vbm_cluster_options *options,
                             vbm_clusters **out) {
  return guarded(context, out, [&](Progress &progress) {
    if (count && !(centers && radii))
      throw Error(VBM_ERROR_ARGUMENT, std::string(centers ? "radii" : "centers") + " is NULL, but " +
                                          std::to_string(count) + " balls were announced");
    const vbm_cluster_options o = read_options(options);
    return new vbm_clusters{cluster_balls(centers, radii, count, o, progress)};
  });
}

vbm_status vbm_model_cluster(vbm_context *context, const vbm_model *model,
                             const vbm_cluster_options *options, vbm_clusters **out) {
  return guarded(context, out, [&](Progress &progress) {
    if (!model) throw Error(VBM_ERROR_ARGUMENT, "model is NULL");
    const vbm_cluster_options o = read_options(options);
    const Model &m = model->model;
    if (!m.inner) throw Error(VBM_ERROR_NO_INTERIOR, "the model has no inner balls to cluster");
    return new vbm_clusters{
        cluster_balls(m.centers.data(), m.radii.data(), m.inner, o, progress)};
  });
}

void vbm_clusters_free(vbm_clusters *clusters) { delete clusters; }

vbm_status vbm_clusters_measure(vbm_context *context, const vbm_clusters *clusters, size_t points,
                                vbm_cluster_error *error) {
  // The result is no handle, so that it is one for as long as the call takes.
  vbm_cluster_error *measured = nullptr;
  const vbm_status status = guarded(context, &measured, [&](Progress &progress) {
    if (!clusters) throw Error(VBM_ERROR_ARGUMENT, "clusters is NULL");
    if (!error) throw Error(VBM_ERROR_ARGUMENT, "error is NULL");
    if (error->struct_size < sizeof(size_t))
      throw Error(VBM_ERROR_ARGUMENT, "error's struct_size is " +
                                          std::to_string(error->struct_size) +
                                          ": set it to sizeof(vbm_cluster_error)");
    if (points < 1 || points > 100000000)
      throw Error(VBM_ERROR_ARGUMENT, "points is " + std::to_string(points) +
                                          ", outside its range 1 to 100 million");
    return new vbm_cluster_error(measure_clusters(clusters->clusters, points, progress));
  });
  const std::unique_ptr<vbm_cluster_error> owned(measured);
  return status == VBM_OK ? copy_report(measured, error) : status;
}

vbm_status vbm_clusters_get_report(const vbm_clusters *c, vbm_clusters_report *report) {
  return copy_report(c ? &c->clusters.report : nullptr, report);
}
const char *vbm_clusters_notes(const vbm_clusters *c) { return c ? c->clusters.notes.c_str() : ""; }
const double *vbm_clusters_centers(const vbm_clusters *c, size_t *count) {
  return c ? view(c->clusters.centers, 3, count) : none<double>(count);
}
const double *vbm_clusters_radii(const vbm_clusters *c, size_t *count) {
  return c ? view(c->clusters.radii, 1, count) : none<double>(count);
}
const double *vbm_clusters_sphericity(const vbm_clusters *c, size_t *count) {
  return c ? view(c->clusters.sphericity, 1, count) : none<double>(count);
}
const double *vbm_clusters_gap(const vbm_clusters *c, size_t *count) {
  return c ? view(c->clusters.gap, 1, count) : none<double>(count);
}
const int32_t *vbm_clusters_ball_cluster(const vbm_clusters *c, size_t *count) {
  return c ? view(c->clusters.ball_cluster, 1, count) : none<int32_t>(count);
}
const int32_t *vbm_clusters_balls(const vbm_clusters *c, const uint64_t **offsets, size_t *count) {
  return c ? view(c->clusters.members, offsets, count) : none(offsets, count);
}

} // extern "C"
