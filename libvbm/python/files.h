// SPDX-License-Identifier: GPL-3.0-or-later
// Balls in files.
#pragma once

#include <pybind11/pybind11.h>

namespace vbm::python {

/// Add Balls, read_balls() and write_balls() to the module.
void bind_files(pybind11::module_ &module);

} // namespace vbm::python
