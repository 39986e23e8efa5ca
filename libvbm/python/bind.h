// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the module, in the order in which they are added.
#pragma once

#include <pybind11/pybind11.h>
#include <vbm/vbm.hpp>

#include <memory>

namespace vbm::python {

/// A new MedialAxis.
pybind11::object axis_to_python(Axis axis);

/// The axis a MedialAxis is now.
std::shared_ptr<const Axis> axis_of(const pybind11::object &axis);

void bind_axis(pybind11::module_ &module);
void bind_medial_mesh(pybind11::module_ &module);
void bind_surface(pybind11::module_ &module);
void bind_model(pybind11::module_ &module);
void bind_balls(pybind11::module_ &module);
void bind_build(pybind11::module_ &module);

} // namespace vbm::python
