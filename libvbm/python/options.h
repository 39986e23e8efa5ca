// SPDX-License-Identifier: GPL-3.0-or-later
// Build options as keyword arguments, and the parameter table as Python sees it.
#pragma once

#include "signature.h"

#include <vbm/vbm.hpp>

namespace vbm::python {

/// The library's build parameters, in the table's order, as keyword-only ones with its defaults.
std::vector<Parameter> build_parameters();

/// What help() says about them.
std::string build_parameters_doc();

/// Whether a row of the table is an option that this module can set.
bool is_build_option(const vbm_param &param);

/// Options from the arguments given, the rest at their defaults.
BuildOptions build_options(const Arguments &arguments);

/// The value of an enum of the table from its name. Throws TypeError, ArgumentError.
int32_t enum_value(const char *operation, const char *parameter, py::handle name);
/// A row of the table.
const vbm_param &table_row(const char *operation, const char *name);

/// An argument as the table's row has it; the row's default where none was given. Throw TypeError and
/// ArgumentError.
double number_option(const vbm_param &row, const Arguments &arguments);
uint64_t count_option(const vbm_param &row, const Arguments &arguments);
int32_t enum_option(const vbm_param &row, const Arguments &arguments);

/// A value of the table's labels or balls, by name.
std::string enum_name(const char *parameter, int value);

/// The table's parameters of an operation, as keyword-only ones with its defaults.
std::vector<Parameter> parameters_of(const char *operation);

/// What help() says about them.
std::string parameters_doc_of(const char *operation);

/// A caller's value for a parameter of the table. Throw TypeError, ArgumentError.
double number_for(const vbm_param &param, py::handle value);
int32_t item_for(const vbm_param &param, py::handle value);

void bind_parameters(py::module_ &module);

} // namespace vbm::python
