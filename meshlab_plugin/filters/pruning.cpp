// SPDX-License-Identifier: GPL-3.0-or-later
#include "pruning.h"

#include "options.h"
#include "text.h"

namespace vbm_filters {
namespace {

constexpr const char *kFirst = "triangle_"; // prefix of the first pass's parameters

Param &named(std::vector<Param> &params, const std::string &name) {
  for (Param &param : params)
    if (param.name == name) return param;
  throw Failure("The library has no option " + name + ".");
}

vbm::Axis pass(vbm::Context &context, vbm::Axis axis, const vbm_prune_options &options,
               std::vector<std::string> &log) {
  if (options.iterations < 1) return axis;
  const vbm_axis_report before = axis.report();
  vbm::Axis pruned = axis.prune(context, options);
  const vbm_axis_report after = pruned.report();
  std::string measure = "triangles";
  for (const Param &param : library_params("prune"))
    if (param.name == "measure") measure = param.items.at(options.measure);
  log.push_back("Pruned by " + lower(measure) + " up to " + number(options.threshold) + ", " +
                count(options.iterations, "time", "times") + ": " +
                count(before.triangles, "triangle", "triangles") + " in " +
                count(before.parts, "part", "parts") + " became " + count(after.triangles) +
                " in " + count(after.parts) + ".");
  add_notes(pruned.notes(), log);
  return pruned;
}

} // namespace

std::vector<Param> axis_params() { return library_params("medial_axis"); }

std::vector<Param> pruning_params() {
  std::vector<Param> second = library_params("prune");
  // No iterations: the pass is left out.
  Param &iterations = named(second, "iterations");
  iterations.minimum = 0;
  iterations.help += "; 0 leaves this out";
  named(second, "measure").default_value = VBM_MEASURE_VOLUME;
  Param &threshold = named(second, "threshold");

  Param small = threshold;
  small.name = kFirst + small.name;
  small.label = "Small Parts: Triangles";
  small.help = "First, parts at the border with no more triangles than this, and curves with no "
               "more edges, go";
  Param times = iterations;
  times.name = kFirst + times.name;
  times.label = "Small Parts: Iterations";
  times.default_value = 2;

  threshold.default_value = 0.01;
  threshold.help = "Then, parts up to this of the measure go, least significant first, where the "
                   "topology stays. 0.01 is one per cent of the volume or width";
  std::vector<Param> params = {small, times};
  params.insert(params.end(), second.begin(), second.end());
  return params;
}

vbm::Axis build_axis(vbm::Context &context, const vbm::Model &model, const Values &values) {
  vbm::AxisOptions options;
  set_options(options, "medial_axis", values);
  return vbm::medial_axis(context, model, options);
}

vbm::Axis prune(vbm::Context &context, vbm::Axis axis, const Values &values, Progress &progress,
                int from, int to, std::vector<std::string> &log) {
  vbm::PruneOptions first, second;
  Values firsts;
  for (const Param &param : library_params("prune"))
    if (values.has(kFirst + param.name)) firsts.set(param.name, values.get(kFirst + param.name));
  set_options(first, "prune", firsts);
  first.measure = VBM_MEASURE_TRIANGLES;
  set_options(second, "prune", values);
  const int half = (from + to) / 2;
  progress.stage(context, from, half);
  axis = pass(context, std::move(axis), first, log);
  progress.stage(context, half, to);
  return pass(context, std::move(axis), second, log);
}

} // namespace vbm_filters
