// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"
#include "bind.h"
#include "errors.h"
#include "options.h"
#include "progress.h"
#include "reports.h"
#include "signature.h"

#include <algorithm>
#include <cstring>
#include <variant>

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

const char *const kSurfaceDoc =
    "A closed surface from any balls, oriented outward and manifold.\n\n"
    "  balls           (n, 3) centres, or a Model, whose inner balls are taken\n"
    "  radii           (n,) numbers, none negative; None with a Model\n"
    "  keep            with a Model: (inner_count,) booleans, which of its inner balls are used\n";

const char *const kSurfaceErrors =
    "\nThe topology of singular_points is that of the union's boundary, whatever the balls are:\n"
    "isolated ones, chains, rings and sheets are fine. That of skin is the union's of balls with\n"
    "radii divided by sqrt(shrink); that of power_crust is the union's, or the notes say that it\n"
    "is not. With a Model, duplicate points are told by the samples that balls\n"
    "touch. Surface.polygon_ball counts the balls given, or the model's.\n"
    "Returns a Surface. Raises InputError (a ball that is not finite or has a negative radius),\n"
    "NoInteriorError (no ball with a radius), LimitError, OutOfMemory, Cancelled, ArgumentError,\n"
    "TypeError. Source: thesis 8.3, 8.5; Edelsbrunner 1999.";

template <class Get> auto viewed(Get get) {
  return [get](const py::object &self) {
    return output((self.cast<const Measures &>().*get)(), self);
  };
}

Measures union_measures_of(const Arguments &given) {
  const Doubles centers = rows_of_3(given["centers"], "centers");
  const Doubles radii = radii_of(given["radii"], centers.shape(0));
  const View<double> radius_view{radii.data(), std::size_t(radii.size())};
  return run(given["progress"], [&](Context &context) {
    return union_measures(context, view_of_3(centers), radius_view);
  });
}

// Where a parameter of the table is kept.
struct Field {
  const char *name;
  std::variant<int32_t vbm_ball_surface_options::*, double vbm_ball_surface_options::*> member;
};
const Field kFields[] = {
    {"style", &vbm_ball_surface_options::style},   {"bulge", &vbm_ball_surface_options::bulge},
    {"bridge", &vbm_ball_surface_options::bridge}, {"shrink", &vbm_ball_surface_options::shrink},
    {"narrow", &vbm_ball_surface_options::narrow}, {"errors", &vbm_ball_surface_options::errors},
};

BallSurfaceOptions surface_options(const Arguments &given) {
  BallSurfaceOptions options;
  for (const vbm_param &param : parameters()) {
    if (std::strcmp(param.operation, "surface_from_balls") || !given.given(param.name)) continue;
    const auto field = std::find_if(std::begin(kFields), std::end(kFields), [&](const Field &f) {
      return !std::strcmp(f.name, param.name);
    });
    if (field == std::end(kFields)) // the library is newer than this module
      bad_argument(std::string("this module cannot set the library's option ") + param.name);
    const py::object value = given[param.name];
    if (auto *item = std::get_if<int32_t vbm_ball_surface_options::*>(&field->member))
      options.*(*item) = item_for(param, value);
    else
      options.*std::get<double vbm_ball_surface_options::*>(field->member) =
          number_for(param, value);
  }
  return options;
}

Surface surface_of(const Arguments &given) {
  const BallSurfaceOptions options = surface_options(given);
  const py::object balls = given["balls"];
  if (py::isinstance<Model>(balls)) {
    if (given.given("radii") && !given["radii"].is_none())
      bad_argument("radii are the model's own: give None, or centres and radii");
    Bytes keep;
    View<uint8_t> view;
    if (const py::object value = given["keep"]; !value.is_none()) {
      const py::array array = py::module_::import("numpy").attr("asarray")(value).cast<py::array>();
      if (array.ndim() != 1 || (array.size() && array.dtype().kind() != 'b'))
        bad_argument("keep must be an (n,) array of booleans, one for each inner ball");
      keep = Bytes(array.attr("astype")("u1"));
      view = {keep.data(), std::size_t(keep.size())};
    }
    const Model &model = balls.cast<const Model &>();
    if (view.size == 0 && !given["keep"].is_none() && model.inner_count() > 0)
      bad_argument("keep has 0 entries, but the model has " + std::to_string(model.inner_count()) +
                   " inner balls");
    return run(given["progress"],
               [&](Context &context) { return surface_from_balls(context, model, view, options); });
  }
  if (!given["keep"].is_none()) bad_argument("keep goes with a Model: leave out balls yourself");
  const Doubles centers = rows_of_3(balls, "balls");
  const Doubles radii = radii_of(given["radii"], centers.shape(0));
  const View<double> radius_view{radii.data(), std::size_t(radii.size())};
  return run(given["progress"], [&](Context &context) {
    return surface_from_balls(context, view_of_3(centers), radius_view, options);
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

  std::vector<Parameter> list{{"balls"}, {"radii", "None"}, {"keep", "None", true}};
  for (Parameter &parameter : parameters_of("surface_from_balls"))
    list.push_back(std::move(parameter));
  list.push_back({"progress", "None", true});
  const Signature surface("surface_from_balls", std::move(list));
  module.def(
      "surface_from_balls",
      [surface](const py::args &args, const py::kwargs &kwargs) {
        return surface_of(surface.bind(args, kwargs));
      },
      surface
          .doc(std::string(kSurfaceDoc) + parameters_doc_of("surface_from_balls") + kProgressDoc +
               kSurfaceErrors)
          .c_str());
}

} // namespace vbm::python
