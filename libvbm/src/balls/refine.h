// SPDX-License-Identifier: GPL-3.0-or-later
// More samples where the first ones let a ball swallow a piece of the mesh.
#pragma once

#include "balls/delaunay.h"
#include "balls/labels.h"
#include "balls/merge.h"
#include "core/progress.h"
#include "core/samples.h"

namespace vbm::impl {

/// Rounds of adding samples, and rounds without success, after which what is left is reported as
/// undersampled.
inline constexpr int kMaxRefineRounds = 12, kMaxStuckRounds = 3;

/// The tetrahedra, balls and labels of the samples so far.
struct Round {
  Cells cells;
  BallSet balls;
  Labels labels;
  std::vector<uint8_t> inside; // per cell, after repair
  uint64_t exact_centers = 0;
  std::size_t samples = 0; // how many there were
  std::size_t fresh = 0;   // samples from this number on were new in this round
  std::size_t faults = 0;  // see count_faults()
};

/// Faults that a wrong component or Euler characteristic counts for: it outweighs any split
/// vertices.
inline constexpr std::size_t kWrongTopology = 1000000;

/// How far the boundary between inside and outside is from the mesh's topology: samples that had to
/// be split; and where the mesh bounds a solid, samples not on the boundary and the differences in
/// components and Euler characteristic.
std::size_t count_faults(const Samples &samples, const Round &round, Progress &progress);

/// Add samples to `samples` and `delaunay`: in balls that touch a fresh sample and that the mesh
/// enters deeply, or enters so as to show their centre another side than their label says; where a
/// facet between inside and outside stands across the mesh; and round samples where the boundary is
/// not a disk. Returns whether any was added.
bool refine(Samples &samples, Delaunay &delaunay, const Round &round, uint64_t sample_limit,
            Progress &progress);

/// Take back the samples refine() added from number `count` on.
void remove_samples_from(Samples &samples, std::size_t count);

} // namespace vbm::impl
