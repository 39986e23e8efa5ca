// SPDX-License-Identifier: GPL-3.0-or-later
// Building and reading ball models.
#include "balls/build.h"
#include "capi/guard.h"
#include "capi/views.h"
#include "sampling/mesh.h"
#include "sampling/points.h"
#include "sampling/range_scan.h"
#include "sampling/volume.h"

using namespace vbm::impl;

namespace {

/// Sample with `sample(options, progress)`, then build.
template <class Sampler>
vbm_status build(vbm_context *context, const vbm_build_options *options, vbm_model **out,
                 Sampler &&sample) noexcept {
  return guarded(context, out, [&](Progress &progress) {
    const vbm_build_options o = read_options(options);
    progress.stage("sampling", 0.05);
    return new vbm_model(build_model(sample(o, progress), o, progress));
  });
}

/// Times a spacing that was chosen, not given, is halved if the surface has not the mesh's
/// topology.
constexpr int kMaxHalvings = 2;

void require(const void *pointer, size_t count, const char *what) {
  if (!pointer && count)
    throw Error(VBM_ERROR_ARGUMENT,
                std::string(what) + " is NULL, but " + std::to_string(count) + " were announced");
}

} // namespace

extern "C" {

vbm_status vbm_build_points(vbm_context *context, const double *points, size_t count,
                            const double *normals, const vbm_build_options *options,
                            vbm_model **out) {
  return build(context, options, out, [&](const vbm_build_options &o, Progress &progress) {
    require(points, count, "points");
    return sample_points(points, count, normals, o, progress);
  });
}

vbm_status vbm_build_mesh(vbm_context *context, const double *vertices, size_t vertex_count,
                          const uint32_t *face_sizes, const int32_t *corners, size_t corner_count,
                          size_t face_count, const vbm_build_options *options, vbm_model **out) {
  return guarded(context, out, [&](Progress &progress) {
    vbm_build_options o = read_options(options);
    require(vertices, vertex_count, "vertices");
    require(corners, corner_count, "corners");
    const bool choose = o.spacing == 0;
    for (int halved = 0;; ++halved) {
      progress.stage("sampling", halved ? 0.9 : 0.05);
      Samples samples = sample_mesh(vertices, vertex_count, face_sizes, corners, corner_count,
                                    face_count, o, progress);
      Model model = build_model(std::move(samples), o, progress);
      if (!choose || !o.refine || !model.wrong_topology || halved == kMaxHalvings ||
          !(model.report.spacing > 0))
        return new vbm_model(std::move(model));
      o.spacing = model.report.spacing / 2;
    }
  });
}

vbm_status vbm_build_volume(vbm_context *context, const void *values, vbm_scalar type, size_t nx,
                            size_t ny, size_t nz, const double voxel_size[3], const double *origin,
                            double level, const vbm_build_options *options, vbm_model **out) {
  return build(context, options, out, [&](const vbm_build_options &o, Progress &progress) {
    require(values, 1, "values");
    require(voxel_size, 3, "voxel_size");
    return sample_volume(values, type, nx, ny, nz, voxel_size, origin, level, o, progress);
  });
}

vbm_status vbm_build_range_scan(vbm_context *context, const double *points, size_t count,
                                const double *scanners, size_t scanner_count,
                                const int32_t *scanner_of_point, const vbm_build_options *options,
                                vbm_model **out) {
  return build(context, options, out, [&](const vbm_build_options &o, Progress &progress) {
    require(points, count, "points");
    require(scanners, scanner_count, "scanners");
    return sample_range_scan(points, count, scanners, scanner_count, scanner_of_point, o, progress);
  });
}

void vbm_model_free(vbm_model *model) { delete model; }

vbm_status vbm_model_get_report(const vbm_model *model, vbm_model_report *report) {
  return copy_report(model ? &model->model.report : nullptr, report);
}

const char *vbm_model_notes(const vbm_model *model) {
  return model ? model->model.notes.c_str() : "";
}

const double *vbm_model_centers(const vbm_model *m, size_t *count) {
  return m ? view(m->model.centers, 3, count) : none<double>(count);
}
const double *vbm_model_radii(const vbm_model *m, size_t *count) {
  return m ? view(m->model.radii, 1, count) : none<double>(count);
}
const uint8_t *vbm_model_inside(const vbm_model *m, size_t *count) {
  return m ? view(m->model.ball_inside, 1, count) : none<uint8_t>(count);
}
size_t vbm_model_inner_count(const vbm_model *m) { return m ? m->model.inner : 0; }

const int32_t *vbm_model_ball_samples(const vbm_model *m, const uint64_t **offsets, size_t *count) {
  return m ? view(m->model.ball_samples, offsets, count) : none(offsets, count);
}
const int32_t *vbm_model_ball_neighbors(const vbm_model *m, const uint64_t **offsets,
                                        size_t *count) {
  return m ? view(m->model.ball_neighbors, offsets, count) : none(offsets, count);
}

const double *vbm_model_samples(const vbm_model *m, size_t *count) {
  return m ? view(m->model.sample_positions, 3, count) : none<double>(count);
}
const int32_t *vbm_model_sample_input(const vbm_model *m, size_t *count) {
  return m ? view(m->model.samples.input, 1, count) : none<int32_t>(count);
}
const int32_t *vbm_model_input_sample(const vbm_model *m, size_t *count) {
  return m ? view(m->model.samples.input_sample, 1, count) : none<int32_t>(count);
}
const int32_t *vbm_model_undersampled(const vbm_model *m, size_t *count) {
  return m ? view(m->model.undersampled, 1, count) : none<int32_t>(count);
}
const double *vbm_model_inner_radius(const vbm_model *m, size_t *count) {
  return m ? view(m->model.inner_radius, 1, count) : none<double>(count);
}
const double *vbm_model_outer_radius(const vbm_model *m, size_t *count) {
  return m ? view(m->model.outer_radius, 1, count) : none<double>(count);
}

} // extern "C"
