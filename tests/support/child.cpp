// SPDX-License-Identifier: GPL-3.0-or-later
#include "child.h"

#include <csignal>
#include <cstdio>
#include <exception>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define VBM_TEST_ASAN
#endif
#if __has_feature(thread_sanitizer)
#define VBM_TEST_TSAN
#endif
#endif
#ifdef __SANITIZE_ADDRESS__
#define VBM_TEST_ASAN
#endif
#ifdef __SANITIZE_THREAD__
#define VBM_TEST_TSAN
#endif
#ifdef VBM_TEST_ASAN
#include <sanitizer/lsan_interface.h>
#endif

bool sanitized() {
#if defined(VBM_TEST_ASAN) || defined(VBM_TEST_TSAN)
  return true;
#else
  return false;
#endif
}

namespace {

/// A machine may be busy: wall-clock time is limited to this many times the processor time.
constexpr unsigned kPatience = 6;

[[noreturn]] void child(unsigned seconds, std::size_t megabytes,
                        const std::function<bool()> &body) {
  const rlimit time{seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &time);
  alarm(kPatience * seconds);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  if (!sanitized()) {
    const rlimit memory{megabytes << 20, megabytes << 20};
    setrlimit(RLIMIT_AS, &memory);
  }
  bool good = false;
  try {
    good = body();
  } catch (const std::exception &error) {
    std::printf("exception: %s\n", error.what());
  }
#ifdef VBM_TEST_ASAN
  if (__lsan_do_recoverable_leak_check()) good = false;
#endif
  std::fflush(nullptr);
  _exit(good ? 0 : 1);
}

} // namespace

std::string run_in_child(unsigned seconds, std::size_t megabytes,
                         const std::function<bool()> &body) {
  std::fflush(nullptr);
  const pid_t pid = fork();
  if (pid < 0) return "cannot start a child process";
  if (pid == 0) child(seconds, megabytes, body);
  int status = 0;
  while (waitpid(pid, &status, 0) < 0) {
  }
  if (WIFEXITED(status)) {
    if (WEXITSTATUS(status) == 0) return "";
    return "failed with exit status " + std::to_string(WEXITSTATUS(status));
  }
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU || signal == SIGALRM || signal == SIGKILL)
    return "out of its " + std::to_string(seconds) + " s";
  return "killed by signal " + std::to_string(signal);
}
