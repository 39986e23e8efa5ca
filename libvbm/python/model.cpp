// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"
#include "bind.h"
#include "cluster.h"
#include "errors.h"
#include "options.h"
#include "progress.h"
#include "reports.h"
#include "signature.h"

#include <algorithm>
#include <cmath>

namespace vbm::python {

namespace {

const char *const kModelDoc =
    "A Voronoi ball model: the balls inside a shape, and those outside, that touch its samples.\n\n"
    "Made by build(), build_volume() and build_range_scan(); never changes afterwards. Arrays are\n"
    "read-only views of the model's own memory, and keep it alive. Balls, samples and input "
    "points\n"
    "are named by their indices; the inner balls come first. Lengths are in the input's own "
    "units.\n"
    "n stands for balls, s for samples, p for input points.";

const char *const kSurfaceDoc =
    "The interpolating surface: the boundary of the Delaunay tetrahedra inside the shape.\n\n"
    "Closed, oriented outward and manifold; its vertices are samples. Where tetrahedra meet only\n"
    "along an edge or at a vertex it is split, so that one sample can give several vertices.\n\n";

const char *const kPowerCrustDoc =
    "The power crust: the faces between the inner and the outer balls' cells of the power "
    "diagram.\n\n"
    "Closed, oriented outward and manifold; its polygons tell which ball is behind them.\n\n"
    "  keep            which inner balls to keep: a mask of inner_count booleans, or an array of "
    "ball\n"
    "                  indices. The others leave the diagram, and what they filled becomes "
    "outside.\n"
    "                  None keeps all\n";

const char *const kSurfaceErrors =
    "\nReturns a Surface. The GIL is released while it works.\n"
    "Raises NoInteriorError (nothing is left inside), OutOfMemory, Cancelled";

const char *const kAxisDoc =
    "The medial axis: a Voronoi diagram inside the shape, with all that tells nothing about the "
    "shape\n"
    "collapsed away. Its topology is the shape's.\n\n"
    "  method 'voronoi': the diagram of the samples. 'power_shape': that of the points where "
    "three\n"
    "         balls meet, which gives the axis of the union of the balls; slower\n"
    "  angle  degrees: a piece is axis where the two samples it is equidistant from are seen under "
    "at\n"
    "         least this angle, ...\n"
    "  ratio  ... or are at least this many times farther apart than neighbouring samples\n";

// One byte for every inner ball from a mask or from indices.
Bytes keep_mask(const Model &model, const py::object &value) {
  const py::array given = py::module_::import("numpy").attr("asarray")(value).cast<py::array>();
  if (given.ndim() != 1)
    bad_argument("keep must be a flat mask or list of balls, not an array of shape " +
                 shape_text(given));
  if (given.dtype().kind() == 'b') return Bytes(given.attr("view")("uint8"));
  const Indices balls = indices(given, "keep", "ball");
  Bytes mask(py::ssize_t(model.inner_count()));
  std::fill_n(mask.mutable_data(), mask.size(), uint8_t(0));
  for (py::ssize_t i = 0; i < balls.size(); ++i) {
    const int32_t ball = balls.data()[i];
    if (ball < 0 || ball >= mask.size())
      bad_argument("keep names ball " + std::to_string(ball) +
                   ", but the inner balls go from 0 to " + std::to_string(mask.size() - 1));
    mask.mutable_data()[ball] = 1;
  }
  return mask;
}

// An array of its own, computed from the inner and outer radii.
template <class F> py::array_t<double> from_radii(const Model &model, F value) {
  const View<double> inner = model.inner_radius(), outer = model.outer_radius();
  py::array_t<double> result(py::ssize_t(inner.size));
  for (std::size_t i = 0; i < inner.size; ++i) result.mutable_data()[i] = value(inner[i], outer[i]);
  return result;
}

// A property that is a view into the model.
template <class Get> auto viewed(Get get) {
  return
      [get](const py::object &self) { return output((self.cast<const Model &>().*get)(), self); };
}

void bind_arrays(py::class_<Model> &type) {
  type.def_property_readonly("centers", viewed(&Model::centers),
                             "Centres of the balls, (n, 3) float64; the inner balls first.");
  type.def_property_readonly("radii", viewed(&Model::radii), "Radii of the balls, (n,) float64.");
  type.def_property_readonly(
      "inside",
      [](const py::object &self) {
        const View<uint8_t> inside = self.cast<const Model &>().inside();
        return output(inside.data, py::dtype("?"), inside.size, 1, self);
      },
      "Which balls are inside, (n,) bool.");
  type.def_property_readonly("inner_count", &Model::inner_count,
                             "How many balls are inside: they are the first so many.");
  type.def_property_readonly(
      "samples", viewed(&Model::samples),
      "Samples, (s, 3) float64; those that are input points have exactly the input's coordinates.");
  type.def_property_readonly(
      "sample_input", viewed(&Model::sample_input),
      "For every sample the input point it is, or -1 (added on a face or edge, or from a volume);\n"
      "(s,) int32.");
  type.def_property_readonly(
      "input_sample", viewed(&Model::input_sample),
      "For every input point its sample, which merged points share, or -1 if "
      "it was dropped;\n(p,) int32.");
  type.def_property_readonly("undersampled", viewed(&Model::undersampled),
                             "Samples where the sampling is too thin to trust the surface, "
                             "ascending; int32.\nSource: thesis 7.9.");
  type.def_property_readonly(
      "ball_samples", viewed(&Model::ball_samples),
      "The samples each ball touches, as a pair (offsets, indices): ball b touches\n"
      "indices[offsets[b]:offsets[b + 1]]. (n + 1,) uint64 and int32. See samples_of().");
  type.def_property_readonly(
      "ball_neighbors", viewed(&Model::ball_neighbors),
      "The neighbours of each ball, as a pair like ball_samples: balls of the same side that touch "
      "a\n"
      "common sample, so that their surfaces certainly meet. Ascending. See neighbors_of().");
}

void bind_radii(py::class_<Model> &type) {
  type.def_property_readonly(
      "inner_radius", viewed(&Model::inner_radius),
      "Radius of the inner polar ball at every input point (at every sample for volumes), (p,)\n"
      "float64. NaN where there is none: a dropped point, a sample inside the solid.");
  type.def_property_readonly(
      "outer_radius", viewed(&Model::outer_radius),
      "Radius of the outer polar ball, as inner_radius; infinity where the outside is not curved "
      "in.");
  type.def_property_readonly(
      "thickness",
      [](const Model &model) {
        return from_radii(model, [](double inner, double) { return 2 * inner; });
      },
      "How thick the shape is at every input point (at every sample for volumes): the diameter of\n"
      "its inner polar ball, (p,) float64, NaN where there is none. A new array.");
  type.def_property_readonly(
      "local_feature_size",
      [](const Model &model) {
        return from_radii(model,
                          [](double inner, double outer) { return std::fmin(inner, outer); });
      },
      "About the distance to the medial axis at every input point: the smaller of inner_radius "
      "and\n"
      "outer_radius, (p,) float64, NaN where there is neither. A new array.");
}

void bind_lists(py::class_<Model> &type) {
  type.def(
      "samples_of",
      [](const py::object &self, py::ssize_t ball) {
        return output_row(self.cast<const Model &>().ball_samples(), self, ball, "ball");
      },
      py::arg("ball"),
      Signature("samples_of", {{"ball"}}, true)
          .doc("The samples a ball touches, int32. Raises IndexError.")
          .c_str());
  type.def(
      "neighbors_of",
      [](const py::object &self, py::ssize_t ball) {
        return output_row(self.cast<const Model &>().ball_neighbors(), self, ball, "ball");
      },
      py::arg("ball"),
      Signature("neighbors_of", {{"ball"}}, true)
          .doc("The neighbours of a ball, int32, ascending. Raises IndexError.")
          .c_str());
}

void bind_surfaces(py::class_<Model> &type) {
  const Signature surface("surface", {{"progress", "None", true}}, true);
  type.def(
      "surface",
      [surface](const Model &model, const py::args &args, const py::kwargs &kwargs) {
        const Arguments given = surface.bind(args, kwargs);
        return run(given["progress"], [&](Context &context) { return model.surface(context); });
      },
      surface.doc(std::string(kSurfaceDoc) + kProgressDoc + kSurfaceErrors + ".").c_str());

  const Signature crust("power_crust", {{"keep", "None"}, {"progress", "None", true}}, true);
  type.def(
      "power_crust",
      [crust](const Model &model, const py::args &args, const py::kwargs &kwargs) {
        const Arguments given = crust.bind(args, kwargs);
        if (given["keep"].is_none())
          return run(given["progress"],
                     [&](Context &context) { return model.power_crust(context); });
        const Bytes mask = keep_mask(model, given["keep"]);
        const View<uint8_t> keep{mask.data(), std::size_t(mask.size())};
        return run(given["progress"],
                   [&](Context &context) { return model.power_crust(context, keep); });
      },
      crust
          .doc(std::string(kPowerCrustDoc) + kProgressDoc + kSurfaceErrors +
               ";\nArgumentError for a mask of another length or a ball that does not exist.\n"
               "Source: thesis 8.2; Amenta, Choi, Kolluri, \"The power crust, unions of balls, and "
               "the\nmedial axis transform\" (2001).")
          .c_str());
}

void bind_axis_of(py::class_<Model> &type) {
  std::vector<Parameter> parameters = parameters_of("medial_axis");
  parameters[0].keyword_only = false; // the method
  parameters.push_back({"progress", "None", true});
  const Signature axis("medial_axis", std::move(parameters), true);
  type.def(
      "medial_axis",
      [axis](const Model &model, const py::args &args, const py::kwargs &kwargs) {
        const Arguments given = axis.bind(args, kwargs);
        AxisOptions options;
        if (given.given("method"))
          options.method = enum_value("medial_axis", "method", given["method"]);
        if (given.given("angle"))
          options.angle = number_for(table_row("medial_axis", "angle"), given["angle"]);
        if (given.given("ratio"))
          options.ratio = number_for(table_row("medial_axis", "ratio"), given["ratio"]);
        return axis_to_python(run(given["progress"], [&](Context &context) {
          return medial_axis(context, model, options);
        }));
      },
      axis.doc(std::string(kAxisDoc) + kProgressDoc +
               "\nReturns a MedialAxis. Raises ArgumentError, OutOfMemory, Cancelled.\nSource: "
               "thesis 7.3, 7.4; Dey, Zhao, \"Approximating the medial axis from the Voronoi "
               "diagram\nwith a convergence guarantee\" (2004); Amenta, Kolluri, \"The medial axis "
               "of a union of\nballs\" (2001).")
          .c_str());
}

void bind_cluster_of(py::class_<Model> &type) {
  type.def(
      "cluster",
      [](const Model &model, const py::args &args, const py::kwargs &kwargs) {
        return cluster_model(model, model_cluster_signature().bind(args, kwargs));
      },
      model_cluster_signature().doc(model_cluster_doc()).c_str());
}

std::string repr(const Model &model) {
  const vbm_model_report report = model.report();
  return "<vbm.Model: " + counted(report.inner_balls, "inner ball", "inner balls") + ", " +
         counted(report.outer_balls, "outer ball", "outer balls") + ", " +
         counted(report.samples, "sample", "samples") +
         (report.undersampled ? ", " + std::to_string(report.undersampled) + " undersampled" : "") +
         ">";
}

} // namespace

void bind_model(py::module_ &module) {
  py::class_<Model> type(module, "Model", kModelDoc);
  bind_arrays(type);
  bind_radii(type);
  bind_lists(type);
  type.def_property_readonly(
      "report", [](const Model &model) { return to_python(model.report()); },
      "What was found and done while building: a ModelReport.");
  type.def_property_readonly(
      "notes", [](const Model &model) { return lines_of(model.notes()); },
      "What a user should know about this model: a list of sentences, empty if there is nothing to "
      "say.");
  bind_surfaces(type);
  bind_axis_of(type);
  bind_cluster_of(type);
  type.def("__repr__", &repr);
}

} // namespace vbm::python
