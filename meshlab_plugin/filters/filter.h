// SPDX-License-Identifier: GPL-3.0-or-later
// The filters, for any host: their texts, their parameters, and how to run one.
#pragma once

#include "layer.h"
#include "params.h"
#include "progress.h"

#include <array>
#include <vector>

namespace vbm_filters {

struct Filter {
  const char *name;        // in menus and scripts: "Group: Action"
  const char *python_name; // in MeshLab's Python module
  const char *help;        // simple HTML
  bool adds_layer;         // adds a layer, or writes values to the layer it is applied to
  std::vector<Param> (*params)();
  Outcome (*run)(const Layer &layer, const Values &values, Progress &progress);
};

extern const Filter ball_model_filter, closed_surface_filter, thickness_filter;

// By the number that hosts know them by.
const std::array<const Filter *, 3> &filters();

// Checks the values, runs the filter and gives what the host is to write. Throws Failure, with the
// sentence for the user, for anything that went wrong, running out of memory and cancelling
// included.
Outcome run(const Filter &filter, const Layer &layer, const Values &values, Callback callback);

} // namespace vbm_filters
