// SPDX-License-Identifier: GPL-3.0-or-later
#include "medial/axis.h"

#include "core/error.h"
#include "core/progress.h"
#include "medial/axis_views.h"

#include <algorithm>
#include <string>

namespace vbm::impl {
namespace {

const char *reason(vbm_lock lock) {
  switch (lock) {
  case VBM_LOCK_INNER:
    return "it has no border: the parts around it must go first";
  case VBM_LOCK_TUNNEL:
    return "a tunnel of the shape would be lost";
  case VBM_LOCK_BRIDGE:
    return "the shape would fall apart";
  case VBM_LOCK_LAST:
    return "it is all that is left of a piece of the shape";
  case VBM_LOCK_NONE:
    break;
  }
  return "";
}

double significance(const vbm_part &part, int32_t measure, double diagonal) {
  switch (measure) {
  case VBM_MEASURE_VOLUME:
    return part.volume;
  case VBM_MEASURE_WIDTH:
    return diagonal > 0 ? part.width / diagonal : 0;
  case VBM_MEASURE_ANGLE:
    return part.angle;
  default:
    return double(part.triangles);
  }
}

/// An axis with the same cells left.
Axis again(const Axis &axis) {
  Axis out;
  out.model = axis.model;
  out.cells = axis.cells;
  out.state = axis.state;
  out.removed = axis.removed;
  return out;
}

void find_locks(Axis &axis, Progress &progress) {
  Remover remover(*axis.cells, axis.parts, axis.state);
  for (std::size_t p = 0; p < axis.parts.list.size(); ++p) {
    progress.tick_slow(p, axis.parts.list.size());
    axis.parts.list[p].lock = remover.test(int32_t(p));
  }
}

void finish(Axis &axis, Progress &progress) {
  progress.stage("parts", 0.97);
  axis.parts = find_axis_parts(*axis.cells, axis.state, progress);
  find_locks(axis, progress);
  progress.stage("topology graph", 1);
  fill_views(axis, progress);
}

} // namespace

Axis medial_axis(std::shared_ptr<const Model> model, const vbm_axis_options &options,
                 Progress &progress) {
  Axis axis;
  axis.model = std::move(model);
  AxisOptions what;
  what.angle = options.angle;
  what.ratio = options.ratio;
  progress.stage("Voronoi diagram inside", 0.4);
  const DualComplex complex = dual_complex(*axis.model, progress);
  progress.stage("collapsing", 0.75);
  const Collapsed left = collapse(complex, *axis.model, what, progress);
  progress.stage("medial axis", 0.9);
  axis.cells = std::make_shared<const AxisCells>(axis_cells(complex, left, *axis.model, progress));
  axis.state = whole_axis(*axis.cells);
  finish(axis, progress);
  return axis;
}

Axis prune_axis(const Axis &from, const vbm_prune_options &options, Progress &progress) {
  Axis axis = again(from);
  const double diagonal = axis.model->report.diagonal;
  uint64_t kept[5] = {};
  for (int32_t i = 0; i < options.iterations; ++i) {
    progress.stage("pruning", 0.9 * (i + 1) / options.iterations);
    const AxisParts parts = find_axis_parts(*axis.cells, axis.state, progress);
    std::vector<std::pair<double, int32_t>> order;
    for (std::size_t p = 0; p < parts.list.size(); ++p) {
      const double value = significance(parts.list[p], options.measure, diagonal);
      if (parts.list[p].level == 1 && value <= options.threshold)
        order.push_back({value, int32_t(p)});
    }
    std::sort(order.begin(), order.end());
    Remover remover(*axis.cells, parts, axis.state);
    bool any = false;
    std::fill(std::begin(kept), std::end(kept), 0);
    for (const auto &[value, p] : order) {
      progress.tick_slow(0, 1);
      Removal removal;
      const vbm_lock lock = remover.remove(p, removal);
      ++kept[lock];
      if (lock != VBM_LOCK_NONE) continue;
      any = true;
      axis.removed.push_back(std::move(removal));
    }
    if (!any) break;
  }
  for (int lock = VBM_LOCK_INNER; lock <= VBM_LOCK_LAST; ++lock)
    if (kept[lock])
      axis.notes += std::to_string(kept[lock]) +
                    (kept[lock] == 1 ? " part below the threshold stays: "
                                     : " parts below the threshold stay: ") +
                    reason(vbm_lock(lock)) + "\n";
  finish(axis, progress);
  return axis;
}

Axis remove_parts(const Axis &from, const int32_t *parts, std::size_t count, Progress &progress) {
  Axis axis = again(from);
  progress.stage("removing parts", 0.9);
  Remover remover(*axis.cells, from.parts, axis.state);
  std::vector<uint8_t> done(from.parts.list.size(), 0);
  for (std::size_t i = 0; i < count; ++i) {
    progress.tick_slow(i, count);
    const int32_t p = parts[i];
    if (p < 0 || std::size_t(p) >= from.parts.list.size())
      throw Error(VBM_ERROR_INPUT,
                  "there is no part " + std::to_string(p) + ": the axis has " +
                      std::to_string(from.parts.list.size()),
                  "part", {p}, 1);
    if (done[p]) continue;
    done[p] = 1;
    Removal removal;
    const vbm_lock lock = remover.remove(p, removal);
    if (lock != VBM_LOCK_NONE)
      throw Error(VBM_ERROR_INPUT, "part " + std::to_string(p) + " cannot go: " + reason(lock),
                  "part", {p}, 1);
    axis.removed.push_back(std::move(removal));
  }
  finish(axis, progress);
  return axis;
}

} // namespace vbm::impl
