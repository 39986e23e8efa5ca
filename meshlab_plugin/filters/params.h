// SPDX-License-Identifier: GPL-3.0-or-later
// A filter's parameters, from which every host generates its dialog. Those of the library come from
// its own table (vbm_param_describe), so that no host can drift from it.
#pragma once

#include <vbm/vbm.hpp>

#include <map>
#include <string>
#include <vector>

namespace vbm_filters {

enum class Kind { Bool, Int, Float, Length, Enum };

struct Param {
  std::string name; // the identifier used in scripts
  std::string label, help;
  Kind kind = Kind::Bool;
  double default_value = 0, minimum = 0, maximum = 0;
  std::vector<std::string> items; // Enum: one label for every value from 0
};

Param bool_param(std::string name, std::string label, std::string help, bool default_value);
Param enum_param(std::string name, std::string label, std::string help,
                 std::vector<std::string> items);

// The library's parameters of an operation ("build"), but for those named in `without`. Labels that
// only volumes and range scans can use are left out of their list.
std::vector<Param> library_params(const std::string &operation,
                                  const std::vector<std::string> &without = {});

// Values by parameter name. Reading one that is not there gives 0.
class Values {
public:
  void set(const std::string &name, double value) { values_[name] = value; }
  bool has(const std::string &name) const { return values_.count(name) != 0; }
  double get(const std::string &name) const;
  bool flag(const std::string &name) const { return get(name) != 0; }

private:
  std::map<std::string, double> values_;
};

// Hosts do not check what scripts give them: throws Failure for a value outside its parameter's
// range.
void check(const std::vector<Param> &params, const Values &values);

} // namespace vbm_filters
