// SPDX-License-Identifier: GPL-3.0-or-later
// Reports as named tuples.
#pragma once

#include <pybind11/pybind11.h>
#include <vbm/vbm.hpp>

namespace vbm::python {

namespace py = pybind11;

/// Add the reports' classes to the module.
void bind_reports(py::module_ &module);

py::object to_python(const vbm_model_report &report);
py::object to_python(const vbm_surface_report &report);
py::object to_python(const vbm_axis_report &report);
py::object to_python(const vbm_medial_mesh_report &report);
py::object to_python(const vbm_clusters_report &report);
py::object to_python(const vbm_cluster_error &error);

/// A list of the lines of a text, each of which ends in a newline.
py::list lines_of(const std::string &text);

/// "1 ball", "12 balls", for __repr__.
std::string counted(uint64_t count, const char *singular, const char *plural);

} // namespace vbm::python
