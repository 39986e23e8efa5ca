// SPDX-License-Identifier: GPL-3.0-or-later
#include "medial/axis.h"

#include "core/error.h"
#include "core/progress.h"
#include "medial/axis_views.h"
#include "medial/lock_text.h"
#include "medial/locks.h"
#include "medial/power_shape_axis.h"

#include <algorithm>
#include <string>

namespace vbm::impl {
namespace {

/// Per part its significance. Ball shares are per vertex, and only there if they are the measure.
std::vector<double> significance(const Axis &axis, int32_t measure,
                                 const std::vector<double> *ball_shares) {
  const std::vector<vbm_part> &list = axis.parts.list;
  if (measure == VBM_MEASURE_BALLS) return sum_by_part(axis.parts, *ball_shares);
  const double diagonal = axis.model->report.diagonal;
  std::vector<double> out(list.size());
  for (std::size_t p = 0; p < list.size(); ++p) switch (measure) {
    case VBM_MEASURE_VOLUME:
      out[p] = list[p].volume;
      break;
    case VBM_MEASURE_WIDTH:
      out[p] = diagonal > 0 ? list[p].width / diagonal : 0;
      break;
    case VBM_MEASURE_ANGLE:
      out[p] = list[p].angle;
      break;
    default:
      out[p] = double(list[p].triangles + list[p].curve_edges); // one of them is 0
    }
  return out;
}

/// Twigs that are not more significant than the threshold go; no cell of the axis goes with them,
/// so that its topology cannot change.
void prune_twigs(Axis &axis, const vbm_prune_options &options, Progress &progress) {
  if (!(options.threshold > 0)) return;
  const std::vector<Twig> &twigs = axis.cells->twigs;
  const double diagonal = axis.model->report.diagonal;
  std::vector<double> ball_share;
  if (options.measure == VBM_MEASURE_BALLS)
    ball_share = sum_over_twigs(twigs, axis.ball_shares->per_ball(*axis.model, progress));
  const auto significance = [&](std::size_t b) {
    switch (options.measure) {
    case VBM_MEASURE_VOLUME:
      return twigs[b].volume;
    case VBM_MEASURE_WIDTH:
      return diagonal > 0 ? double(twigs[b].width) * axis.cells->unit / diagonal : 0;
    case VBM_MEASURE_ANGLE:
      return double(twigs[b].angle);
    case VBM_MEASURE_BALLS:
      return ball_share[b];
    default:
      return double(twigs[b].cells);
    }
  };
  // Twigs are bumps and corners, unless the sampling is too thin: then they are pieces of walls.
  const bool walls = axis.cells->thin.counts();
  for (std::size_t b = 0; b < twigs.size(); ++b)
    if (twigs[b].cells > 0 && !(walls && twigs[b].thin) && significance(b) <= options.threshold)
      axis.state.twig[b] = 0;
}

/// An axis with the same cells left, and the same parts.
Axis again(const Axis &axis) {
  Axis out;
  out.model = axis.model;
  out.cells = axis.cells;
  out.state = axis.state;
  out.removed = axis.removed;
  out.ball_shares = axis.ball_shares;
  out.parts = axis.parts;
  return out;
}

/// Everything that follows from the state and its parts.
void finish(Axis &axis, Progress &progress) {
  progress.stage("topology graph", 1);
  const TopologyGraph graph = topology_graph(*axis.cells, axis.parts);
  const std::size_t pieces = find_locks(graph, axis.parts);
  fill_views(axis, graph, pieces, progress);
  axis.part_ball_shares = std::make_shared<PartShares>();
  axis.notes += thin_text(axis.cells->thin);
}

/// Numbers of the parts with a significance up to the threshold, least significant first; none for
/// 0, though parts without a vertex of their own have no volume.
std::vector<int32_t> up_to(const std::vector<double> &value, double threshold) {
  std::vector<int32_t> order;
  if (!(threshold > 0)) return order;
  for (std::size_t p = 0; p < value.size(); ++p)
    if (value[p] <= threshold) order.push_back(int32_t(p));
  std::sort(order.begin(), order.end(), [&](int32_t a, int32_t b) {
    return value[a] != value[b] ? value[a] < value[b] : a < b;
  });
  return order;
}

/// One step: its measure's least significant parts go, and are found anew, so many times.
void prune_parts(Axis &axis, const vbm_prune_options &step, const std::vector<double> *ball_shares,
                 double begin, double end, Progress &progress) {
  for (int32_t i = 0; i < step.iterations; ++i) {
    progress.stage("pruning", begin + (end - begin) * (i + 1) / step.iterations);
    const std::vector<double> value = significance(axis, step.measure, ball_shares);
    Remover remover(*axis.cells, axis.parts, axis.state);
    const std::size_t before = axis.removed.size();
    for (int32_t p : up_to(value, step.threshold)) {
      progress.tick_slow(0, 1);
      if (axis.parts.list[p].level != 1) continue;
      Removal removal;
      if (remover.remove(p, removal)) axis.removed.push_back(std::move(removal));
    }
    if (axis.removed.size() == before) break;
    axis.parts = find_axis_parts(*axis.cells, axis.state, progress);
  }
}

/// Parts that are left at the end and that a step would have taken, each with the first such step.
void list_stayed(Axis &axis, const std::vector<vbm_prune_options> &steps,
                 const std::vector<double> *ball_shares) {
  std::vector<uint8_t> listed(axis.parts.list.size(), 0);
  for (const vbm_prune_options &step : steps)
    for (int32_t p : up_to(significance(axis, step.measure, ball_shares), step.threshold)) {
      const vbm_part &part = axis.parts.list[p];
      if (part.level != 1 || part.lock == VBM_LOCK_NONE || listed[p]) continue;
      listed[p] = 1;
      axis.stayed.push_back(p);
      axis.stayed_lock.push_back(part.lock);
    }
  axis.notes += stayed_text(axis.stayed, axis.stayed_lock);
}

AxisCells voronoi_axis(const Model &model, const AxisOptions &options, Progress &progress) {
  progress.stage("Voronoi diagram inside", 0.4);
  const DualComplex complex = dual_complex(model, progress);
  progress.stage("collapsing", 0.75);
  const Collapsed left = collapse(complex, model, options, progress);
  progress.stage("medial axis", 0.9);
  return axis_cells(complex, left, model, progress);
}

} // namespace

Axis medial_axis(std::shared_ptr<const Model> model, const vbm_axis_options &options,
                 Progress &progress) {
  Axis axis;
  axis.model = std::move(model);
  AxisOptions what;
  what.angle = options.angle;
  what.ratio = options.ratio;
  axis.cells = std::make_shared<const AxisCells>(
      options.method == VBM_AXIS_POWER_SHAPE
          ? power_shape_axis(*axis.model, what, axis.notes, progress)
          : voronoi_axis(*axis.model, what, progress));
  axis.state = whole_axis(*axis.cells);
  axis.ball_shares = std::make_shared<BallShares>();
  progress.stage("parts", 0.97);
  axis.parts = find_axis_parts(*axis.cells, axis.state, progress);
  finish(axis, progress);
  return axis;
}

Axis prune_axis(const Axis &from, const std::vector<vbm_prune_options> &steps, Progress &progress) {
  Axis axis = again(from);
  const std::vector<double> *shares = nullptr;
  if (std::any_of(steps.begin(), steps.end(),
                  [](const auto &step) { return step.measure == VBM_MEASURE_BALLS; })) {
    progress.stage("volume of the balls", 0.5);
    shares = &axis.ball_shares->get(*axis.model, *axis.cells, progress);
  }
  for (std::size_t s = 0; s < steps.size(); ++s) {
    const auto at = [&](std::size_t done) {
      return 0.5 + 0.4 * double(done) / double(steps.size());
    };
    prune_twigs(axis, steps[s], progress);
    prune_parts(axis, steps[s], shares, at(s), at(s + 1), progress);
  }
  finish(axis, progress);
  list_stayed(axis, steps, shares);
  return axis;
}

Axis remove_parts(const Axis &from, const int32_t *parts, std::size_t count, Progress &progress) {
  const std::size_t there = from.parts.list.size();
  std::vector<int32_t> left; // those to remove, each once, the outer ones first
  std::vector<uint8_t> named(there, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const int32_t p = parts[i];
    if (p < 0 || std::size_t(p) >= there)
      throw Error(VBM_ERROR_INPUT,
                  "there is no part " + std::to_string(p) + ": the axis has " +
                      std::to_string(there),
                  "part", {p}, 1);
    if (!named[p]) left.push_back(p);
    named[p] = 1;
  }
  const auto depth = [&](int32_t p) { return uint32_t(from.parts.list[p].level) - 1; }; // 0 last
  std::stable_sort(left.begin(), left.end(),
                   [&](int32_t a, int32_t b) { return depth(a) < depth(b); });

  Axis axis = again(from);
  progress.stage("removing parts", 0.9);
  Remover remover(*axis.cells, from.parts, axis.state);
  std::size_t before = left.size() + 1;
  while (left.size() < before) { // what holds one part may be another of them
    before = left.size();
    const auto stays = [&](int32_t p) {
      progress.tick_slow(count - left.size(), count);
      Removal removal;
      if (!remover.remove(p, removal)) return true;
      axis.removed.push_back(std::move(removal));
      return false;
    };
    std::vector<int32_t> next;
    std::copy_if(left.begin(), left.end(), std::back_inserter(next), stays);
    left.swap(next);
  }
  if (!left.empty()) {
    const int32_t p = left[0];
    const auto lock = vbm_lock(from.parts.list[p].lock);
    throw Error(VBM_ERROR_INPUT,
                "part " + std::to_string(p) + " cannot go: " +
                    (lock ? lock_text(lock) : "the other parts named hold the shape's topology"),
                "part", {left.begin(), left.end()}, left.size());
  }
  axis.parts = find_axis_parts(*axis.cells, axis.state, progress);
  finish(axis, progress);
  return axis;
}

Axis remove_triangles(const Axis &from, const int32_t *triangles, std::size_t count,
                      Progress &progress) {
  std::vector<int32_t> parts(count);
  for (std::size_t i = 0; i < count; ++i) {
    const int32_t t = triangles[i];
    if (t < 0 || std::size_t(t) >= from.triangle_part.size())
      throw Error(VBM_ERROR_INPUT,
                  "there is no triangle " + std::to_string(t) + ": the axis has " +
                      std::to_string(from.triangle_part.size()),
                  "triangle", {t}, 1);
    parts[i] = from.triangle_part[t];
  }
  return remove_parts(from, parts.data(), count, progress);
}

const std::vector<double> &part_ball_shares(const Axis &axis, Progress &progress) {
  progress.stage("volume of the balls", 1);
  return axis.part_ball_shares->get(axis.parts, [&]() -> const std::vector<double> & {
    return axis.ball_shares->get(*axis.model, *axis.cells, progress);
  });
}

} // namespace vbm::impl
