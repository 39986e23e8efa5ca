// SPDX-License-Identifier: GPL-3.0-or-later
// Ranjan's visibility information, as told in the thesis, 3.1.2: between the scanner and the point
// it saw there is nothing, so the direction to the scanner points out of the solid.
#include "sampling/range_scan.h"

#include "core/error.h"
#include "core/progress.h"
#include "sampling/checks.h"
#include "sampling/merge.h"

namespace vbm::impl {
namespace {

void check_labels(const vbm_build_options &options) {
  const auto refuse = [](const char *message) {
    throw Error(VBM_ERROR_ARGUMENT, message, "option", {}, 0);
  };
  if (options.labels == VBM_LABELS_VOXELS)
    refuse("option labels is VOXELS, which needs a volume, but the input is range scans");
  if (options.labels == VBM_LABELS_NORMALS)
    refuse("option labels is NORMALS, but range scans come without normals");
}

void check_scanners(std::size_t count, const double *scanners, std::size_t scanner_count,
                    const int32_t *scanner_of_point, Progress &progress) {
  if (scanner_count == 0 || !scanners)
    throw Error(VBM_ERROR_ARGUMENT, "range scans need at least one scanner position");
  if (!scanner_of_point && scanner_count != 1 && scanner_count != count)
    throw Error(
        VBM_ERROR_ARGUMENT,
        "scanner_of_point is NULL, so there must be 1 scanner or one a point, but there are " +
            std::to_string(scanner_count) + " for " + counted(count, "point", "points"));
  std::vector<uint8_t> unused;
  check_finite(scanners, scanner_count, "scanner", "scanners", false, unused, progress);
  if (!scanner_of_point) return;
  Offenders bad;
  for (std::size_t i = 0; i < count; ++i) {
    if ((i & 1023) == 0) progress.tick(0, 1);
    if (scanner_of_point[i] < 0 || static_cast<std::size_t>(scanner_of_point[i]) >= scanner_count)
      bad.add(i);
  }
  if (bad.total)
    throw_offenders(
        bad, "vertex", "vertices",
        "was seen by scanner " + std::to_string(scanner_of_point[bad.listed[0]]) + ", but there " +
            (scanner_count == 1 ? "is only 1 scanner"
                                : "are only " + std::to_string(scanner_count) + " scanners"));
}

/// From p to q; halved, so that it does not overflow.
Vec3 direction(const double *p, const double *q) {
  return safe_unit({q[0] / 2 - p[0] / 2, q[1] / 2 - p[1] / 2, q[2] / 2 - p[2] / 2});
}

} // namespace

Samples sample_range_scan(const double *points, std::size_t count, const double *scanners,
                          std::size_t scanner_count, const int32_t *scanner_of_point,
                          const vbm_build_options &options, Progress &progress) {
  check_count(points, count, options);
  check_labels(options);
  check_scanners(count, scanners, scanner_count, scanner_of_point, progress);
  std::vector<uint8_t> keep;
  const std::size_t bad =
      check_finite(points, count, "vertex", "vertices", options.drop_invalid != 0, keep, progress);
  Samples samples;
  merge_points(points, count, keep, samples, progress);
  if (bad)
    samples.notes.push_back(counted(bad, "point is", "points are") + " not finite and left out");
  samples.rule = VBM_LABELS_PROPAGATION;
  if (options.labels == VBM_LABELS_PROPAGATION) return samples;
  std::vector<Vec3> to_scanner(count);
  for (std::size_t i = 0; i < count; ++i) {
    if ((i & 1023) == 0) progress.tick(0, 1);
    const std::size_t s = scanner_of_point     ? static_cast<std::size_t>(scanner_of_point[i])
                          : scanner_count == 1 ? 0
                                               : i;
    if (keep.empty() || keep[i]) to_scanner[i] = direction(points + 3 * i, scanners + 3 * s);
  }
  merge_normals(to_scanner, samples);
  samples.rule = VBM_LABELS_SCAN;
  return samples;
}

} // namespace vbm::impl
