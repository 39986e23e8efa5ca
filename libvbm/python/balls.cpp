// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"
#include "bind.h"
#include "errors.h"
#include "progress.h"
#include "reports.h"
#include "signature.h"

namespace vbm::python {

namespace {

const char *const kMeasuresDoc = "Exact measures of a union of balls, by union_measures().\n\n"
                                 "Arrays are read-only views, one number for each ball given.";

const char *const kUnionMeasuresDoc =
    "Volume and area of a union of balls, and of each ball's share: exact, by closed forms.\n\n"
    "  centers   (n, 3) numbers\n"
    "  radii     (n,) numbers, none negative; a radius of 0 is a point, which has no share\n\n"
    "A ball's share is the part of the union in its cell of the balls' power diagram: shares do "
    "not\n"
    "overlap, and sum up to the whole. Of balls that are the same, one has the whole share.\n"
    "Returns a Measures. Raises InputError (a ball that is not finite or has a negative radius),\n"
    "LimitError, OutOfMemory, Cancelled, ArgumentError, TypeError.\n";

template <class Get> auto viewed(Get get) {
  return [get](const py::object &self) {
    return output((self.cast<const Measures &>().*get)(), self);
  };
}

// (n,) doubles, as many as there are balls.
Doubles radii_of(const py::object &value, py::ssize_t balls) {
  py::array array = numbers(value, "radii", "an (n,) array");
  if (array.ndim() != 1 || array.size() != balls)
    bad_argument("radii must be an (n,) array of a radius for each of the " +
                 counted(uint64_t(balls), "centre", "centres") + ", not " + shape_text(array));
  return Doubles(std::move(array));
}

Measures union_measures_of(const Arguments &given) {
  const Doubles centers = rows_of_3(given["centers"], "centers");
  const Doubles radii = radii_of(given["radii"], centers.shape(0));
  const View<double> radius_view{radii.data(), std::size_t(radii.size())};
  return run(given["progress"], [&](Context &context) {
    return union_measures(context, view_of_3(centers), radius_view);
  });
}

} // namespace

void bind_balls(py::module_ &module) {
  py::class_<Measures> type(module, "Measures", kMeasuresDoc);
  type.def_property_readonly(
      "volume", [](const Measures &m) { return m.report().volume; }, "Volume of the union.");
  type.def_property_readonly(
      "area", [](const Measures &m) { return m.report().area; }, "Area of its boundary.");
  type.def_property_readonly(
      "hidden", [](const Measures &m) { return m.report().hidden; },
      "Balls that have no share: within others, duplicates, points.");
  type.def_property_readonly("ball_volumes", viewed(&Measures::ball_volumes),
                             "Each ball's share of the volume, (n,) float64.");
  type.def_property_readonly("ball_areas", viewed(&Measures::ball_areas),
                             "Each ball's share of the area, (n,) float64.");
  type.def("__repr__", [](const Measures &m) {
    const vbm_measures_report report = m.report();
    return "<vbm.Measures of " + counted(report.balls, "ball", "balls") + ": volume " +
           std::string(py::str(py::float_(report.volume))) + ", area " +
           std::string(py::str(py::float_(report.area))) + ">";
  });

  const Signature signature("union_measures", {{"centers"}, {"radii"}, {"progress", "None", true}});
  module.def(
      "union_measures",
      [signature](const py::args &args, const py::kwargs &kwargs) {
        return union_measures_of(signature.bind(args, kwargs));
      },
      signature.doc(std::string(kUnionMeasuresDoc) + kProgressDoc).c_str());
}

} // namespace vbm::python
