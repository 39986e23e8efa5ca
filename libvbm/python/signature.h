// SPDX-License-Identifier: GPL-3.0-or-later
// One list of parameters from which a function's help and the reading of its arguments both come,
// so that help(), inspect.signature() and what is accepted cannot differ.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace vbm::python {

namespace py = pybind11;

struct Parameter {
  std::string name;
  std::string default_text = {}; ///< As Python source; empty: the argument is required.
  bool keyword_only = false;
};

/// The arguments of one call, by name.
class Arguments {
public:
  explicit Arguments(py::dict values) : values_(std::move(values)) {}
  /// None where the caller gave none.
  py::object operator[](const char *name) const {
    return given(name) ? py::object(values_[name]) : py::none();
  }
  bool given(const char *name) const { return values_.contains(name); }

private:
  py::dict values_;
};

class Signature {
public:
  /// Positional parameters first. `method`: the function has a `self`, which is not in the list.
  Signature(std::string function, std::vector<Parameter> parameters, bool method = false);

  /// A docstring from which Python takes the function's signature.
  std::string doc(const std::string &text) const;

  /// Assign a call's arguments to the parameters as Python does. Throws TypeError.
  Arguments bind(const py::args &args, const py::kwargs &kwargs) const;

private:
  std::string function_;
  std::vector<Parameter> parameters_;
  std::size_t positional_ = 0;
  bool method_;
};

} // namespace vbm::python
