// SPDX-License-Identifier: GPL-3.0-or-later
// From a host's arrays of polygons to triangles over samples.
#pragma once

#include "core/samples.h"
#include "sampling/triangle_mesh.h"

namespace vbm::impl {

/// A mesh as the C interface gets it: face_sizes may be NULL (triangles).
struct FaceArrays {
  const double *vertices;
  std::size_t vertex_count;
  const uint32_t *face_sizes;
  const int32_t *corners;
  std::size_t corner_count, face_count;
};

/// Check everything about the arrays (counts, indices, finite coordinates) and throw Error; then
/// fill the samples with the vertices in use, merged by position, and return the faces as triangles
/// over them. Faces with fewer than three different corners are counted in samples.skipped_faces.
std::vector<Triangle> read_faces(const FaceArrays &faces, const vbm_build_options &options,
                                 Samples &samples, Progress &progress);

/// Leave out triangles that repeat another or cancel with one, and the samples only these use, with
/// a note.
void drop_double_faces(std::vector<Triangle> &triangles, Samples &samples);

} // namespace vbm::impl
