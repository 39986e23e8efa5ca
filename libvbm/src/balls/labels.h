// SPDX-License-Identifier: GPL-3.0-or-later
// Inside and outside (thesis 3.1.2).
#pragma once

#include "balls/merge.h"
#include "core/cells.h"
#include "core/progress.h"
#include "core/samples.h"

#include <cstdint>
#include <vector>

namespace vbm::impl {

struct Labels {
  std::vector<uint8_t> inside;   // per ball
  std::vector<float> confidence; // per ball, 0 to 1: how far its samples agree on the label
  bool turned = false;           // all normals point inward and were taken the other way round
};

/// Label every ball by the rule in samples.rule.
Labels label_balls(const Samples &samples, const Cells &cells, const BallSet &balls,
                   Progress &progress);

} // namespace vbm::impl
