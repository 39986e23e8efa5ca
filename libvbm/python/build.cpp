// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"
#include "bind.h"
#include "errors.h"
#include "options.h"
#include "polygons_in.h"
#include "progress.h"

#include <array>

namespace vbm::python {

namespace {

const char *const kBuildDoc =
    "Build a Voronoi ball model from points, or from a triangle or polygon mesh.\n\n"
    "  points          (n, 3) numbers: a scan's points or a mesh's vertices, in any units\n"
    "  triangles       (m, 3) whole numbers: vertex indices, counter-clockwise seen from outside.\n"
    "                  The mesh may be open. Samples are the vertices that faces use, and points "
    "on\n"
    "                  edges and faces as `spacing` says. Without faces, the points are the "
    "samples\n"
    "  normals         (n, 3) numbers: outward normals of bare points, of any length; a zero "
    "normal\n"
    "                  means unknown\n"
    "  faces           polygons in place of triangles: a sequence of index sequences, an (m, k) "
    "array,\n"
    "                  a Surface's polygons, or a tuple (sizes, corners) of two flat arrays\n";

const char *const kVolumeDoc =
    "Build a Voronoi ball model from a volume: CT, MRI, a mask, a distance field.\n\n"
    "  values          (nx, ny, nz) booleans or numbers, one a voxel. bool, uint8, uint16, int16,\n"
    "                  float32 and float64 are used as they are, others converted\n"
    "  level           voxels with a value >= level are inside; the surface lies between voxels, "
    "at\n"
    "                  the level by linear interpolation. Shapes that touch the border are closed\n"
    "                  there\n"
    "  voxel_size      distance between voxel centres: one length, or one for each axis\n"
    "  origin          where the centre of voxel (0, 0, 0) is\n";

const char *const kRangeScanDoc =
    "Build a Voronoi ball model from range scans: points, and where the scanner stood that saw "
    "them.\n\n"
    "  points          (n, 3) numbers\n"
    "  scanners        (k, 3) numbers: scanner positions; or (3,), one position for all points\n"
    "  scanner_of_point\n"
    "                  (n,) whole numbers: which scanner saw each point. None if there is one "
    "scanner\n"
    "                  for all points, or one for each\n";

const char *const kBuildErrors =
    "\nReturns a Model. Arrays of float64 and int32 in C order are used in place, others "
    "converted;\n"
    "do not change them meanwhile: the GIL is released while it works. The same input and options\n"
    "give the same bytes.\n"
    "Raises InputError (not finite, an index out of range), DegenerateError (too few points, or "
    "flat),\n"
    "NoInteriorError (no inside: open or not orientable), LimitError, OutOfMemory, Cancelled,\n"
    "ArgumentError (a wrong shape or option), TypeError.\n";

std::vector<Parameter> with_options(std::vector<Parameter> parameters) {
  for (Parameter &option : build_parameters()) parameters.push_back(std::move(option));
  parameters.push_back({"progress", "None", true});
  return parameters;
}

std::string full_doc(const Signature &signature, const char *text, const char *source) {
  return signature.doc(text + build_parameters_doc() + kProgressDoc + kBuildErrors + source);
}

Model build(const Arguments &given) {
  const Doubles points = rows_of_3(given["points"], "points");
  const py::object triangles = given["triangles"], normals = given["normals"],
                   faces = given["faces"], progress = given["progress"];
  const BuildOptions options = build_options(given);
  const bool mesh = !triangles.is_none() || !faces.is_none();
  if (!triangles.is_none() && !faces.is_none()) bad_argument("give triangles or faces, not both");
  if (mesh && !normals.is_none())
    bad_argument("normals are for bare points: a mesh has those of its faces");

  if (!triangles.is_none()) {
    const Indices corners = triangle_array(triangles);
    const View<int32_t, 3> view{corners.data(), std::size_t(corners.shape(0))};
    return run(progress, [&](Context &context) {
      return build_mesh(context, view_of_3(points), view, options);
    });
  }
  if (!faces.is_none()) {
    const PolygonsIn polygons = polygons_in(faces);
    return run(progress, [&](Context &context) {
      return build_mesh(context, view_of_3(points), polygons.sizes(), polygons.corners(), options);
    });
  }
  if (normals.is_none())
    return run(progress, [&](Context &context) {
      return build_points(context, view_of_3(points), {}, options);
    });
  const Doubles normal_array = rows_of_3(normals, "normals");
  if (normal_array.shape(0) != points.shape(0))
    bad_argument("normals must be as many as points: there are " +
                 std::to_string(normal_array.shape(0)) + " for " + std::to_string(points.shape(0)) +
                 " points");
  return run(progress, [&](Context &context) {
    return build_points(context, view_of_3(points), view_of_3(normal_array), options);
  });
}

// The volume's own type if the library knows it, else one that holds its numbers.
py::array volume_array(const py::object &value, vbm_scalar &type) {
  py::array array = py::module_::import("numpy").attr("asarray")(value);
  const char kind = array.dtype().kind();
  const py::ssize_t bytes = array.itemsize();
  if (kind == 'b') {
    type = VBM_SCALAR_UINT8; // True is 1
  } else {
    array = numbers(array, "values", "an (nx, ny, nz) array");
    type = kind == 'u' && bytes == 1   ? VBM_SCALAR_UINT8
           : kind == 'u' && bytes == 2 ? VBM_SCALAR_UINT16
           : kind == 'i' && bytes <= 2 ? VBM_SCALAR_INT16
           : kind == 'f' && bytes <= 4 ? VBM_SCALAR_FLOAT
                                       : VBM_SCALAR_DOUBLE;
  }
  if (array.ndim() != 3)
    bad_argument("values must be an (nx, ny, nz) array, not " + shape_text(array));
  switch (type) {
  case VBM_SCALAR_UINT8:
    return Bytes(kind == 'b' ? array.attr("view")("uint8") : array);
  case VBM_SCALAR_UINT16:
    return py::array_t<uint16_t, kInPlace>(array);
  case VBM_SCALAR_INT16:
    return py::array_t<int16_t, kInPlace>(array);
  case VBM_SCALAR_FLOAT:
    return py::array_t<float, kInPlace>(array);
  default:
    return Doubles(array);
  }
}

// One number for all axes (if `spread`), or three.
void three(const py::object &value, const char *name, bool spread, double (&out)[3]) {
  const char *const wanted = spread ? "one number or three" : "three numbers";
  const Doubles array(numbers(value, name, wanted));
  if (spread && array.ndim() == 0) {
    for (double &number : out) number = *array.data();
  } else if (array.ndim() == 1 && array.size() == 3) {
    std::copy_n(array.data(), 3, out);
  } else {
    bad_argument(std::string(name) + " must be " + wanted + ", not an array of shape " +
                 shape_text(array));
  }
}

Model volume(const Arguments &given) {
  Volume volume;
  const py::array values = volume_array(given["values"], volume.type);
  volume.values = values.data();
  std::copy_n(values.shape(), 3, volume.size);
  if (given.given("voxel_size")) three(given["voxel_size"], "voxel_size", true, volume.voxel_size);
  if (given.given("origin")) three(given["origin"], "origin", false, volume.origin);
  if (given.given("level")) {
    const Doubles level(numbers(given["level"], "level", "a number"));
    if (level.ndim() != 0) bad_argument("level must be a number, not " + shape_text(level));
    volume.level = *level.data();
  }
  const BuildOptions options = build_options(given);
  return run(given["progress"],
             [&](Context &context) { return build_volume(context, volume, options); });
}

Model range_scan(const Arguments &given) {
  const Doubles points = rows_of_3(given["points"], "points");
  py::array position = numbers(given["scanners"], "scanners", "a (k, 3) array");
  if (position.ndim() == 1 && position.size() == 3) position = position.reshape({1, 3});
  const Doubles scanners = rows_of_3(position, "scanners");
  const BuildOptions options = build_options(given);
  View<int32_t> of_point;
  Indices index;
  if (const py::object which = given["scanner_of_point"]; !which.is_none()) {
    index = indices(which, "scanner_of_point", "vertex");
    if (index.ndim() != 1 || index.shape(0) != points.shape(0))
      bad_argument("scanner_of_point must be one whole number for each of the " +
                   std::to_string(points.shape(0)) + " points, not an array of shape " +
                   shape_text(index));
    of_point = {index.data(), std::size_t(index.size())};
  }
  return run(given["progress"], [&](Context &context) {
    return build_range_scan(context, view_of_3(points), view_of_3(scanners), of_point, options);
  });
}

void bind(py::module_ &module, const char *name, const Signature &signature,
          Model (*function)(const Arguments &), const char *text, const char *source) {
  module.def(
      name,
      [signature, function](const py::args &args, const py::kwargs &kwargs) {
        return function(signature.bind(args, kwargs));
      },
      full_doc(signature, text, source).c_str());
}

} // namespace

void bind_build(py::module_ &module) {
  bind(module, "build",
       Signature(
           "build",
           with_options(
               {{"points"}, {"triangles", "None"}, {"normals", "None"}, {"faces", "None", true}})),
       &build, kBuildDoc, "Source: thesis 3.1; Amenta, Choi, Kolluri, \"The power crust\" (2001).");
  bind(module, "build_volume",
       Signature("build_volume", with_options({{"values"},
                                               {"level", "0.5"},
                                               {"voxel_size", "1.0"},
                                               {"origin", "(0.0, 0.0, 0.0)"}})),
       &volume, kVolumeDoc, "Source: thesis 3.1.2 and Theorem 3.2.");
  bind(module, "build_range_scan",
       Signature("build_range_scan",
                 with_options({{"points"}, {"scanners"}, {"scanner_of_point", "None"}})),
       &range_scan, kRangeScanDoc, "Source: thesis 3.1.2 (scan direction test).");
}

} // namespace vbm::python
