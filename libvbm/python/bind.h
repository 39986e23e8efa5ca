// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the module, in the order in which they are added.
#pragma once

#include <pybind11/pybind11.h>
#include <vbm/vbm.hpp>

namespace vbm::python {

/// A new MedialAxis.
pybind11::object axis_to_python(Axis axis);

void bind_axis(pybind11::module_ &module);
void bind_surface(pybind11::module_ &module);
void bind_model(pybind11::module_ &module);
void bind_balls(pybind11::module_ &module);
void bind_build(pybind11::module_ &module);

} // namespace vbm::python
