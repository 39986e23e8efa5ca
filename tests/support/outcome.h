// SPDX-License-Identifier: GPL-3.0-or-later
// One input taken all the way: balls, interpolating surface, power crust, medial axis, pruning and
// the surface after it, and what is wrong with them.
#pragma once

#include "check_surface.h"
#include "shapes.h"

#include <vbm/vbm.h>

#include <functional>
#include <string>
#include <vector>

struct Outcome {
  vbm_status status = VBM_OK;
  std::string message, kind; // of a failed build
  std::vector<int64_t> bad;  // elements it named
  size_t bad_total = 0;
  vbm_model_report report{};
  std::string notes;
  Topology surface, crust;
  std::string bytes;    // all results, or the failure
  std::string problems; // "" if all is well
};

/// Builds with a context and options: a lambda round one of the vbm_build_ functions.
using Build =
    std::function<vbm_status(vbm_context *, const vbm_build_options *options, vbm_model **out)>;

/// Defaults, with the given balls and labels.
vbm_build_options make_options(vbm_balls balls = VBM_BALLS_POLAR,
                               vbm_labels labels = VBM_LABELS_AUTO);

Build points_of(const shapes::Shape &shape, bool normals = false);
Build mesh_of(const shapes::Shape &shape);

/// Round every call into the library that computes: to do it in another environment.
using Around = std::function<void(const std::function<void()> &)>;

/// Run it, checking the model (by brute force too, if small), all surfaces and axes.
Outcome run(const Build &build, const vbm_build_options &options = make_options(),
            const Around &around = {});
