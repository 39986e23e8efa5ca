// SPDX-License-Identifier: GPL-3.0-or-later
#include "errors.h"

#include <array>

namespace vbm::python {

namespace {

struct Kind {
  const char *name;
  vbm_status status;
  PyObject *const *other_base; // what the same mistake is called in Python, or NULL
  const char *doc;
};

const Kind kKinds[] = {
    {"ArgumentError", VBM_ERROR_ARGUMENT, &PyExc_ValueError,
     "An argument or option out of its range: the caller's mistake."},
    {"InputError", VBM_ERROR_INPUT, &PyExc_ValueError,
     "The data is unusable: not finite, an index out of range, ...\n\n"
     "`elements` lists the points or faces that are to blame."},
    {"DegenerateError", VBM_ERROR_DEGENERATE, nullptr,
     "Too few points, or points that do not span three dimensions."},
    {"NoInteriorError", VBM_ERROR_NO_INTERIOR, nullptr,
     "No inside can be told from the outside: the shape is open or not orientable, or no inner "
     "ball was kept."},
    {"LimitError", VBM_ERROR_LIMIT, nullptr,
     "A limit was reached: see sample_limit and cell_limit of build()."},
    {"OutOfMemory", VBM_ERROR_MEMORY, &PyExc_MemoryError, "There is not enough memory."},
    {"Cancelled", VBM_ERROR_CANCELLED, nullptr, "The progress callback asked to stop."},
    {"InternalError", VBM_ERROR_INTERNAL, nullptr,
     "A defect in libvbm: please report it with its message."},
};
constexpr std::size_t kStatuses = VBM_ERROR_INTERNAL + 1;

// The classes, by status; the base class at VBM_OK. Filled once when the module is loaded and kept
// for as long as the process lives.
std::array<PyObject *, kStatuses> &classes() {
  static std::array<PyObject *, kStatuses> list{};
  return list;
}

void raise(const Error &error) {
  const auto status = std::size_t(error.status);
  const py::handle type = classes()[status < kStatuses ? status : 0];
  const py::object value = type(error.what());
  py::tuple elements(error.elements.size());
  for (std::size_t i = 0; i < error.elements.size(); ++i) elements[i] = py::int_(error.elements[i]);
  value.attr("status") = int(error.status);
  value.attr("kind") = error.kind;
  value.attr("elements") = elements;
  value.attr("total") = error.total;
  PyErr_SetObject(type.ptr(), value.ptr());
}

PyObject *make_class(py::module_ &module, const char *name, const char *doc, py::tuple bases,
                     int status) {
  py::dict members;
  members["status"] = status;
  members["kind"] = "";
  members["elements"] = py::tuple();
  members["total"] = 0;
  const std::string full_name = "vbm." + std::string(name);
  PyObject *type = PyErr_NewExceptionWithDoc(full_name.c_str(), doc, bases.ptr(), members.ptr());
  if (!type) throw py::error_already_set();
  module.add_object(name, type);
  return type;
}

} // namespace

void bind_errors(py::module_ &module) {
  PyObject *base = classes()[VBM_OK] = make_class(
      module, "Error",
      "Anything that went wrong in libvbm; the message says what and where.\n\n"
      "status    the C interface's status code, an int\n"
      "kind      what the elements are: 'vertex', 'face', 'normal', 'option' or ''\n"
      "elements  the input elements the error is about, a tuple of indices (at most 4096)\n"
      "total     how many such elements there are in all",
      py::make_tuple(py::handle(PyExc_RuntimeError)), VBM_ERROR_INTERNAL);
  for (const Kind &kind : kKinds) {
    const py::handle error(base);
    py::tuple bases = py::make_tuple(error);
    if (kind.other_base) bases = py::make_tuple(error, py::handle(*kind.other_base));
    classes()[kind.status] = make_class(module, kind.name, kind.doc, bases, kind.status);
  }
  py::register_local_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const Error &error) {
      raise(error);
    }
  });
}

void bad_argument(const std::string &message) { throw Error(VBM_ERROR_ARGUMENT, message); }

} // namespace vbm::python
