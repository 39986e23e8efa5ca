// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"

#include "errors.h"

#include <limits>
#include <vector>

namespace vbm::python {

namespace {

constexpr int64_t kMaxIndex = std::numeric_limits<int32_t>::max();
constexpr int64_t kMinIndex = std::numeric_limits<int32_t>::min();
constexpr std::size_t kMaxListed = 4096; // as the C interface lists at most

py::array as_array(const py::object &value, const char *name, const char *shape) {
  try {
    return py::module_::import("numpy").attr("asarray")(value).cast<py::array>();
  } catch (py::error_already_set &error) {
    if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError)) throw;
    throw py::type_error(std::string(name) + " must be " + shape +
                         "; NumPy cannot make an array of what was given");
  }
}

std::string type_text(const py::array &array) {
  const char kind = array.dtype().kind();
  return kind == 'O'                  ? "objects"
         : kind == 'U' || kind == 'S' ? "strings"
                                      : std::string(py::str(array.dtype()));
}

// The first numbers that do not fit, with the rows they are in.
[[noreturn]] void throw_too_large(const py::array &array, const py::array_t<int64_t> &wide,
                                  const char *element) {
  const int64_t *data = wide.data();
  const py::ssize_t width = wide.ndim() > 1 ? wide.shape(1) : 1;
  std::vector<int64_t> rows;
  std::size_t total = 0;
  std::string number;
  int64_t last = -1;
  for (py::ssize_t i = 0; i < wide.size(); ++i) {
    if (data[i] >= kMinIndex && data[i] <= kMaxIndex) continue;
    if (i / width == last) continue;
    last = i / width;
    if (total++ == 0) number = py::str(array.attr("flat")[py::int_(i)]);
    if (rows.size() < kMaxListed) rows.push_back(last);
  }
  const std::string first = std::to_string(rows.front());
  throw Error(VBM_ERROR_INPUT,
              std::string(element) + " " + first + " has the index " + number +
                  ", but indices go from 0 to " + std::to_string(kMaxIndex),
              element, std::move(rows), total);
}

} // namespace

std::string shape_text(const py::array &array) { return py::str(array.attr("shape")); }

py::array numbers(const py::object &value, const char *name, const char *shape) {
  py::array array = as_array(value, name, shape);
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    throw py::type_error(std::string(name) + " must be " + shape + " of real numbers, not of " +
                         type_text(array));
  return array;
}

Doubles rows_of_3(const py::object &value, const char *name) {
  py::array array = numbers(value, name, "an (n, 3) array");
  if (array.ndim() == 1 && array.size() == 0) array = array.reshape({0, 3});
  if (array.ndim() != 2 || array.shape(1) != 3)
    bad_argument(std::string(name) + " must be an (n, 3) array, not " + shape_text(array));
  return Doubles(std::move(array));
}

Doubles radii_of(const py::object &value, py::ssize_t balls) {
  py::array array = numbers(value, "radii", "an (n,) array");
  if (array.ndim() != 1 || array.size() != balls)
    bad_argument("radii must be an (n,) array of a radius for each of the " +
                 std::to_string(balls) + (balls == 1 ? " centre" : " centres") + ", not " +
                 shape_text(array));
  return Doubles(std::move(array));
}

Indices indices(const py::object &value, const char *name, const char *element) {
  const py::array array = as_array(value, name, "an array of whole numbers");
  const char kind = array.dtype().kind();
  if (array.size() != 0 && kind != 'i' && kind != 'u')
    throw py::type_error(std::string(name) + " must hold whole numbers, not " + type_text(array));
  const bool fits = array.itemsize() < 4 || (array.itemsize() == 4 && kind == 'i');
  if (!fits && array.size() != 0) {
    // Unsigned numbers beyond int64 become negative ones, which are out of range as well.
    const py::array_t<int64_t, kInPlace> wide(array);
    const int64_t *data = wide.data();
    for (py::ssize_t i = 0; i < wide.size(); ++i)
      if (data[i] < kMinIndex || data[i] > kMaxIndex) throw_too_large(array, wide, element);
  }
  return Indices(array);
}

py::array output(const void *data, const py::dtype &type, std::size_t size, std::size_t width,
                 const py::object &owner) {
  std::vector<py::ssize_t> shape{py::ssize_t(size)};
  if (width > 1) shape.push_back(py::ssize_t(width));
  if (size == 0) data = nullptr; // nothing to share
  py::array array(type, std::move(shape), data, data ? py::handle(owner) : py::handle());
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

py::tuple output(const Lists &lists, const py::object &owner) {
  return py::make_tuple(output(lists.offsets, owner), output(lists.indices, owner));
}

py::array output_row(const Lists &lists, const py::object &owner, py::ssize_t index,
                     const char *what) {
  const auto size = py::ssize_t(lists.size());
  if (index < -size || index >= size)
    throw py::index_error("there is no " + std::string(what) + " " + std::to_string(index) +
                          ": there are " + std::to_string(size));
  return output(lists[std::size_t(index < 0 ? index + size : index)], owner);
}

} // namespace vbm::python
