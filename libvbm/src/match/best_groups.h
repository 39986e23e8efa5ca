// SPDX-License-Identifier: GPL-3.0-or-later
// The best so many balls.
#pragma once

#include "match/grouping.h"

namespace vbm::impl {

/// At most `count` groups, the largest error (Allowance::slack, which is sought) as small as is found.
/// Fewer than `count` only where that many have no error, or lone balls are all that is left.
Grouping best_groups(const std::vector<Ball> &balls, std::size_t count, bool by_union,
                     Progress &progress);

} // namespace vbm::impl
