// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that runs out on demand. Either failing_new.cpp is linked, which replaces operator new, or
// failing_malloc.cpp, which replaces the C library's malloc: operator new and GMP call that.
#pragma once

namespace failing_memory {

enum class Mode { once, from_then_on };

// Plain variables: the tests of failing memory use one thread.
inline bool armed = false, failed = false;
inline long requests = 0, fail_at = 0, blocks = 0; // blocks: now in use
inline Mode mode = Mode::once;

/// Count one request; true if it must fail.
inline bool must_fail() {
  if (!armed) return false;
  ++requests;
  if (fail_at == 0 || requests < fail_at || (mode == Mode::once && requests > fail_at))
    return false;
  return failed = true;
}

/// From now on let the count-th request fail (counting from 1; 0: none), alone or with all after
/// it.
inline void arm(long count, Mode how) {
  requests = 0;
  fail_at = count;
  mode = how;
  failed = false;
  armed = true;
}

/// No more failures. Returns how many requests there were since arm().
inline long disarm() {
  armed = false;
  return requests;
}

} // namespace failing_memory
