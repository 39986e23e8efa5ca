// SPDX-License-Identifier: GPL-3.0-or-later
// Singular points at one place made one, the surface unchanged.
#pragma once

#include "ball_surface/boundary_map.h"
#include "ball_surface/merged_points.h"
#include "core/model.h"

#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// The samples that balls touch, where they are known.
struct TouchedSamples {
  const Incidence *lists = nullptr;           // of the model's balls, ascending
  const std::vector<int32_t> *ball = nullptr; // the model's number of each ball
  const std::vector<Vec3> *position = nullptr;

  /// The first of three balls' common samples on a side of their centres' plane, -1 if there is
  /// none.
  int32_t common(const DualShape &shape, int32_t code) const;
  /// That of each of a map's points.
  std::vector<int32_t> of(const BoundaryMap &map, const DualShape &shape, Progress &progress) const;
};

/// Radians: an arc with little between its ends that is longer may go all the way round.
inline constexpr double kRound = 2;
/// Times what is narrow: how far from its place any point may come to be that several moves took
/// along.
inline constexpr double kDrift = 2;

struct ContractedArcs {
  std::vector<uint8_t> contracted; // by span
  std::size_t merged = 0;          // singular points that went as they were the same as others
};

/// Contracts arcs of no length, and those that are no longer than `reach` of their balls, unless
/// that is empty: a ball's 0 keeps its points where they are. No arc is contracted whose ends are
/// one already, so that no loop of them ever is.
ContractedArcs contract_arcs(const BoundaryMap &map, const DualShape &shape,
                             const std::vector<double> &reach, MergedPoints &points,
                             Progress &progress);

} // namespace vbm::impl
