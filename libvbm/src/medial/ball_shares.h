// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the union of the inner balls goes with each vertex and part of a medial axis, exactly
// (the measure of thesis 7.9, for 7.5.2).
#pragma once

#include "medial/axis_parts.h"

#include <memory>
#include <mutex>
#include <vector>

namespace vbm::impl {

/// Sums per part of what its vertices have; contact curves' go with none.
std::vector<double> sum_by_part(const AxisParts &parts, const std::vector<double> &per_vertex);

/// A result that is found when first asked for. Two threads that ask at once may both find it; they
/// get the same.
class Once {
public:
  template <class Find> const std::vector<double> &get(const Find &find) {
    if (const auto *there = read()) return *there;
    auto fresh = std::make_unique<const std::vector<double>>(find());
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!value_) value_ = std::move(fresh);
    return *value_;
  }

private:
  const std::vector<double> *read() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return value_.get();
  }
  std::mutex mutex_;
  std::unique_ptr<const std::vector<double>> value_;
};

/// Shares of the union's volume. A ball's volume is that of the union's part in its power cell.
class BallShares {
public:
  /// Per inner ball of the model.
  const std::vector<double> &per_ball(const Model &model, Progress &progress);
  /// Per vertex of the axis: of the balls drawn into it.
  const std::vector<double> &get(const Model &model, const AxisCells &cells, Progress &progress);

private:
  Once per_ball_, per_vertex_;
};

/// Per part.
class PartShares {
public:
  /// `per_vertex` returns what BallShares has.
  template <class PerVertex>
  const std::vector<double> &get(const AxisParts &parts, const PerVertex &per_vertex) {
    return once_.get([&] { return sum_by_part(parts, per_vertex()); });
  }

private:
  Once once_;
};

} // namespace vbm::impl
