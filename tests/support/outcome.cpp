// SPDX-License-Identifier: GPL-3.0-or-later
#include "outcome.h"

#include "check_axis.h"
#include "check_model.h"
#include "open_mesh.h"
#include "snapshot.h"

#include <cstring>

namespace {

/// Samples times balls that brute force may take.
constexpr double kBruteForce = 4e6;

using MakeSurface = std::function<vbm_status(vbm_context *, const vbm_model *, vbm_surface **)>;

Topology take_surface(vbm_context *context, const vbm_model *model, const char *name,
                      const MakeSurface &make, const Around &around, Outcome &outcome) {
  vbm_surface *surface = nullptr;
  vbm_status status = VBM_OK;
  around([&] { status = make(context, model, &surface); });
  Topology topology;
  if (status != VBM_OK) {
    outcome.problems += std::string(name) + ": " + vbm_context_message(context) + "\n";
    if (surface) outcome.problems += "a surface beside a failure\n";
    return topology;
  }
  Problems problems = check_surface(surface, model, &topology);
  if (problems.none()) open_mesh_check(surface, problems);
  if (!problems.none()) outcome.problems += std::string(name) + ":\n" + problems.text();
  outcome.bytes += snapshot(surface);
  vbm_surface_free(surface);
  return topology;
}

} // namespace

vbm_build_options make_options(vbm_balls balls, vbm_labels labels) {
  vbm_build_options options;
  vbm_build_options_init(&options, sizeof options);
  options.balls = balls;
  options.labels = labels;
  return options;
}

Build points_of(const shapes::Shape &shape, bool normals) {
  return
      [&shape, normals](vbm_context *context, const vbm_build_options *options, vbm_model **out) {
        return vbm_build_points(context, shape.points.data(), shape.size(),
                                normals ? shape.normals.data() : nullptr, options, out);
      };
}

Build mesh_of(const shapes::Shape &shape) {
  return [&shape](vbm_context *context, const vbm_build_options *options, vbm_model **out) {
    return vbm_build_mesh(context, shape.points.data(), shape.size(), nullptr,
                          shape.triangles.data(), shape.triangles.size(), shape.faces(), options,
                          out);
  };
}

Outcome run(const Build &build, const vbm_build_options &options, const Around &given) {
  const Around around = given ? given : [](const std::function<void()> &call) { call(); };
  Outcome outcome;
  vbm_context *context = nullptr;
  if (vbm_context_create(&context) != VBM_OK) {
    outcome.problems = "no context\n";
    return outcome;
  }
  vbm_model *model = nullptr;
  around([&] { outcome.status = build(context, &options, &model); });
  outcome.message = vbm_context_message(context);
  if (outcome.status == VBM_OK) {
    if (!outcome.message.empty()) outcome.problems += "a message beside success\n";
    outcome.report.struct_size = sizeof outcome.report;
    vbm_model_get_report(model, &outcome.report);
    outcome.notes = vbm_model_notes(model);
    const double work = double(outcome.report.samples) *
                        double(outcome.report.inner_balls + outcome.report.outer_balls);
    const Problems problems = check_model(model, work <= kBruteForce);
    if (!problems.none()) outcome.problems += "model:\n" + problems.text();
    if (!outcome.notes.empty() && outcome.notes.back() != '\n')
      outcome.problems += "notes do not end their line\n";
    outcome.bytes = snapshot(model);
    outcome.surface = take_surface(context, model, "surface", vbm_model_surface, around, outcome);
    outcome.crust = take_surface(
        context, model, "power crust",
        [](vbm_context *c, const vbm_model *m, vbm_surface **out) {
          return vbm_model_power_crust(c, m, nullptr, 0, out);
        },
        around, outcome);
    Problems of_axis;
    around([&] { of_axis = exercise_axis(context, model, &outcome.bytes); });
    if (!of_axis.none()) outcome.problems += of_axis.text();
  } else {
    if (model) outcome.problems += "a model beside a failure\n";
    if (outcome.message.empty()) outcome.problems += "no message\n";
    if (outcome.status == VBM_ERROR_INTERNAL) outcome.problems += outcome.message + "\n";
    const char *kind = nullptr;
    size_t count = 0;
    const int64_t *bad = vbm_context_bad_elements(context, &kind, &count, &outcome.bad_total);
    outcome.kind = kind;
    outcome.bad.assign(bad, bad + count);
    outcome.bytes = std::to_string(outcome.status) + outcome.message;
  }
  vbm_model_free(model);
  vbm_context_free(context);
  return outcome;
}
