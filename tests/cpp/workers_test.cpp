// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a call on several threads, and the blocks of large lists, behind the C interface: what
// happens where something fails cannot be brought about through it.
#include "core/error.h"
#include "core/large_list.h"
#include "core/progress.h"
#include "core/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <thread>

namespace vbm::impl {
namespace {

/// Works until it is told to end, and fails if it never is.
void work_on(Progress &progress) {
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < std::chrono::seconds(20)) {
    progress.tick_slow(0, 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ADD_FAILURE() << "nobody told it to end";
}

int never(void *, double, const char *) { return 0; }

TEST(RunParts, EachOnce) {
  Progress progress;
  std::atomic<int> times[50] = {};
  run_parts(50, progress, [&](int part, Progress &) { ++times[part]; });
  for (const std::atomic<int> &t : times) EXPECT_EQ(t, 1);
}

TEST(RunParts, WhatIsThrownComesOut) {
  for (int bad : {0, 1, 7}) {
    Progress progress(never, nullptr);
    std::atomic<int> begun{0};
    EXPECT_THROW(run_parts(8, progress,
                           [&](int part, Progress &own) {
                             ++begun;
                             if (part == bad) throw std::bad_alloc();
                             if (part > bad) work_on(own); // which is to be ended
                           }),
                 std::bad_alloc);
    EXPECT_LE(begun, 8);
  }
}

TEST(RunParts, CancelledWhileOthersWork) {
  // The caller's part has ended: it is asked while it waits, and only it.
  struct Caller {
    std::thread::id id = std::this_thread::get_id();
    int asked = 0;
    static int ask(void *user, double, const char *) {
      Caller &self = *static_cast<Caller *>(user);
      EXPECT_EQ(std::this_thread::get_id(), self.id);
      return ++self.asked > 2;
    }
  } caller;
  Progress progress(&Caller::ask, &caller);
  std::atomic<bool> begun{false};
  EXPECT_THROW(run_parts(2, progress,
                         [&](int part, Progress &own) {
                           if (part == 1) {
                             begun = true;
                             work_on(own);
                           }
                           // Another is to have that part, if there is one: it may start late.
                           for (int i = 0; i < 1000 && !begun; ++i)
                             std::this_thread::sleep_for(std::chrono::milliseconds(1));
                         }),
               Error);
  EXPECT_GT(caller.asked, 2);
}

TEST(RunParts, OneThreadIfThatIsAsked) {
  Progress progress(nullptr, nullptr, 1);
  const std::thread::id caller = std::this_thread::get_id();
  int next = 0;
  run_parts(5, progress, [&](int part, Progress &) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_EQ(part, next++);
  });
  EXPECT_EQ(next, 5);
}

TEST(LargeLists, HoldWhatIsPutIn) {
  for (int round = 0; round < 3; ++round) {
    LargeList<int32_t> list;
    for (int32_t i = 0; i < 3000000; ++i) list.push_back(i);
    const LargeList<int32_t> copy(list);
    list.clear();
    list.shrink_to_fit();
    for (int32_t i = 0; i < 3000000; ++i) ASSERT_EQ(copy[std::size_t(i)], i);
  }
}

TEST(LargeLists, AreAligned) {
  struct alignas(32) Wide {
    double v[4];
  };
  for (std::size_t count : {1, 100, 5000, 100000}) {
    const LargeList<Wide> list(count);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(list.data()) % 32, 0u) << count;
  }
}

TEST(LargeLists, AreAllNoughtThoughTheirBlocksWereUsed) {
  { const LargeList<int32_t> used(300000, -1); }
  const LargeList<int32_t> fresh(300000);
  for (int32_t v : fresh) ASSERT_EQ(v, 0);
}

TEST(LargeLists, SayWhenThereIsNoMemory) {
  if (kLargeBytes > (std::size_t(1) << 30)) GTEST_SKIP() << "a sanitizer has the memory";
  LargeList<double> list;
  EXPECT_THROW(list.reserve(std::size_t(1) << 57), std::bad_alloc);
  EXPECT_THROW(take_block(~std::size_t(0)), std::bad_alloc);
  list.assign(100000, 1.0); // and go on
  EXPECT_EQ(list.back(), 1.0);
}

TEST(LargeLists, OfSeveralThreads) {
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([t] {
      for (int i = 0; i < 300; ++i) {
        const LargeList<int32_t> list(std::size_t(40000 + 1000 * (i % 50)), t);
        EXPECT_EQ(list.front() + list.back(), 2 * t);
      }
    });
  for (std::thread &t : threads) t.join();
}

} // namespace
} // namespace vbm::impl
