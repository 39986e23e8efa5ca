// SPDX-License-Identifier: GPL-3.0-or-later
// Unions of any balls: measures and surfaces.
#include "ball_surface/singular_crust.h"
#include "ball_surface/singular_points.h"
#include "ball_surface/skin.h"
#include "ball_surface/union_error.h"
#include "capi/guard.h"
#include "capi/views.h"
#include "core/tolerances.h"
#include "dual/ball_list.h"
#include "measure/union_measures.h"

using namespace vbm::impl;

namespace {

vbm_measures *measure_list(const BallList &list, std::size_t count, Progress &progress) {
  const UnionMeasures unit = union_measures(list.balls, 0, progress);
  vbm_measures result;
  UnionMeasures &m = result.measures;
  const int e = list.frame.exponent;
  m.ball_volume.assign(count, 0);
  m.ball_area.assign(count, 0);
  for (std::size_t b = 0; b < list.balls.size(); ++b) {
    m.ball_volume[list.input[b]] = std::ldexp(unit.ball_volume[b], 3 * e);
    m.ball_area[list.input[b]] = std::ldexp(unit.ball_area[b], 2 * e);
  }
  m.volume = std::ldexp(unit.volume, 3 * e);
  m.area = std::ldexp(unit.area, 2 * e);
  result.report = {sizeof result.report, count, unit.hidden + list.points, m.volume, m.area};
  return new vbm_measures(std::move(result));
}

Surface make_surface(const UnionInput &set, const vbm_ball_surface_options &options,
                     Progress &progress) {
  switch (options.style) {
  case VBM_BALL_STYLE_SKIN:
    return skin_surface(set, options, progress);
  case VBM_BALL_STYLE_POWER_CRUST:
    return singular_crust(set, options, progress);
  default:
    return singular_point_surface(set, options, progress);
  }
}

vbm_surface *surface_of(const UnionInput &set, const vbm_ball_surface_options &options,
                        Progress &progress) {
  if (options.errors) progress.part(0.3);
  Surface surface = make_surface(set, options, progress);
  if (options.errors) {
    progress.part(1);
    measure_errors(surface, set, progress);
  }
  return new vbm_surface{std::move(surface)};
}

UnionInput set_of(BallList list) {
  return {list.frame, std::move(list.balls), std::move(list.input), list.points, 0, nullptr};
}

UnionInput set_of(const Model &model, const uint8_t *keep, size_t keep_count) {
  if (keep && keep_count != model.inner)
    throw Error(VBM_ERROR_ARGUMENT, "keep has " + std::to_string(keep_count) +
                                        " entries, but the model has " +
                                        std::to_string(model.inner) + " inner balls");
  UnionInput set{model.samples.frame, {}, {}, 0, kModelTouch, &model};
  for (std::size_t b = 0; b < model.inner; ++b) {
    if (keep && !keep[b]) continue;
    set.balls.push_back(model.balls[b]);
    set.number.push_back(int32_t(b));
  }
  return set;
}

} // namespace

extern "C" {

vbm_status vbm_union_measures(vbm_context *context, const double *centers, const double *radii,
                              size_t count, vbm_measures **out) {
  return guarded(context, out, [&](Progress &progress) {
    progress.stage("union of balls", 1);
    return measure_list(ball_list(centers, radii, count, progress), count, progress);
  });
}

vbm_status vbm_surface_from_balls(vbm_context *context, const double *centers, const double *radii,
                                  size_t count, const vbm_ball_surface_options *options,
                                  vbm_surface **out) {
  return guarded(context, out, [&](Progress &progress) {
    const vbm_ball_surface_options o = read_options(options);
    progress.stage("balls", 0.02);
    return surface_of(set_of(ball_list(centers, radii, count, progress)), o, progress);
  });
}

vbm_status vbm_model_ball_surface(vbm_context *context, const vbm_model *model, const uint8_t *keep,
                                  size_t keep_count, const vbm_ball_surface_options *options,
                                  vbm_surface **out) {
  return guarded(context, out, [&](Progress &progress) {
    if (!model) throw Error(VBM_ERROR_ARGUMENT, "model is NULL");
    const vbm_ball_surface_options o = read_options(options);
    return surface_of(set_of(model->model, keep, keep_count), o, progress);
  });
}

void vbm_measures_free(vbm_measures *measures) { delete measures; }

vbm_status vbm_measures_get_report(const vbm_measures *measures, vbm_measures_report *report) {
  return copy_report(measures ? &measures->report : nullptr, report);
}
const double *vbm_measures_ball_volumes(const vbm_measures *m, size_t *count) {
  return m ? view(m->measures.ball_volume, 1, count) : none<double>(count);
}
const double *vbm_measures_ball_areas(const vbm_measures *m, size_t *count) {
  return m ? view(m->measures.ball_area, 1, count) : none<double>(count);
}

} // extern "C"
