// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the module, in the order in which they are added.
#pragma once

#include <pybind11/pybind11.h>

namespace vbm::python {

void bind_surface(pybind11::module_ &module);
void bind_model(pybind11::module_ &module);
void bind_build(pybind11::module_ &module);

} // namespace vbm::python
