// SPDX-License-Identifier: GPL-3.0-or-later
// Reports as named tuples.
#pragma once

#include <pybind11/pybind11.h>
#include <vbm/vbm.hpp>

namespace vbm::python {

namespace py = pybind11;

/// Add ModelReport and SurfaceReport to the module.
void bind_reports(py::module_ &module);

py::object to_python(const vbm_model_report &report);
py::object to_python(const vbm_surface_report &report);

/// "1 ball", "12 balls", for __repr__.
std::string counted(uint64_t count, const char *singular, const char *plural);

} // namespace vbm::python
