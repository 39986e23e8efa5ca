// SPDX-License-Identifier: GPL-3.0-or-later
#include "pruning.h"

#include "errors.h"

#include <string>

namespace vbm::python {

namespace {

struct Measure {
  const char *name;
  vbm_measure number;
};
// In the order in which thresholds by name are done.
constexpr Measure kMeasures[] = {{"triangles", VBM_MEASURE_TRIANGLES},
                                 {"volume", VBM_MEASURE_VOLUME},
                                 {"balls", VBM_MEASURE_BALLS},
                                 {"width", VBM_MEASURE_WIDTH},
                                 {"angle", VBM_MEASURE_ANGLE}};
constexpr const char *kNames = "triangles, volume, balls, width or angle";

template <class T>
T read(const py::handle &value, const std::string &name, const char *what = "a number") {
  try {
    return value.cast<T>();
  } catch (const py::cast_error &) {
    throw py::type_error(name + " must be " + what + ", not " +
                         std::string(py::str(py::type::of(value).attr("__name__"))));
  }
}

PruneOptions step(const py::handle &value, const std::string &name) {
  if (!PySequence_Check(value.ptr()) || py::isinstance<py::str>(value))
    throw py::type_error(name +
                         " must be (measure, threshold) or (measure, threshold, iterations)");
  const auto given = py::reinterpret_borrow<py::sequence>(value);
  if (given.size() < 2 || given.size() > 3)
    bad_argument(name + " must be (measure, threshold) or (measure, threshold, iterations), not " +
                 std::to_string(given.size()) + " values");
  const py::object first = given[0], second = given[1];
  const auto measure = read<std::string>(first, name + "'s measure", "a name");
  PruneOptions out;
  bool known = false;
  for (const Measure &m : kMeasures)
    if (measure == m.name) out.measure = m.number, known = true;
  if (!known) bad_argument(name + "'s measure is '" + measure + "': use " + kNames);
  out.threshold = read<double>(second, name + "'s threshold");
  if (given.size() == 3) {
    const py::object third = given[2];
    out.iterations = read<int32_t>(third, name + "'s iterations", "a whole number");
  }
  return out;
}

std::vector<PruneOptions> by_name(const Arguments &given) {
  std::vector<PruneOptions> out;
  for (const Measure &measure : kMeasures) {
    const py::object value = given[measure.name];
    if (value.is_none()) continue;
    PruneOptions options;
    options.measure = measure.number;
    options.threshold = read<double>(value, measure.name);
    if (given.given("iterations"))
      options.iterations = read<int32_t>(given["iterations"], "iterations", "a whole number");
    out.push_back(options);
  }
  return out;
}

} // namespace

const char *const kPruneDoc =
    "Remove the parts of level 1 that are not more significant than a threshold, least "
    "significant\n"
    "first, where the topology stays; stayed lists the parts that had to stay.\n\n"
    "  triangles   remove parts of at most so many triangles, or curves of so many edges, ...\n"
    "  volume      ... then those with at most this share of the tetrahedra by volume (0 to 1), "
    "...\n"
    "  balls       ... then those with at most this share of the balls' exact volume (0 to 1), "
    "...\n"
    "  width       ... then those whose samples are at most this far apart, as a share of the\n"
    "              bounding-box diagonal, ...\n"
    "  angle       ... then those whose samples are seen under at most this angle, in degrees\n"
    "  iterations  how often each is done, with parts found anew\n"
    "  steps       instead of these: a list of (measure, threshold) or (measure, threshold,\n"
    "              iterations), done in this order; [('triangles', 5, 2), ('volume', 0.01)] is "
    "the\n"
    "              scheme of thesis 7.7\n";

Signature pruning_signature() {
  std::vector<Parameter> parameters;
  for (const Measure &measure : kMeasures) parameters.push_back({measure.name, "None"});
  parameters.push_back({"steps", "None", true});
  parameters.push_back({"iterations", "1", true});
  parameters.push_back({"progress", "None", true});
  return Signature("prune", std::move(parameters), true);
}

std::vector<PruneOptions> pruning_steps(const Arguments &given) {
  std::vector<PruneOptions> out = by_name(given);
  const py::object steps = given["steps"];
  if (!steps.is_none()) {
    if (!out.empty() || given.given("iterations"))
      bad_argument("prune() takes either steps or thresholds and iterations");
    if (!PySequence_Check(steps.ptr()) || py::isinstance<py::str>(steps))
      throw py::type_error("steps must be a list of (measure, threshold, iterations)");
    for (const py::handle value : steps)
      out.push_back(step(value, "steps[" + std::to_string(out.size()) + "]"));
  }
  if (out.empty()) bad_argument(std::string("prune() needs a threshold: ") + kNames + ", or steps");
  return out;
}

} // namespace vbm::python
