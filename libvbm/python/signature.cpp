// SPDX-License-Identifier: GPL-3.0-or-later
#include "signature.h"

#include <algorithm>
#include <utility>

namespace vbm::python {

Signature::Signature(std::string function, std::vector<Parameter> parameters, bool method)
    : function_(std::move(function)), parameters_(std::move(parameters)), method_(method) {
  while (positional_ < parameters_.size() && !parameters_[positional_].keyword_only) ++positional_;
}

std::string Signature::doc(const std::string &text) const {
  std::string line = function_ + "(";
  const char *separator = "";
  if (method_) {
    line += "self";
    separator = ", ";
  }
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    if (i == positional_) {
      line += std::string(separator) + "*";
      separator = ", ";
    }
    line += separator + parameters_[i].name;
    if (!parameters_[i].default_text.empty()) line += "=" + parameters_[i].default_text;
    separator = ", ";
  }
  // The form CPython's builtins use; it becomes __text_signature__ and leaves __doc__ clean.
  return line + ")\n--\n\n" + text;
}

Arguments Signature::bind(const py::args &args, const py::kwargs &kwargs) const {
  if (args.size() > positional_)
    throw py::type_error(function_ + "() takes at most " + std::to_string(positional_) +
                         " positional arguments, but " + std::to_string(args.size()) +
                         " were given");
  py::dict values;
  for (std::size_t i = 0; i < args.size(); ++i) values[parameters_[i].name.c_str()] = args[i];
  for (const auto &item : kwargs) {
    const std::string name = py::str(item.first);
    if (std::none_of(parameters_.begin(), parameters_.end(),
                     [&](const Parameter &parameter) { return parameter.name == name; }))
      throw py::type_error(function_ + "() got an unexpected keyword argument '" + name + "'");
    if (values.contains(item.first))
      throw py::type_error(function_ + "() got multiple values for argument '" + name + "'");
    values[item.first] = item.second;
  }
  for (const Parameter &parameter : parameters_)
    if (parameter.default_text.empty() && !values.contains(parameter.name.c_str()))
      throw py::type_error(function_ + "() is missing its argument '" + parameter.name + "'");
  return Arguments(std::move(values));
}

} // namespace vbm::python
