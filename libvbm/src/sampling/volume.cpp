// SPDX-License-Identifier: GPL-3.0-or-later
// Ranjan's sampling of volumes, as told in the thesis, 3.1.2: a boundary point between every inside
// voxel and every outside one of its six neighbours, and for a ball the label of the voxel nearest
// its centre. Differs in that a ball that does not contain that voxel's centre gets no label from
// it.
#include "sampling/volume.h"

#include "core/error.h"
#include "core/grid.h"
#include "core/progress.h"
#include "sampling/checks.h"
#include "sampling/merge.h"
#include "sampling/tolerances.h"
#include "sampling/voxel_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vbm::impl {
namespace {

/// A volume in its own coordinates: the first voxel's centre is 0, lengths are the input's.
struct Grid {
  std::size_t n[3];
  Vec3 size, origin;

  Vec3 place(double i, double j, double k) const { return {i * size.x, j * size.y, k * size.z}; }
};

[[noreturn]] void refuse(std::string message) {
  throw Error(VBM_ERROR_ARGUMENT, std::move(message));
}

Grid check_grid(const void *values, std::size_t nx, std::size_t ny, std::size_t nz,
                const double *voxel_size, const double *origin, double level) {
  Grid grid{{nx, ny, nz}, {}, {}};
  if (!values || !voxel_size) refuse("the values or the voxel size of the volume are NULL");
  const char *const names[] = {"nx", "ny", "nz"};
  const std::size_t most = std::numeric_limits<std::ptrdiff_t>::max() / sizeof(double);
  std::size_t count = 1;
  for (int a = 0; a < 3; ++a) {
    if (grid.n[a] == 0) refuse(std::string("the volume has no voxels: ") + names[a] + " is 0");
    if (grid.n[a] > most / count) refuse("nx * ny * nz is more than memory has addresses");
    count *= grid.n[a];
    const double size = voxel_size[a], from = origin ? origin[a] : 0;
    if (!(size > 0) || !std::isfinite(size))
      refuse("voxel_size[" + std::to_string(a) + "] is " + short_number(size) +
             ", but must be positive and finite");
    if (!std::isfinite(from)) refuse("origin[" + std::to_string(a) + "] is not finite");
    grid.size[a] = size;
    grid.origin[a] = from;
    if (!std::isfinite(4 * size * static_cast<double>(grid.n[a])) ||
        !std::isfinite(from + 4 * size * static_cast<double>(grid.n[a])))
      refuse("the volume is larger than any double along axis " + std::to_string(a));
  }
  if (!std::isfinite(level)) refuse("the level is not finite");
  return grid;
}

void check_labels(const vbm_build_options &options) {
  if (options.labels == VBM_LABELS_SCAN)
    throw Error(VBM_ERROR_ARGUMENT,
                "option labels is SCAN, which needs scanner positions, but the input is a volume",
                "option", {}, 0);
}

template <class Value> class VolumeSampler {
public:
  VolumeSampler(const Value *values, const Grid &grid, double level, Progress &progress)
      : values_(values), grid_(grid), level_(level), progress_(progress),
        labels_(grid.n[0], grid.n[1], grid.n[2]) {}

  VoxelLabels run(const vbm_build_options &options, Samples &samples) {
    label(options.drop_invalid != 0, samples);
    std::size_t count = 0;
    const auto tick = [this](std::size_t done, std::size_t all) { progress_.tick(done, all); };
    labels_.for_each_crossing([&](std::size_t, std::size_t, std::size_t, int, int) { ++count; },
                              tick);
    check_sample_limit(static_cast<double>(count), options, " at this level");
    const bool with_normals = options.labels != VBM_LABELS_PROPAGATION;
    samples.position.reserve(count);
    if (with_normals) samples.normal.reserve(count);
    labels_.for_each_crossing([&](std::size_t i, std::size_t j, std::size_t k, int axis,
                                  int step) { sample(i, j, k, axis, step, with_normals, samples); },
                              tick);
    return std::move(labels_);
  }

private:
  double value(std::size_t i, std::size_t j, std::size_t k) const {
    return static_cast<double>(values_[(i * grid_.n[1] + j) * grid_.n[2] + k]);
  }

  void label(bool drop, Samples &samples) {
    Offenders bad;
    std::size_t at = 0, inside = 0;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (std::size_t i = 0; i < grid_.n[0]; ++i)
      for (std::size_t j = 0; j < grid_.n[1]; ++j) {
        for (std::size_t k = 0; k < grid_.n[2]; ++k, ++at) {
          if ((k & 4095) == 0) progress_.tick(0, 1);
          const double v = static_cast<double>(values_[at]);
          if (std::isnan(v)) {
            bad.add(at);
            continue;
          }
          low = std::min(low, v), high = std::max(high, v);
          if (v >= level_) labels_.set_inside(i, j, k), ++inside;
        }
      }
    samples.input_points = at;
    samples.dropped = bad.total;
    if (bad.total && !drop) throw_not_a_number(bad);
    if (bad.total)
      samples.notes.push_back(counted(bad.total, "voxel is", "voxels are") +
                              " not a number and taken as outside");
    if (inside != 0 && inside != at) return;
    const std::string range =
        low <= high ? " (values run from " + short_number(low) + " to " + short_number(high) + ")"
                    : "";
    throw Error(
        VBM_ERROR_NO_INTERIOR,
        (inside ? "every voxel is at or above the level " : "no voxel is at or above the level ") +
            short_number(level_) + range + (inside ? ", so nothing is outside" : ""));
  }

  [[noreturn]] void throw_not_a_number(const Offenders &bad) const {
    const std::size_t first = static_cast<std::size_t>(bad.listed[0]), k = first % grid_.n[2],
                      j = first / grid_.n[2] % grid_.n[1], i = first / grid_.n[2] / grid_.n[1];
    std::string message = "voxel (" + std::to_string(i) + ", " + std::to_string(j) + ", " +
                          std::to_string(k) + ") is not a number";
    if (bad.total > 1) message += " (" + std::to_string(bad.total) + " such voxels in all)";
    throw Error(VBM_ERROR_INPUT, std::move(message), "voxel", bad.listed, bad.total);
  }

  /// Between a voxel and its neighbour one step along the axis.
  void sample(std::size_t i, std::size_t j, std::size_t k, int axis, int step, bool with_normals,
              Samples &samples) const {
    std::size_t next[3] = {i, j, k};
    const bool border = step < 0 || next[axis] + 1 == grid_.n[axis];
    next[axis] += border ? 0 : 1;
    const double here = value(i, j, k), there = value(next[0], next[1], next[2]);
    double part = border ? 0.5 : (level_ - here) / (there - here);
    if (!std::isfinite(part)) part = 0.5; // infinite or missing values
    part = std::clamp(part, kVoxelMargin, 1 - kVoxelMargin);
    Vec3 at{double(i), double(j), double(k)};
    at[axis] += step * part;
    samples.position.push_back(grid_.place(at.x, at.y, at.z));
    if (!with_normals) return;
    Vec3 normal;
    const bool outward = here >= level_; // NaN is outside
    normal[axis] = outward ? step : -step;
    if (!border) {
      const Vec3 slope = -safe_unit(gradient(i, j, k) + gradient(next[0], next[1], next[2]));
      if (is_finite(slope) && dot(slope, normal) > 0) normal = slope;
    }
    samples.normal.push_back(normal);
  }

  /// By central differences, one-sided at the border.
  Vec3 gradient(std::size_t i, std::size_t j, std::size_t k) const {
    Vec3 g;
    const std::size_t at[3] = {i, j, k};
    for (int a = 0; a < 3; ++a) {
      std::size_t low[3] = {i, j, k}, high[3] = {i, j, k};
      low[a] -= at[a] > 0;
      high[a] += at[a] + 1 < grid_.n[a];
      if (low[a] == high[a]) continue;
      g[a] = (value(high[0], high[1], high[2]) - value(low[0], low[1], low[2])) /
             (static_cast<double>(high[a] - low[a]) * (grid_.size[a] / grid_.size.x));
    }
    return g;
  }

  const Value *values_;
  const Grid &grid_;
  double level_;
  Progress &progress_;
  VoxelLabels labels_;
};

VoxelLabels take_samples(const void *values, vbm_scalar type, const Grid &grid, double level,
                         const vbm_build_options &options, Samples &samples, Progress &progress) {
  const auto run = [&](auto *typed) {
    return VolumeSampler(typed, grid, level, progress).run(options, samples);
  };
  switch (type) {
  case VBM_SCALAR_UINT8:
    return run(static_cast<const uint8_t *>(values));
  case VBM_SCALAR_UINT16:
    return run(static_cast<const uint16_t *>(values));
  case VBM_SCALAR_INT16:
    return run(static_cast<const int16_t *>(values));
  case VBM_SCALAR_FLOAT:
    return run(static_cast<const float *>(values));
  case VBM_SCALAR_DOUBLE:
    return run(static_cast<const double *>(values));
  }
  refuse("the volume's element type " + std::to_string(static_cast<int>(type)) + " is unknown");
}

/// From grid coordinates to the unit frame and the input's. The frame is found without the origin,
/// so that a grid far from 0 keeps all its digits. Returns the grid coordinates of the frame's
/// middle.
Vec3 place_samples(const Grid &grid, Samples &samples) {
  const double *first = samples.position.empty() ? nullptr : &samples.position[0].x;
  const Frame local = frame_of(first, samples.position.size());
  samples.frame.exponent = local.exponent;
  const Frame scale{local.exponent, {}};
  samples.frame.center = local.center + scale.to_unit(grid.origin);
  samples.input_position.reserve(samples.position.size());
  for (Vec3 &p : samples.position) {
    samples.input_position.push_back(p + grid.origin);
    p = on_grid(local.to_unit(p), kSampleGrid);
  }
  samples.input.assign(samples.position.size(), -1);
  samples.input_sample.resize(samples.position.size());
  for (std::size_t s = 0; s < samples.input_sample.size(); ++s)
    samples.input_sample[s] = static_cast<int32_t>(s);
  samples.input_is_samples = true;
  return scale.to_input(local.center);
}

class VoxelTest final : public InsideTest {
public:
  VoxelTest(VoxelLabels labels, const Grid &grid, const Vec3 &middle, int exponent)
      : labels_(std::move(labels)), grid_(grid), middle_(middle), scale_{exponent, {}} {}

