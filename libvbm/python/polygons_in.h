// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of a mesh from whatever Python has them in.
#pragma once

#include "arrays.h"

namespace vbm::python {

/// Polygons as the library takes them; the arrays may be the caller's own.
struct PolygonsIn {
  py::array_t<uint32_t, kInPlace> size_array;
  Indices corner_array;

  View<uint32_t> sizes() const { return {size_array.data(), std::size_t(size_array.size())}; }
  View<int32_t> corners() const { return {corner_array.data(), std::size_t(corner_array.size())}; }
};

/// An (m, 3) array.
Indices triangle_array(const py::object &value);

/// A tuple (sizes, corners) of flat arrays, an (m, k) array, or a sequence of index sequences.
PolygonsIn polygons_in(const py::object &value);

} // namespace vbm::python
