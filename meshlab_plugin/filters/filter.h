// SPDX-License-Identifier: GPL-3.0-or-later
// The filters, for any host: their texts, their parameters, and how to run one.
#pragma once

#include "axis_store.h"
#include "layer.h"
#include "params.h"
#include "progress.h"

#include <vector>

namespace vbm_filters {

// What one run works on, and with.
struct Task {
  const Layer &layer;
  const Values &values;
  Progress &progress;
  AxisStore &axes; // those that earlier runs left in layers
};

// The submenus a filter stands in, and what it writes to the layer it is applied to: bits.
enum Menu { kRemeshing = 1, kPointSet = 2, kQuality = 4, kMeasure = 8, kSelection = 16 };
enum Writes { kNothing = 0, kVertexQuality = 1, kVertexRadius = 2, kVertexColor = 4 };

struct Filter {
  const char *name;        // in menus and scripts: "Group: Action"
  const char *python_name; // in MeshLab's Python module
  const char *help;        // simple HTML
  int menus;               // of Menu
  int writes;              // of Writes; kNothing if it adds layers only
  std::vector<Param> (*params)();
  Outcome (*run)(const Task &task);
};

// By the number that hosts know them by.
const std::vector<const Filter *> &filters();

// Checks the values, runs the filter and gives what the host is to write. Throws Failure, with the
// sentence for the user, for anything that went wrong, running out of memory and cancelling
// included.
Outcome run(const Filter &filter, const Layer &layer, const Values &values, AxisStore &axes,
            Callback callback);

extern const Filter ball_model_filter, closed_surface_filter, thickness_filter, medial_axis_filter,
    simplify_filter, remove_parts_filter, part_color_filter, ball_surface_filter, cluster_filter,
    ball_measures_filter, axis_of_balls_filter;

} // namespace vbm_filters
