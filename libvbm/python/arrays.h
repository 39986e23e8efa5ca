// SPDX-License-Identifier: GPL-3.0-or-later
// NumPy arrays in and out: input used in place where its layout allows and converted otherwise,
// output as read-only views that keep their owner alive.
#pragma once

#include <pybind11/numpy.h>
#include <vbm/vbm.hpp>

#include <string>

namespace vbm::python {

namespace py = pybind11;

constexpr int kInPlace =
    py::array::c_style | py::array::forcecast | py::detail::npy_api::NPY_ARRAY_ALIGNED_;
using Doubles = py::array_t<double, kInPlace>;
using Indices = py::array_t<int32_t, kInPlace>;
using Bytes = py::array_t<uint8_t, kInPlace>;

// ---- In: `name` is what messages call the argument. Wrong types throw TypeError, wrong shapes and
// ---- values ArgumentError.

/// numpy.asarray of real numbers: no booleans, complex numbers, strings or objects.
py::array numbers(const py::object &value, const char *name, const char *shape);

/// An (n, 3) array of doubles; an empty list is (0, 3).
Doubles rows_of_3(const py::object &value, const char *name);

/// An (n,) array of doubles, one for each of `balls` centres.
Doubles radii_of(const py::object &value, py::ssize_t balls);

/// numpy.asarray of whole numbers in the range of int32; an empty list counts. `element` and `kind`
/// are what the error calls a row that has a greater one: "face".
Indices indices(const py::object &value, const char *name, const char *element);

/// "(3, 4)", for messages.
std::string shape_text(const py::array &array);

inline View<double, 3> view_of_3(const Doubles &array) {
  return {array.data(), std::size_t(array.shape(0))};
}

// ---- Out

/// `size` rows of `width` (1: a flat array) that belong to `owner`, as a read-only array of its
/// own.
py::array output(const void *data, const py::dtype &type, std::size_t size, std::size_t width,
                 const py::object &owner);

template <class T, std::size_t Width>
py::array output(const View<T, Width> &view, const py::object &owner) {
  return output(view.data, py::dtype::of<T>(), view.size, Width, owner);
}

/// A pair (offsets, indices).
py::tuple output(const Lists &lists, const py::object &owner);

/// List number `index` of lists, counted from the end where negative. Throws IndexError, in which
/// the list belongs to a `what`: "ball".
py::array output_row(const Lists &lists, const py::object &owner, py::ssize_t index,
                     const char *what);

} // namespace vbm::python
