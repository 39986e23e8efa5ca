// SPDX-License-Identifier: GPL-3.0-or-later
// Asking for memory ahead of its use, for walks that jump through large arrays.
#pragma once

namespace vbm::impl {

inline void prefetch(const void *address) {
#ifdef __GNUC__
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

} // namespace vbm::impl
