// SPDX-License-Identifier: GPL-3.0-or-later
// From parameter values to the library's option structs.
#pragma once

#include "params.h"

#include <vbm/vbm.hpp>

#include <string>

namespace vbm_filters {

// Sets the field that has this name in the library's table; false if there is none.
bool set_option(vbm_build_options &options, const std::string &name, double value);
bool set_option(vbm_axis_options &options, const std::string &name, double value);
bool set_option(vbm_prune_options &options, const std::string &name, double value);
bool set_option(vbm_axis_surface_options &options, const std::string &name, double value);
bool set_option(vbm_ball_surface_options &options, const std::string &name, double value);
bool set_option(vbm_cluster_options &options, const std::string &name, double value);
bool set_option(vbm_simplify_options &options, const std::string &name, double value);

// Sets every field of the operation's options that has a value: one whose parameter a filter does
// not show keeps its default.
template <class Options>
void set_options(Options &options, const char *operation, const Values &values) {
  for (const Param &param : library_params(operation))
    if (values.has(param.name)) set_option(options, param.name, values.get(param.name));
}

} // namespace vbm_filters
