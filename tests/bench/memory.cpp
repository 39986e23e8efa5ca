// SPDX-License-Identifier: GPL-3.0-or-later
#include "memory.h"

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bench {

namespace {

double max_resident() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024e-6 * double(usage.ru_maxrss); // given in units of 1024 bytes
}

} // namespace

double peak_megabytes(const std::function<void()> &work) {
  malloc_trim(0); // memory freed but kept would be reused by the child, and not be counted
  int ends[2];
  if (pipe(ends) != 0) return -1;
  const pid_t child = fork();
  if (child == 0) {
    const double before = max_resident(); // a child's peak begins at what it shares with its parent
    double peak = -1;
    try {
      work();
      peak = max_resident() - before;
    } catch (...) {
    }
    const bool written = write(ends[1], &peak, sizeof peak) == sizeof peak;
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  double peak = -1;
  if (child < 0 || read(ends[0], &peak, sizeof peak) != sizeof peak) peak = -1;
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  return peak;
}

} // namespace bench
