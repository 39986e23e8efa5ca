// SPDX-License-Identifier: GPL-3.0-or-later
// Running the library from Python: the GIL released, progress reported, Ctrl-C obeyed.
#pragma once

#include <pybind11/pybind11.h>
#include <vbm/vbm.hpp>

namespace vbm::python {

namespace py = pybind11;

/// What goes between the library's progress reports and Python. `callback` may be None.
Context::Progress progress_to(const py::object &callback);

/// What set_threads() was last called with.
int most_threads();

/// set_threads().
void bind_threads(py::module_ &module);

/// Call work(context) without the GIL. `callback`: None or callable(fraction, stage).
template <class Work> auto run(const py::object &callback, Work work) {
  Context context;
  context.set_threads(most_threads());
  context.set_progress(progress_to(callback));
  py::gil_scoped_release released;
  return work(context);
}

/// What help() says of `progress`.
extern const char *const kProgressDoc;

} // namespace vbm::python
