// SPDX-License-Identifier: GPL-3.0-or-later
// The conflict test of a power diagram with four doubles at once, where the processor has them.
#pragma once

#include "surface/power_predicates.h"

namespace vbm::impl {

#if defined(__x86_64__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12)
#define VBM_FOUR_DOUBLES 1

/// Whether power_side_wide() may be called.
inline bool has_four_doubles() { return __builtin_cpu_supports("avx2"); }
/// As power_side(): the sign is exact, so that it is the same however it was found.
int power_side_wide(const Site &a, const Site &b, const Site &c, const Site &d, const Site &p);

#else

inline bool has_four_doubles() { return false; }
inline int power_side_wide(const Site &a, const Site &b, const Site &c, const Site &d,
                           const Site &p) {
  return power_side(a, b, c, d, p);
}

#endif

} // namespace vbm::impl
