// SPDX-License-Identifier: GPL-3.0-or-later
// What vbm_medial_mesh holds, and its two makers.
#pragma once

#include "medial/axis.h"
#include "medial/ball_complex.h"

#include <vbm/vbm.h>

#include <string>
#include <vector>

namespace vbm::impl {

class Progress;
struct MeshErrors;

struct MedialMesh {
  // What the views show, in input units.
  std::vector<double> vertices, radii;
  std::vector<int32_t> triangles, edges;
  std::string notes;
  vbm_medial_mesh_report report{};
};

/// A mesh of a complex in the unit frame of a model, and its counts.
MedialMesh medial_mesh(const BallComplex &complex, const Model &model, const MeshErrors &errors);

/// Throws Error(VBM_ERROR_ARGUMENT) for a count that the topology does not allow.
MedialMesh simplify_axis(const Axis &axis, const vbm_simplify_options &options, Progress &progress);

MedialMesh curve_skeleton(const Axis &axis, const vbm_curve_skeleton_options &options,
                          Progress &progress);

} // namespace vbm::impl
