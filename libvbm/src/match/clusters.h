// SPDX-License-Identifier: GPL-3.0-or-later
// What vbm_clusters holds: clusters of balls, and what they stand for.
#pragma once

#include "core/model.h"

#include <string>
#include <vector>

namespace vbm::impl {

class Progress;

struct Clusters {
  std::vector<Ball> balls;     // given, scaled
  std::vector<Ball> enclosing; // scaled
  int exponent = 0;            // scaled = ldexp(given, -exponent): exact
  Incidence members;
  std::vector<int32_t> ball_cluster;

  // What the views show, in input units.
  std::vector<double> centers, radii, sphericity, gap;
  std::string notes;
  vbm_clusters_report report{};
};

/// Throws Error(VBM_ERROR_INPUT) for balls that are none.
Clusters cluster_balls(const double *centers, const double *radii, std::size_t count,
                       const vbm_cluster_options &options, Progress &progress);

vbm_cluster_error measure_clusters(const Clusters &clusters, std::size_t points,
                                   Progress &progress);

} // namespace vbm::impl
