// SPDX-License-Identifier: GPL-3.0-or-later
// A filter's progress: several calls into the library, one percentage that never goes down.
#pragma once

#include <vbm/vbm.hpp>

#include <functional>

namespace vbm_filters {

// Called with 0 to 100 and what is being done, once for every new percentage, on the calling
// thread. Return false to cancel.
using Callback = std::function<bool(int percent, const char *stage)>;

class Progress {
public:
  explicit Progress(Callback callback) : callback_(std::move(callback)) {}

  // The calls made with this context from now on are the part of the work from `from` to `to`
  // percent.
  void stage(vbm::Context &context, int from, int to);

private:
  Callback callback_;
  int last_ = -1;
};

} // namespace vbm_filters
