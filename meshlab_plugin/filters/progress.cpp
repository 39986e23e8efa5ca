// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.h"

#include <algorithm>

namespace vbm_filters {

void Progress::stage(vbm::Context &context, int from, int to) {
  if (!callback_) return;
  context.set_progress([this, from, to](double fraction, const char *stage) {
    const int percent = from + static_cast<int>((to - from) * std::clamp(fraction, 0.0, 1.0));
    if (percent <= last_) return false;
    last_ = percent;
    return !callback_(percent, stage); // the library's callback says true to cancel
  });
}

} // namespace vbm_filters
