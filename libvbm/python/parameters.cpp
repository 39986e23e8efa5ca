// SPDX-License-Identifier: GPL-3.0-or-later
// The library's parameter table as Python's signatures, help and dicts.
#include "options.h"

#include <algorithm>
#include <cstring>
#include <sstream>

namespace vbm::python {

namespace {

py::object default_of(const vbm_param &param) {
  switch (param.type) {
  case VBM_PARAM_BOOL:
    return py::bool_(param.default_value != 0);
  case VBM_PARAM_INT:
    return py::int_(int64_t(param.default_value));
  case VBM_PARAM_ENUM:
    return py::str(param.enum_names[int(param.default_value)]);
  default:
    return py::float_(param.default_value);
  }
}

const char *type_text(int type) {
  switch (type) {
  case VBM_PARAM_BOOL:
    return "bool";
  case VBM_PARAM_INT:
    return "int";
  case VBM_PARAM_FLOAT:
    return "float";
  case VBM_PARAM_LENGTH:
    return "length";
  default:
    return "enum";
  }
}

py::dict describe(const vbm_param &param) {
  py::dict row;
  row["operation"] = param.operation;
  row["name"] = param.name;
  row["label"] = param.label;
  row["help"] = param.help;
  row["unit"] = param.unit;
  row["type"] = type_text(param.type);
  row["default"] = default_of(param);
  const bool whole = param.type == VBM_PARAM_INT;
  if (param.type != VBM_PARAM_ENUM && param.type != VBM_PARAM_BOOL) {
    row["minimum"] = whole ? py::object(py::int_(int64_t(param.minimum)))
                           : py::object(py::float_(param.minimum));
    row["maximum"] = whole ? py::object(py::int_(int64_t(param.maximum)))
                           : py::object(py::float_(param.maximum));
  }
  if (param.type == VBM_PARAM_ENUM) {
    py::list items;
    for (int i = 0; i < param.enum_count; ++i)
      items.append(py::make_tuple(param.enum_names[i], param.enum_labels[i], param.enum_helps[i]));
    row["items"] = items;
  }
  return row;
}

// Help texts are set in columns as wide as a terminal with help()'s own margin.
constexpr std::size_t kIndent = 18, kWidth = 95;

std::string wrapped(std::string line, const std::string &words) {
  std::string text;
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    if (line.size() > kIndent && line.size() + word.size() >= kWidth) {
      text += line + "\n";
      line.assign(kIndent, ' ');
    }
    if (line.back() != ' ') line += ' ';
    line += word;
  }
  return text + line + "\n";
}

} // namespace

namespace {

bool is_build_row(const vbm_param &param) { return is_build_option(param); }

template <class Wanted> std::vector<Parameter> list_parameters(Wanted wanted) {
  std::vector<Parameter> list;
  for (const vbm_param &param : parameters())
    if (wanted(param)) list.push_back({param.name, py::repr(default_of(param)), true});
  return list;
}

template <class Wanted> std::string list_docs(Wanted wanted) {
  std::string text;
  for (const vbm_param &param : parameters()) {
    if (!wanted(param)) continue;
    std::string name = std::string("  ") + param.name;
    name.resize(std::max(name.size() + 1, kIndent), ' ');
    std::string help = param.help;
    if (param.type == VBM_PARAM_FLOAT)
      help += "; " + std::string(py::str(py::float_(param.minimum))) + " to " +
              std::string(py::str(py::float_(param.maximum)));
    text += wrapped(name, help);
    for (int i = 0; i < param.enum_count; ++i)
      text += wrapped(std::string(kIndent, ' '),
                      "'" + std::string(param.enum_names[i]) + "': " + param.enum_helps[i]);
  }
  return text;
}

} // namespace

std::vector<Parameter> build_parameters() { return list_parameters(is_build_row); }
std::string build_parameters_doc() { return list_docs(is_build_row); }

std::vector<Parameter> parameters_of(const char *operation) {
  return list_parameters(
      [&](const vbm_param &param) { return !std::strcmp(param.operation, operation); });
}
std::string parameters_doc_of(const char *operation) {
  return list_docs(
      [&](const vbm_param &param) { return !std::strcmp(param.operation, operation); });
}

std::string enum_name(const char *parameter, int value) {
  for (const vbm_param &param : parameters())
    if (!std::strcmp(param.operation, "build") && !std::strcmp(param.name, parameter) &&
        value >= 0 && value < param.enum_count)
      return param.enum_names[value];
  return std::to_string(value);
}

void bind_parameters(py::module_ &module) {
  module.def(
      "parameters",
      [] {
        py::list table;
        for (const vbm_param &param : parameters()) table.append(describe(param));
        return table;
      },
      Signature("parameters", {})
          .doc("The library's parameter table, from which dialogs can be built: a list of dicts.\n"
               "\n"
               "operation         what it belongs to: 'build', ...\n"
               "name              the keyword argument\n"
               "label, help       for a dialog; help is one line\n"
               "unit              'length' (the input's own units), 'ratio' or ''\n"
               "type              'bool', 'int', 'float', 'length' or 'enum'\n"
               "default           a bool, int, float, or for 'enum' a name\n"
               "minimum, maximum  of numbers; an infinite one is no limit\n"
               "items             of 'enum': a list of (name, label, help)")
          .c_str());
}

} // namespace vbm::python
