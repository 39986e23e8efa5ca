// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/merge.h"

#include "core/grid.h"
#include "core/progress.h"
#include "sampling/checks.h"
#include "sampling/near_table.h"
#include "sampling/tolerances.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

Vec3 point_at(const double *points, std::size_t i) {
  return {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
}

Frame frame_of_kept(const double *points, std::size_t count, const std::vector<uint8_t> &keep,
                    std::size_t kept) {
  if (kept == count) return frame_of(points, count);
  std::vector<double> some;
  some.reserve(3 * kept);
  for (std::size_t i = 0; i < count; ++i)
    if (keep[i]) some.insert(some.end(), points + 3 * i, points + 3 * i + 3);
  return frame_of(some.data(), kept);
}

/// How many different coordinates doubles have across the longest side of the box, where they are
/// coarsest.
double steps_across(const Samples &samples) {
  double coarsest = 0, side = 0;
  for (int a = 0; a < 3; ++a) {
    double low = HUGE_VAL, high = -HUGE_VAL, magnitude = 0;
    for (const Vec3 &p : samples.position) {
      low = std::min(low, p[a]);
      high = std::max(high, p[a]);
    }
    magnitude = std::max(std::fabs(low + samples.frame.center[a]),
                         std::fabs(high + samples.frame.center[a]));
    coarsest = std::max(coarsest, std::nextafter(magnitude, HUGE_VAL) - magnitude);
    side = std::max(side, high - low);
  }
  return side > 0 ? side / coarsest : HUGE_VAL;
}

void note_precision(std::size_t alike, Samples &samples) {
  const double steps = samples.position.size() < 2 ? HUGE_VAL : steps_across(samples);
  if (steps < kFewSteps) {
    const std::string far = samples.merged
                                ? counted(samples.merged, "point", "points") +
                                      " became the same as another at this distance from the origin"
                                : std::string("the shape is far from the origin for its size");
    samples.notes.push_back(far + ": precision is lost, coordinates have only about " +
                            std::to_string(static_cast<long long>(steps)) +
                            " different values across the shape");
  } else if (alike) {
    samples.notes.push_back(counted(alike, "point", "points") +
                            " became the same as another nearer than 2e-11 of the whole's size");
  }
}

} // namespace

void merge_points(const double *points, std::size_t count, const std::vector<uint8_t> &keep,
                  Samples &samples, Progress &progress) {
  std::size_t kept = count;
  if (!keep.empty()) kept -= static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 0));
  samples.input_points = count;
  samples.dropped = count - kept;
  samples.frame = frame_of_kept(points, count, keep, kept);
  samples.position.reserve(kept);
  samples.input.reserve(kept);
  samples.input_position.reserve(kept);
  samples.input_sample.assign(count, -1);

  NearTable table(kept);
  std::size_t alike = 0; // different in the input
  for (std::size_t i = 0; i < count; ++i) {
    if ((i & 255) == 0) progress.tick(i, count);
    if (!keep.empty() && !keep[i]) continue;
    const Vec3 p = point_at(points, i), u = on_grid(samples.frame.to_unit(p), kSampleGrid);
    const int32_t s = table.find(samples.position, u);
    if (s < 0) {
      samples.input_sample[i] = static_cast<int32_t>(samples.position.size());
      samples.position.push_back(u);
      samples.input.push_back(static_cast<int32_t>(i));
      samples.input_position.push_back(p);
      table.add(samples.position);
    } else {
      samples.input_sample[i] = s;
      ++samples.merged;
      alike += !(samples.input_position[s] == p);
    }
  }
  note_precision(alike, samples);
}

Vec3 safe_unit(const Vec3 &a) {
  const double largest = std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
  if (!(largest > 0) || !std::isfinite(largest)) return {};
  int exponent;
  std::frexp(largest, &exponent);
  return unit({std::ldexp(a.x, -exponent), std::ldexp(a.y, -exponent), std::ldexp(a.z, -exponent)});
}

void merge_normals(const std::vector<Vec3> &direction, Samples &samples) {
  samples.normal.assign(samples.position.size(), Vec3{});
  for (std::size_t i = 0; i < direction.size(); ++i)
    if (samples.input_sample[i] >= 0)
      samples.normal[samples.input_sample[i]] += safe_unit(direction[i]);
  for (Vec3 &n : samples.normal) n = length(n) > kOppositeNormals ? unit(n) : Vec3{};
}

} // namespace vbm::impl
