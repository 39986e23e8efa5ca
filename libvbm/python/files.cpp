// SPDX-License-Identifier: GPL-3.0-or-later
#include "files.h"

#include "arrays.h"
#include "errors.h"
#include "signature.h"

#include <files/ball_file.h>

#include <algorithm>
#include <cerrno>

namespace vbm::python {

namespace {

const char *const kReadDoc =
    "Read balls from a file: .ply (vertices x y z radius), .csv (x, y, z, radius) or .ma (a medial "
    "mesh,\nas Q-MAT exchanges it), by the name's extension.\n\n"
    "  path            a string or path\n\n"
    "Returns Balls. Raises InputError for a file that is wrong, naming the line or byte; OSError if "
    "it\ncannot be read; OutOfMemory.";

const char *const kWriteDoc =
    "Write balls to a file, by the name's extension: .ply, .csv, .ma, or .urdf, a robot's link whose\n"
    "collision shapes the balls are. Numbers are exact. The file is complete or as it was before.\n\n"
    "  path            a string or path\n"
    "  centers         (n, 3) array\n"
    "  radii           (n,) array\n"
    "  triangles       (m, 3) indices of balls; .ply and .ma\n"
    "  edges           (k, 2) indices of balls; .ply and .ma\n"
    "  attributes      a dict of 'part', 'level' or both: (n,) int32 each; .ply and .csv\n\n"
    "Raises InputError for what is no ball or what the format cannot hold; OSError if it cannot be\n"
    "written; ArgumentError, OutOfMemory.";

struct Field {
  const char *name, *doc;
};
const Field kFields[] = {
    {"centers", "Centres, (n, 3) float64."},
    {"radii", "Radii, (n,) float64."},
    {"triangles", "Triangles, (m, 3) int32 indices of balls."},
    {"edges", "Edges, (k, 2) int32 indices of balls."},
    {"attributes", "What the file tells of each ball besides: a dict of 'part', 'level', int32."},
};

py::handle &balls_class() {
  static py::handle type;
  return type;
}

std::filesystem::path path_of(const py::object &value) {
  const py::object os = py::module_::import("os");
#ifdef _WIN32
  return std::filesystem::u8path(py::str(os.attr("fsdecode")(value)).cast<std::string>());
#else
  return std::filesystem::path(os.attr("fsencode")(value).cast<std::string>());
#endif
}

/// Without the GIL; the files' errors as Python's.
template <class Work> auto with_files(const py::object &path, Work work) {
  try {
    py::gil_scoped_release released;
    return work();
  } catch (const files::BadFile &error) {
    throw Error(VBM_ERROR_INPUT, error.what());
  } catch (const files::NoFile &error) {
    // Python makes FileNotFoundError and so on of the number.
    const py::object strerror = py::module_::import("os").attr("strerror")(error.code);
    PyErr_SetObject(PyExc_OSError, py::make_tuple(error.code, strerror, path).ptr());
    throw py::error_already_set();
  }
}

template <class T> py::array array_of(const std::vector<T> &list, py::ssize_t width) {
  std::vector<py::ssize_t> shape{py::ssize_t(list.size()) / width};
  if (width > 1) shape.push_back(width);
  py::array_t<T> array(shape);
  std::copy(list.begin(), list.end(), array.mutable_data());
  return array;
}

py::object read(const py::object &path) {
  const std::filesystem::path native = path_of(path);
  const files::BallFile b = with_files(path, [&] { return files::read_balls(native); });
  py::dict attributes;
  for (const auto &[name, values] : b.attributes) attributes[name.c_str()] = array_of(values, 1);
  return balls_class()(array_of(b.centers, 3), array_of(b.radii, 1), array_of(b.triangles, 3),
                       array_of(b.edges, 2), attributes);
}

std::vector<int32_t> rows(const py::object &value, const char *name, py::ssize_t width) {
  if (value.is_none()) return {};
  const Indices array = indices(value, name, name);
  if (array.size() && (width > 1 ? array.ndim() != 2 || array.shape(1) != width : array.ndim() != 1))
    bad_argument(std::string(name) + " must be an (n" +
                 (width > 1 ? ", " + std::to_string(width) : ",") + ") array, not " +
                 shape_text(array));
  return {array.data(), array.data() + array.size()};
}

void write(const Arguments &given) {
  const Doubles centers = rows_of_3(given["centers"], "centers");
  const Doubles radii = radii_of(given["radii"], centers.shape(0));
  files::BallFile b;
  b.centers.assign(centers.data(), centers.data() + centers.size());
  b.radii.assign(radii.data(), radii.data() + radii.size());
  b.triangles = rows(given["triangles"], "triangles", 3);
  b.edges = rows(given["edges"], "edges", 2);
  if (!given["attributes"].is_none()) {
    if (!py::isinstance<py::dict>(given["attributes"]))
      throw py::type_error("attributes must be a dict");
    for (const auto &[name, values] : given["attributes"].cast<py::dict>()) {
      const std::string text = py::str(name);
      b.attributes[text] = rows(py::reinterpret_borrow<py::object>(values), text.c_str(), 1);
    }
  }
  const std::filesystem::path native = path_of(given["path"]);
  with_files(given["path"], [&] { files::write_balls(native, b); });
}

} // namespace

void bind_files(py::module_ &module) {
  py::list names;
  for (const Field &field : kFields) names.append(field.name);
  const py::object type = py::module_::import("collections")
                              .attr("namedtuple")("Balls", names, py::arg("module") = "vbm");
  type.attr("__doc__") = "Balls from a file, by read_balls(); a named tuple.";
  for (const Field &field : kFields) type.attr(field.name).attr("__doc__") = field.doc;
  module.add_object("Balls", type);
  balls_class() = py::object(type).release();

  const Signature reading("read_balls", {{"path"}});
  module.def(
      "read_balls",
      [reading](const py::args &args, const py::kwargs &kwargs) {
        return read(reading.bind(args, kwargs)["path"]);
      },
      reading.doc(kReadDoc).c_str());
  const Signature writing("write_balls", {{"path"},
                                          {"centers"},
                                          {"radii"},
                                          {"triangles", "None"},
                                          {"edges", "None"},
                                          {"attributes", "None"}});
  module.def(
      "write_balls",
      [writing](const py::args &args, const py::kwargs &kwargs) {
        write(writing.bind(args, kwargs));
      },
      writing.doc(kWriteDoc).c_str());
}

} // namespace vbm::python
