// SPDX-License-Identifier: GPL-3.0-or-later
#include "params.h"

#include "layer.h"
#include "text.h"

#include <algorithm>
#include <cmath>

namespace vbm_filters {

Param bool_param(std::string name, std::string label, std::string help, bool default_value) {
  Param param;
  param.name = std::move(name);
  param.label = std::move(label);
  param.help = std::move(help);
  param.kind = Kind::Bool;
  param.default_value = default_value ? 1 : 0;
  param.maximum = 1;
  return param;
}

Param enum_param(std::string name, std::string label, std::string help,
                 std::vector<std::string> items) {
  Param param;
  param.name = std::move(name);
  param.label = std::move(label);
  param.help = std::move(help);
  param.kind = Kind::Enum;
  param.maximum = static_cast<double>(items.size()) - 1;
  param.items = std::move(items);
  return param;
}

namespace {

Param from_library(const vbm_param &given) {
  Param param;
  param.name = given.name;
  param.label = given.label;
  param.help = given.help;
  param.default_value = given.default_value;
  param.minimum = given.minimum;
  param.maximum = given.maximum;
  switch (given.type) {
  case VBM_PARAM_BOOL:
    param.kind = Kind::Bool;
    break;
  case VBM_PARAM_INT:
    param.kind = Kind::Int;
    break;
  case VBM_PARAM_LENGTH:
    param.kind = Kind::Length;
    break;
  case VBM_PARAM_ENUM:
    param.kind = Kind::Enum;
    break;
  default:
    param.kind = Kind::Float;
    break;
  }
  for (int i = 0; i < given.enum_count; ++i) {
    const std::string id = given.enum_names[i];
    if (param.name == "labels" && (id == "voxels" || id == "scan")) break; // the last ones
    param.items.emplace_back(given.enum_labels[i]);
  }
  if (param.kind == Kind::Enum) {
    param.minimum = 0;
    param.maximum = static_cast<double>(param.items.size()) - 1;
  }
  return param;
}

} // namespace

std::vector<Param> library_params(const std::string &operation,
                                  const std::vector<std::string> &without) {
  std::vector<Param> params;
  for (const vbm_param &given : vbm::parameters()) {
    if (operation != given.operation) continue;
    if (std::find(without.begin(), without.end(), given.name) != without.end()) continue;
    params.push_back(from_library(given));
  }
  return params;
}

double Values::get(const std::string &name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? 0 : found->second;
}

void check(const std::vector<Param> &params, const Values &values) {
  for (const Param &param : params) {
    double value = values.get(param.name);
    // A negative length stands for a choice, not for a length: how negative does not matter.
    if (param.kind == Kind::Length && param.minimum < 0 && value < 0) value = param.minimum;
    const bool whole = param.kind != Kind::Float && param.kind != Kind::Length;
    if (value >= param.minimum && value <= param.maximum && (!whole || value == std::floor(value)))
      continue;
    throw Failure("The parameter " + param.name + " is " + number(value) + ", but must be " +
                  (whole ? "a whole number " : "") + "from " + number(param.minimum) + " to " +
                  number(param.maximum) + ".");
  }
}

} // namespace vbm_filters
