// SPDX-License-Identifier: GPL-3.0-or-later
// Progress reports and cancelling: one object per call of the C interface.
#pragma once

#include <vbm/vbm.h>

#include <chrono>
#include <cstddef>

namespace vbm::impl {

/// Maps the stages of one call onto a fraction from 0 to 1 that never goes down, and throws
/// Error(VBM_ERROR_CANCELLED) when the caller's callback asks to stop.
class Progress {
public:
  Progress() = default;
  Progress(vbm_progress_fn callback, void *user, int threads = 0)
      : callback_(callback), user_(user), threads_(threads) {}

  /// How many threads the call may use, its own being one of them; 0 for as many as there are
  /// processors.
  int threads() const { return threads_; }

  /// Begin a stage that ends at `end` of the whole call. Always reports.
  void stage(const char *name, double end);

  /// Stages begun from here on are those of a call that fills this one up to `end`.
  void part(double end);

  /// Report that `done` of `total` of this stage is through. Cheap: looks at the clock once every
  /// few calls and calls back at most every 20 ms. Call it at least every few milliseconds of work.
  void tick(std::size_t done, std::size_t total) {
    if (callback_ && (++calls_ & 15) == 0) report(done, total);
  }
  /// The same, but looks at the clock every time: for loops whose single steps are long.
  void tick_slow(std::size_t done, std::size_t total) {
    if (callback_) report(done, total);
  }

  /// Report 1.
  void finish();

private:
  void report(std::size_t done, std::size_t total);
  void call(double fraction);

  vbm_progress_fn callback_ = nullptr;
  void *user_ = nullptr;
  int threads_ = 0;
  const char *name_ = "";
  double begin_ = 0, end_ = 0, last_ = 0;
  double part_begin_ = 0, part_end_ = 1;
  unsigned calls_ = 0;
  std::chrono::steady_clock::time_point last_time_{};
};

} // namespace vbm::impl
