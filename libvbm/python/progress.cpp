// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.h"

#include "errors.h"

#include <atomic>
#include <chrono>
#include <climits>
#include <memory>

namespace vbm::python {

namespace {

using Clock = std::chrono::steady_clock;
// Without a callback the GIL is wanted for Ctrl-C only: often enough for people.
constexpr std::chrono::milliseconds kSignalInterval{50};

std::atomic<int> threads{0};

bool on_main_thread() {
  const auto threading = py::module_::import("threading");
  return threading.attr("get_ident")().equal(threading.attr("main_thread")().attr("ident"));
}

bool report(const py::object &callback, double fraction, const char *stage) {
  py::gil_scoped_acquire gil;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (callback.is_none()) return false;
  const int cancel = PyObject_IsTrue(callback(fraction, stage).ptr());
  if (cancel < 0) throw py::error_already_set();
  return cancel;
}

} // namespace

int most_threads() { return threads; }

void bind_threads(py::module_ &module) {
  module.def(
      "set_threads",
      [](const py::object &most) {
        int overflow = 0;
        const long long number =
            PyIndex_Check(most.ptr()) ? PyLong_AsLongLongAndOverflow(most.ptr(), &overflow) : -1;
        if (overflow < 0 || (!overflow && number < 0))
          bad_argument("most must be a whole number, 0 or more, not " +
                       py::repr(most).cast<std::string>());
        threads = overflow || number > INT_MAX ? INT_MAX : int(number);
      },
      py::arg("most"),
      "set_threads(most)\n--\n\n"
      "Calls from here on work with no more than `most` threads at once, the calling one included; "
      "with 0,\n"
      "as at first, with as many as there are processors. Results are the same with any number.");
}

const char *const kProgressDoc =
    "  progress        callable(fraction, stage): fraction goes from 0 to 1 and never down, stage\n"
    "                  names the work. Return True to cancel (raises Cancelled); an exception\n"
    "                  raised in it cancels as well and is passed on. Ctrl-C always cancels.\n";

Context::Progress progress_to(const py::object &callback) {
  if (!callback.is_none()) {
    if (!PyCallable_Check(callback.ptr()))
      throw py::type_error("progress must be callable(fraction, stage) or None");
    // The caller's argument list holds the callback for as long as the call lasts, so the copies of
    // this function may hold a bare handle and be made and destroyed without the GIL.
    return [handle = py::handle(callback)](double fraction, const char *stage) {
      py::gil_scoped_acquire gil;
      return report(py::reinterpret_borrow<py::object>(handle), fraction, stage);
    };
  }
  if (!on_main_thread()) return {}; // signals are the main thread's business
  return [last = Clock::now()](double fraction, const char *stage) mutable {
    const Clock::time_point now = Clock::now();
    if (now - last < kSignalInterval) return false;
    last = now;
    py::gil_scoped_acquire gil;
    return report(py::none(), fraction, stage);
  };
}

} // namespace vbm::python
