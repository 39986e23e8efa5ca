// SPDX-License-Identifier: GPL-3.0-or-later
// What vbm_axis holds: an axis as far as it is pruned, its parts, and how it came to be.
#pragma once

#include "core/model.h"
#include "medial/axis_parts.h"
#include "medial/ball_shares.h"
#include "medial/remove_part.h"

#include <memory>
#include <string>

namespace vbm::impl {

class Progress;

struct Axis {
  std::shared_ptr<const Model> model;
  std::shared_ptr<const AxisCells> cells;
  AxisState state;
  std::vector<Removal> removed;            // parts, in the order they went
  std::shared_ptr<BallShares> ball_shares; // with all axes of these cells
  AxisParts parts;                         // of the state

  // What the views show: cells left, vertices renumbered, input units.
  std::vector<double> vertices, radii, nodes, triangle_points;
  std::vector<double> triangle_width, triangle_angle, curve_width, curve_angle;
  std::vector<int32_t> triangles, triangle_samples, triangle_part, curves, curve_part;
  std::vector<int32_t> contact_edges, contact_node;
  Incidence part_balls, part_nodes;
  std::vector<uint8_t> kept;
  std::vector<int32_t> stayed, stayed_lock; // parts below the threshold that are locked, and why
  std::shared_ptr<PartShares> part_ball_shares;
  std::string notes;
  vbm_axis_report report{};
};

Axis medial_axis(std::shared_ptr<const Model> model, const vbm_axis_options &options,
                 Progress &progress);

/// Thesis 7.5.2 and 7.5.3; several steps, one after another, are a scheme as in 7.7.
Axis prune_axis(const Axis &axis, const std::vector<vbm_prune_options> &steps, Progress &progress);

/// Throws Error(VBM_ERROR_INPUT) for a part that is not there or cannot go.
Axis remove_parts(const Axis &axis, const int32_t *parts, std::size_t count, Progress &progress);

/// The parts with these triangles. Throws Error(VBM_ERROR_INPUT) as remove_parts().
Axis remove_triangles(const Axis &axis, const int32_t *triangles, std::size_t count,
                      Progress &progress);

/// Per part its share of the exact volume of the union of the inner balls; found when first asked
/// for, and kept with the axis.
const std::vector<double> &part_ball_shares(const Axis &axis, Progress &progress);

} // namespace vbm::impl
