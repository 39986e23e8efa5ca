// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.h"

#include "errors.h"

#include <cstring>
#include <variant>
#include <vector>

namespace vbm::python {

namespace {

// Where a parameter of the table is kept.
struct Field {
  const char *name;
  std::variant<int32_t vbm_build_options::*, uint64_t vbm_build_options::*,
               double vbm_build_options::*>
      member;
};

const Field kFields[] = {
    {"balls", &vbm_build_options::balls},
    {"labels", &vbm_build_options::labels},
    {"spacing", &vbm_build_options::spacing},
    {"undersampling", &vbm_build_options::undersampling},
    {"drop_invalid", &vbm_build_options::drop_invalid},
    {"refine", &vbm_build_options::refine},
    {"sample_limit", &vbm_build_options::sample_limit},
    {"cell_limit", &vbm_build_options::cell_limit},
};

const Field *field_of(const vbm_param &param) {
  if (std::strcmp(param.operation, "build") != 0) return nullptr;
  for (const Field &field : kFields)
    if (!std::strcmp(field.name, param.name)) return &field;
  return nullptr; // a newer library's: not offered by this module
}

std::string type_name(py::handle value) { return Py_TYPE(value.ptr())->tp_name; }

double to_double(const vbm_param &param, py::handle value) {
  // Strings do have __float__-like readings, booleans are whole numbers: neither is meant here.
  const double number = PyBool_Check(value.ptr()) ? -1 : PyFloat_AsDouble(value.ptr());
  if (PyBool_Check(value.ptr()) || PyErr_Occurred()) {
    PyErr_Clear();
    throw py::type_error(std::string(param.name) + " must be a number, not " + type_name(value));
  }
  return number;
}

uint64_t to_count(const vbm_param &param, py::handle value) {
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!index || PyBool_Check(value.ptr())) {
    PyErr_Clear();
    throw py::type_error(std::string(param.name) + " must be a whole number, not " +
                         type_name(value));
  }
  const unsigned long long count = PyLong_AsUnsignedLongLong(index.ptr());
  if (PyErr_Occurred()) {
    PyErr_Clear();
    bad_argument(std::string(param.name) + " must be from 0 to 2147483647, not " +
                 std::string(py::str(index)));
  }
  return count;
}

int32_t to_bool(const vbm_param &param, py::handle value) {
  // Python's and NumPy's booleans, and 0 or 1.
  const bool number = PyNumber_Check(value.ptr()) && !PyFloat_Check(value.ptr());
  const int truth = number ? PyObject_IsTrue(value.ptr()) : -1;
  if (truth < 0) {
    PyErr_Clear();
    throw py::type_error(std::string(param.name) + " must be True or False, not " +
                         type_name(value));
  }
  return truth;
}

int32_t to_enum(const vbm_param &param, py::handle value) {
  std::string choices;
  for (int i = 0; i < param.enum_count; ++i) {
    if (i) choices += i + 1 == param.enum_count ? " or " : ", ";
    choices += "'" + std::string(param.enum_names[i]) + "'";
  }
  if (!py::isinstance<py::str>(value))
    throw py::type_error(std::string(param.name) + " must be " + choices + ", not " +
                         type_name(value));
  const std::string name = py::cast<std::string>(value);
  for (int i = 0; i < param.enum_count; ++i)
    if (name == param.enum_names[i]) return i;
  bad_argument(std::string(param.name) + " must be " + choices + ", not '" + name + "'");
}

struct Setter {
  vbm_build_options &options;
  const vbm_param &param;
  py::handle value;
  void operator()(int32_t vbm_build_options::*member) const {
    options.*member = item_for(param, value);
  }
  void operator()(uint64_t vbm_build_options::*member) const {
    options.*member = to_count(param, value);
  }
  void operator()(double vbm_build_options::*member) const {
    options.*member = to_double(param, value);
  }
};

} // namespace

int32_t enum_value(const char *operation, const char *parameter, py::handle name) {
  for (const vbm_param &param : parameters())
    if (!std::strcmp(param.operation, operation) && !std::strcmp(param.name, parameter))
      return to_enum(param, name);
  throw py::value_error(std::string("the library has no parameter ") + parameter);
}
double number_for(const vbm_param &param, py::handle value) { return to_double(param, value); }
int32_t item_for(const vbm_param &param, py::handle value) {
  return param.type == VBM_PARAM_ENUM ? to_enum(param, value) : to_bool(param, value);
}

const vbm_param &table_row(const char *operation, const char *name) {
  static const std::vector<vbm_param> rows = parameters();
  for (const vbm_param &row : rows)
    if (!std::strcmp(row.operation, operation) && !std::strcmp(row.name, name)) return row;
  throw py::import_error("libvbm has no parameter " + std::string(name) + " of " + operation);
}

double number_option(const vbm_param &row, const Arguments &arguments) {
  return arguments.given(row.name) ? to_double(row, arguments[row.name]) : row.default_value;
}
uint64_t count_option(const vbm_param &row, const Arguments &arguments) {
  return arguments.given(row.name) ? to_count(row, arguments[row.name])
                                   : uint64_t(row.default_value);
}
int32_t enum_option(const vbm_param &row, const Arguments &arguments) {
  return arguments.given(row.name) ? to_enum(row, arguments[row.name]) : int32_t(row.default_value);
}

bool is_build_option(const vbm_param &param) { return field_of(param); }

BuildOptions build_options(const Arguments &arguments) {
  BuildOptions options;
  for (const vbm_param &param : parameters())
    if (const Field *field = field_of(param); field && arguments.given(param.name))
      std::visit(Setter{options, param, arguments[param.name]}, field->member);
  return options;
}

} // namespace vbm::python
