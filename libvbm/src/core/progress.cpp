// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/progress.h"

#include "core/error.h"

#include <algorithm>

namespace vbm::impl {

void Progress::stage(const char *name, double end) {
  name_ = name;
  begin_ = end_;
  end_ = std::clamp(part_begin_ + (part_end_ - part_begin_) * end, begin_, 1.0);
  if (callback_) call(begin_);
}

void Progress::part(double end) {
  part_begin_ = end_;
  part_end_ = std::max(end, end_);
}

void Progress::report(std::size_t done, std::size_t total) {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_time_ < std::chrono::milliseconds(20)) return;
  const double part = total ? std::min(1.0, double(done) / double(total)) : 1.0;
  call(begin_ + (end_ - begin_) * part);
}

void Progress::finish() {
  begin_ = end_ = 1;
  if (callback_) call(1);
}

void Progress::call(double fraction) {
  last_ = std::max(last_, fraction);
  const int stop = callback_(user_, last_, name_);
  last_time_ = std::chrono::steady_clock::now();
  if (stop) throw Error(VBM_ERROR_CANCELLED, std::string("cancelled while: ") + name_);
}

} // namespace vbm::impl
