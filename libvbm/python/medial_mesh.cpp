// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"
#include "bind.h"
#include "errors.h"
#include "progress.h"
#include "reports.h"
#include "signature.h"

#include <limits>
#include <string>

namespace vbm::python {

namespace {

const char *const kMeshDoc =
    "A medial mesh: a simplicial complex whose vertices are balls.\n\n"
    "Made by MedialAxis.simplify() and MedialAxis.curve_skeleton(); never changes afterwards. It\n"
    "stands for its envelope: the union of its balls, of truncated cones along its edges, and of\n"
    "the convex hulls of its triangles' balls. Arrays are read-only views of its own memory, and\n"
    "keep it alive. v stands for vertices, t for triangles, e for edges of curves.";

const char *const kSimplifyDoc =
    "An axis of fewer balls, with the same topology: neighbouring balls are joined where that\n"
    "cannot change it, those that cost least first, and then fitted to the samples.\n\n"
    "  count       balls; fewer if the axis has no more\n"
    "  iterations  how often balls are fitted to the samples they stand for\n";

const char *const kSkeletonDoc =
    "The axis collapsed to curves, with the same topology: it burns from its border at even "
    "speed,\n"
    "and what fire reaches from two sides at once stays. Sheets round cavities stay as "
    "triangles.\n\n"
    "  spur      a branch stays if it is longer than the shape is wide at it by this share of the\n"
    "            bounding-box diagonal, ...\n"
    "  ratio     ... and by this many times that width\n"
    "  spacing   neighbouring balls are about this many times half the shape's width apart\n";

template <class Get> auto viewed(Get get) {
  return [get](const py::object &self) {
    return output((self.cast<const MedialMesh &>().*get)(), self);
  };
}

template <class Whole> Whole whole(const Arguments &given, const char *name) {
  const py::object value = given[name];
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!index || PyBool_Check(value.ptr())) {
    PyErr_Clear();
    throw py::type_error(std::string(name) + " must be a whole number, not " +
                         Py_TYPE(value.ptr())->tp_name);
  }
  int overflow = 0;
  const long long number = PyLong_AsLongLongAndOverflow(index.ptr(), &overflow);
  constexpr long long most = std::numeric_limits<int32_t>::max();
  if (overflow || number < 0 || number > most)
    bad_argument(std::string(name) + " must be from 0 to " + std::to_string(most) + ", not " +
                 std::string(py::str(index)));
  return Whole(number);
}

double real(const Arguments &given, const char *name) {
  const py::object value = given[name];
  const double number = PyBool_Check(value.ptr()) ? -1 : PyFloat_AsDouble(value.ptr());
  if (PyBool_Check(value.ptr()) || PyErr_Occurred()) {
    PyErr_Clear();
    throw py::type_error(std::string(name) + " must be a number, not " +
                         Py_TYPE(value.ptr())->tp_name);
  }
  return number;
}

// A method of MedialAxis, whose class is another file's.
template <class Call>
void add_method(const py::object &type, const Signature &signature, const char *name, Call call,
                const std::string &doc) {
  type.attr(name) = py::cpp_function(
      [signature, call](const py::object &self, const py::args &args, const py::kwargs &kwargs) {
        return call(axis_of(self), signature.bind(args, kwargs));
      },
      py::name(name), py::is_method(type), signature.doc(doc).c_str());
}

void bind_makers(const py::object &type) {
  add_method(
      type,
      Signature("simplify",
                {{"count", "1000"}, {"iterations", "8", true}, {"progress", "None", true}}, true),
      "simplify",
      [](const std::shared_ptr<const Axis> &axis, const Arguments &given) {
        SimplifyOptions options;
        if (given.given("count")) options.count = whole<uint64_t>(given, "count");
        if (given.given("iterations")) options.iterations = whole<int32_t>(given, "iterations");
        return run(given["progress"],
                   [&](Context &context) { return simplify(context, *axis, options); });
      },
      std::string(kSimplifyDoc) + kProgressDoc +
          "\nReturns a MedialMesh. Raises ArgumentError, also for a count that the topology does "
          "not "
          "allow,\nOutOfMemory, Cancelled. Source: Dey, Edelsbrunner, Guha, Nekhayev, \"Topology "
          "preserving edge\ncontraction\" (1999); Thiery, Guy, Boubekeur, \"Sphere-meshes\" "
          "(2013); "
          "Li et al., \"Q-MAT\" (2015).");
  add_method(
      type,
      Signature("curve_skeleton",
                {{"spur", "0.03", true},
                 {"ratio", "0.5", true},
                 {"spacing", "0.5", true},
                 {"progress", "None", true}},
                true),
      "curve_skeleton",
      [](const std::shared_ptr<const Axis> &axis, const Arguments &given) {
        CurveSkeletonOptions options;
        if (given.given("spur")) options.spur = real(given, "spur");
        if (given.given("ratio")) options.ratio = real(given, "ratio");
        if (given.given("spacing")) options.spacing = real(given, "spacing");
        return run(given["progress"],
                   [&](Context &context) { return curve_skeleton(context, *axis, options); });
      },
      std::string(kSkeletonDoc) + kProgressDoc +
          "\nReturns a MedialMesh. Raises ArgumentError, OutOfMemory, Cancelled. Source: Yan, "
          "Sykes, "
          "Chambers,\nLetscher, Ju, \"Erosion thickness on medial axes of 3D shapes\" (2016).");
}

} // namespace

void bind_medial_mesh(py::module_ &module) {
  py::class_<MedialMesh> type(module, "MedialMesh", kMeshDoc);
  type.def_property_readonly("vertices", viewed(&MedialMesh::vertices),
                             "Vertices, the centres of balls: (v, 3) float64.");
  type.def_property_readonly("radii", viewed(&MedialMesh::radii),
                             "Their balls' radii, (v,) float64.");
  type.def_property_readonly("triangles", viewed(&MedialMesh::triangles),
                             "Triangles, (t, 3) int32 vertex indices.");
  type.def_property_readonly("edges", viewed(&MedialMesh::edges),
                             "Curves: edges of no triangle, (e, 2) int32 vertex indices.");
  type.def_property_readonly(
      "report", [](const MedialMesh &mesh) { return to_python(mesh.report()); },
      "Counts and errors: a MedialMeshReport.");
  type.def_property_readonly(
      "notes", [](const MedialMesh &mesh) { return lines_of(mesh.notes()); },
      "What making this mesh has to say, a list of sentences.");
  type.def("__repr__", [](const MedialMesh &mesh) {
    const vbm_medial_mesh_report report = mesh.report();
    return "<vbm.MedialMesh: " + counted(report.vertices, "ball", "balls") + ", " +
           counted(report.triangles, "triangle", "triangles") + ", " +
           counted(report.curve_edges, "curve edge", "curve edges") + ">";
  });
  bind_makers(module.attr("MedialAxis"));
}

} // namespace vbm::python
