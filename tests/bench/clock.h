// SPDX-License-Identifier: GPL-3.0-or-later
// What one run cost: processor time, which a busy machine hardly changes, and wall time.
#pragma once

#include <chrono>
#include <ctime>

namespace bench {

struct Seconds {
  double cpu = 0, wall = 0;
};

inline Seconds now() {
  timespec cpu;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
  const auto wall = std::chrono::steady_clock::now().time_since_epoch();
  return {double(cpu.tv_sec) + 1e-9 * double(cpu.tv_nsec),
          std::chrono::duration<double>(wall).count()};
}
inline Seconds operator-(const Seconds &a, const Seconds &b) {
  return {a.cpu - b.cpu, a.wall - b.wall};
}

} // namespace bench
