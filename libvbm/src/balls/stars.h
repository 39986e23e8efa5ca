// SPDX-License-Identifier: GPL-3.0-or-later
// The tetrahedra round a sample, and whether the boundary between inside and outside is a disk
// there.
#pragma once

#include "core/cells.h"
#include "core/progress.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace vbm::impl {

/// How the boundary passes a sample: not at all, as a disk, or in several sheets that touch there.
enum class Sheets : uint8_t { none, disk, several };

/// For every sample. `inside` is per cell.
std::vector<Sheets> find_sheets(const Cells &cells, const std::vector<uint8_t> &inside,
                                Progress &progress);

/// The cells that have one sample as a vertex.
class Star {
public:
  explicit Star(const Cells &cells);

  void go_to(int32_t sample);
  const std::vector<int32_t> &cells() const { return star_; }

  /// Groups of equal label round the sample beyond one inside and one outside, where cells hang
  /// together across the facets they share at it; 0 too where all labels are the same.
  int surplus(const std::vector<uint8_t> &inside);

private:
  const Cells &cells_;
  std::vector<int32_t> any_cell_; // per sample
  std::vector<int32_t> star_;
  std::vector<int32_t> local_;                        // per cell of star_ its place there
  std::vector<std::pair<int32_t, int32_t>> touching_; // places of cells that share a facet
  std::vector<int32_t> parent_;
};

} // namespace vbm::impl
