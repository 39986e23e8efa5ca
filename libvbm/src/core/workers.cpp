// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workers.h"

#include "core/progress.h"

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <sched.h>
#include <signal.h>

namespace vbm::impl {
namespace {

/// Signals are the host's: none is delivered to a thread that is started within this scope.
class NoSignals {
public:
  NoSignals() {
    sigset_t all;
    sigfillset(&all);
    // What a thread does to itself is the host's to see whichever thread it is.
    for (int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS, SIGABRT})
      sigdelset(&all, own);
    pthread_sigmask(SIG_SETMASK, &all, &saved_);
  }
  ~NoSignals() { pthread_sigmask(SIG_SETMASK, &saved_, nullptr); }
  NoSignals(const NoSignals &) = delete;
  NoSignals &operator=(const NoSignals &) = delete;

private:
  sigset_t saved_;
};

class Crew {
public:
  Crew(int parts, const std::function<void(int, Progress &)> &work) : work_(work), parts_(parts) {}

  void run(int threads, Progress &progress) {
    std::vector<std::thread> crew;
    crew.reserve(std::size_t(threads) - 1);
    at_work_ = threads - 1;
    try {
      const NoSignals none;
      while (int(crew.size()) + 1 < threads) crew.emplace_back([this] { help(); });
    } catch (...) { // there are no more to be had: the others do it all
      const std::lock_guard<std::mutex> lock(mutex_);
      at_work_ -= threads - 1 - int(crew.size());
    }
    take_parts(progress);
    try {
      wait(progress);
    } catch (...) {
      keep_first();
    }
    for (std::thread &t : crew) t.join();
    if (first_) std::rethrow_exception(first_);
  }

private:
  void take_parts(Progress &progress) {
    try {
      for (int part = next_++; part < parts_ && !stop_; part = next_++) work_(part, progress);
    } catch (...) {
      keep_first();
    }
  }

  void help() {
    std::fesetenv(FE_DFL_ENV); // as the calling thread's is (capi/guard.h)
    Progress quiet(
        [](void *stop, double, const char *) -> int {
          return *static_cast<const std::atomic<bool> *>(stop);
        },
        &stop_);
    take_parts(quiet);
    const std::lock_guard<std::mutex> lock(mutex_);
    --at_work_;
    ended_.notify_one();
  }

  void keep_first() {
    if (!stop_.exchange(true)) first_ = std::current_exception();
  }

  /// Until all others have ended, with a look at the caller's wish to cancel now and then.
  void wait(Progress &progress) {
    while (!have_ended())
      if (!stop_) progress.tick_slow(0, 1);
  }

  /// Waits a while for that.
  bool have_ended() {
    std::unique_lock<std::mutex> lock(mutex_);
    return ended_.wait_for(lock, std::chrono::milliseconds(20), [this] { return at_work_ == 0; });
  }

  const std::function<void(int, Progress &)> &work_;
  const int parts_;
  std::atomic<int> next_{0};
  std::atomic<bool> stop_{false};
  std::exception_ptr first_; // written by the one that set stop_, read when all have ended
  std::mutex mutex_;
  std::condition_variable ended_;
  int at_work_ = 0; // others
};

/// Those that this process may run on: the host may have been given some of the machine's only.
int processors() {
#ifdef __linux__
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0) return std::max(1, CPU_COUNT(&set));
#endif
  return std::max(1, int(std::thread::hardware_concurrency()));
}

} // namespace

void run_parts(int parts, Progress &progress, const std::function<void(int, Progress &)> &work) {
  int threads = progress.threads() > 0 ? std::min(parts, progress.threads()) : parts;
  if (threads > 1) threads = std::min(threads, processors());
  if (threads > 1) {
    Crew(parts, work).run(threads, progress);
    return;
  }
  for (int part = 0; part < parts; ++part) work(part, progress);
}

} // namespace vbm::impl
