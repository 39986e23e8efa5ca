// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygons_in.h"

#include "errors.h"

#include <algorithm>
#include <vector>

namespace vbm::python {

namespace {

constexpr const char *kForms =
    "faces must be a sequence of index sequences, an (m, k) array, or a tuple (sizes, corners) of "
    "two flat arrays";

bool is_flat_array(const py::handle &value) {
  return py::isinstance<py::array>(value) && py::reinterpret_borrow<py::array>(value).ndim() == 1;
}

PolygonsIn from_pair(const py::tuple &pair) {
  const Indices sizes = indices(pair[0], "the face sizes", "face");
  PolygonsIn result;
  result.corner_array = indices(pair[1], "the faces' corners", "corner");
  for (py::ssize_t i = 0; i < sizes.size(); ++i)
    if (sizes.data()[i] < 0)
      throw Error(VBM_ERROR_INPUT,
                  "face " + std::to_string(i) + " has the size " + std::to_string(sizes.data()[i]),
                  "face", {i}, 1);
  result.size_array = py::array_t<uint32_t, kInPlace>(sizes.attr("view")("uint32"));
  return result;
}

PolygonsIn from_rows(const py::array &rows) {
  const Indices corners = indices(rows, "faces", "face");
  PolygonsIn result;
  result.size_array = py::array_t<uint32_t, kInPlace>(rows.shape(0));
  std::fill_n(result.size_array.mutable_data(), rows.shape(0), uint32_t(rows.shape(1)));
  result.corner_array = Indices(corners.attr("reshape")(-1));
  return result;
}

PolygonsIn from_sequence(const py::object &faces) {
  std::vector<uint32_t> sizes;
  std::vector<int32_t> corners;
  std::size_t number = 0;
  for (const py::handle face : faces) {
    const std::string where = "face " + std::to_string(number);
    if (py::isinstance<py::str>(face) || !PySequence_Check(face.ptr()))
      throw py::type_error(where + " is not a sequence of vertex indices, but " +
                           Py_TYPE(face.ptr())->tp_name);
    const std::size_t begin = corners.size();
    for (const py::handle corner : face) {
      const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(corner.ptr()));
      if (!index || PyBool_Check(corner.ptr())) {
        PyErr_Clear();
        throw py::type_error(where + " has a corner that is not a whole number, but " +
                             Py_TYPE(corner.ptr())->tp_name);
      }
      int overflow = 0;
      const long long value = PyLong_AsLongLongAndOverflow(index.ptr(), &overflow);
      if (overflow || value != int32_t(value))
        throw Error(VBM_ERROR_INPUT,
                    where + " has the index " + std::string(py::str(index)) +
                        ", but indices go from 0 to 2147483647",
                    "face", {int64_t(number)}, 1);
      corners.push_back(int32_t(value));
    }
    sizes.push_back(uint32_t(corners.size() - begin));
    ++number;
  }
  return {py::array_t<uint32_t, kInPlace>(py::ssize_t(sizes.size()), sizes.data()),
          Indices(py::ssize_t(corners.size()), corners.data())};
}

} // namespace

Indices triangle_array(const py::object &value) {
  Indices array = indices(value, "triangles", "face");
  if (array.ndim() == 1 && array.size() == 0) array = Indices(array.attr("reshape")(0, 3));
  if (array.ndim() != 2 || array.shape(1) != 3)
    bad_argument("triangles must be an (m, 3) array, not " + shape_text(array) +
                 (array.ndim() == 2 ? ": give other polygons as faces" : ""));
  return array;
}

PolygonsIn polygons_in(const py::object &value) {
  if (py::isinstance<py::tuple>(value)) {
    const auto pair = py::reinterpret_borrow<py::tuple>(value);
    if (pair.size() == 2 && is_flat_array(pair[0]) && is_flat_array(pair[1]))
      return from_pair(pair);
  }
  if (py::isinstance<py::array>(value)) {
    const auto rows = py::reinterpret_borrow<py::array>(value);
    if (rows.ndim() == 2) return from_rows(rows);
    if (rows.ndim() != 1 || rows.dtype().kind() != 'O')
      bad_argument(std::string(kForms) + ", not an array of shape " + shape_text(rows));
  }
  if (py::isinstance<py::str>(value) || !PySequence_Check(value.ptr()))
    throw py::type_error(std::string(kForms) + ", not " + Py_TYPE(value.ptr())->tp_name);
  return from_sequence(value);
}

} // namespace vbm::python
