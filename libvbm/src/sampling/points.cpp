// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/points.h"

#include "core/error.h"
#include "core/progress.h"
#include "sampling/checks.h"
#include "sampling/merge.h"

#include <algorithm>

namespace vbm::impl {
namespace {

void check_labels(const double *normals, const vbm_build_options &options) {
  const auto refuse = [](const char *message) {
    throw Error(VBM_ERROR_ARGUMENT, message, "option", {}, 0);
  };
  if (options.labels == VBM_LABELS_VOXELS)
    refuse("option labels is VOXELS, which needs a volume, but the input is points");
  if (options.labels == VBM_LABELS_SCAN)
    refuse("option labels is SCAN, which needs scanner positions, but the input is bare points");
  if (options.labels == VBM_LABELS_NORMALS && normals == nullptr)
    refuse("option labels is NORMALS, but the points came without normals");
}

} // namespace

Samples sample_points(const double *points, size_t count, const double *normals,
                      const vbm_build_options &options, Progress &progress) {
  check_count(points, count, options);
  check_labels(normals, options);
  const bool drop = options.drop_invalid != 0;
  std::vector<uint8_t> keep, keep_normal;
  const std::size_t bad = check_finite(points, count, "vertex", "vertices", drop, keep, progress);
  std::size_t bad_normals = 0;
  if (normals)
    bad_normals = check_finite(normals, count, "normal", "normals", drop, keep_normal, progress);

  Samples samples;
  merge_points(points, count, keep, samples, progress);
  if (bad)
    samples.notes.push_back(counted(bad, "point is", "points are") + " not finite and left out");
  if (bad_normals)
    samples.notes.push_back(counted(bad_normals, "normal is", "normals are") +
                            " not finite and taken as unknown");

  samples.rule = VBM_LABELS_PROPAGATION;
  if (!normals || options.labels == VBM_LABELS_PROPAGATION) return samples;
  std::vector<Vec3> direction(count);
  for (size_t i = 0; i < count; ++i) // safe_unit takes what is not finite as unknown
    direction[i] = safe_unit({normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]});
  merge_normals(direction, samples);
  const bool any = std::any_of(samples.normal.begin(), samples.normal.end(),
                               [](const Vec3 &n) { return !(n == Vec3{}); });
  if (any || options.labels == VBM_LABELS_NORMALS) {
    samples.rule = VBM_LABELS_NORMALS;
  } else {
    samples.normal.clear();
    samples.notes.push_back("all normals are zero: labels come from propagation");
  }
  return samples;
}

} // namespace vbm::impl