  Answer test(const Vec3 &center, double radius) const override {
    const Vec3 at = scale_.to_input(center) + middle_;
    const double i = std::round(at.x / grid_.size.x), j = std::round(at.y / grid_.size.y),
                 k = std::round(at.z / grid_.size.z);
    if (!(length(scale_.to_unit(at - grid_.place(i, j, k))) < radius)) // no squares of 1e200
      return Answer::unknown;
    return labels_.inside(i, j, k) ? Answer::inside : Answer::outside;
  }
  bool decides_every_ball() const override { return true; }

private:
  VoxelLabels labels_;
  Grid grid_;
  Vec3 middle_; // of the unit frame, in grid coordinates
  Frame scale_;
};

} // namespace

Samples sample_volume(const void *values, vbm_scalar type, std::size_t nx, std::size_t ny,
                      std::size_t nz, const double *voxel_size, const double *origin, double level,
                      const vbm_build_options &options, Progress &progress) {
  check_labels(options);
  const Grid grid = check_grid(values, nx, ny, nz, voxel_size, origin, level);
  Samples samples;
  VoxelLabels labels = take_samples(values, type, grid, level, options, samples, progress);
  const Vec3 middle = place_samples(grid, samples);
  samples.rule = options.labels == VBM_LABELS_AUTO ? VBM_LABELS_VOXELS
                                                   : static_cast<vbm_labels>(options.labels);
  if (samples.rule == VBM_LABELS_VOXELS)
    samples.inside =
        std::make_unique<VoxelTest>(std::move(labels), grid, middle, samples.frame.exponent);
  return samples;
}

} // namespace vbm::impl
