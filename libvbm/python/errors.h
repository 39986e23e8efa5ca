// SPDX-License-Identifier: GPL-3.0-or-later
// Python exceptions for the library's errors.
#pragma once

#include <pybind11/pybind11.h>
#include <vbm/vbm.hpp>

#include <string>

namespace vbm::python {

namespace py = pybind11;

/// Add Error and its subclasses to the module, and have vbm::Error turned into them.
void bind_errors(py::module_ &module);

/// What a caller gets for a value the library would never see; an ArgumentError in Python.
[[noreturn]] void bad_argument(const std::string &message);

} // namespace vbm::python
