// SPDX-License-Identifier: GPL-3.0-or-later
// Lists that are large, made anew by every call.
//
// Memory that is given back to the system and taken anew costs as much as a twentieth of a call:
// the system clears every page, one at a time, when it is first written to. What becomes of freed
// memory is the C library's choice, and the host's; so blocks of these lists are kept for the next
// call, kKeptBytes at most in all.
#pragma once

#include <cstddef>
#include <limits>
#include <new>
#include <vector>

namespace vbm::impl {

/// A block of at least so many bytes, at the beginning of a page; throws std::bad_alloc. Any thread
/// may take and give blocks.
void *take_block(std::size_t bytes);
/// With the number it was taken for.
void give_block(void *block, std::size_t bytes) noexcept;

/// From so many bytes on memory is had in blocks; never where a sanitizer is to watch all of it,
/// which must then hold for all files that share a list.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define VBM_NO_BLOCKS 1
#endif
#endif
#if defined(VBM_NO_BLOCKS) || defined(__SANITIZE_ADDRESS__)
inline constexpr std::size_t kLargeBytes = std::numeric_limits<std::size_t>::max();
#else
inline constexpr std::size_t kLargeBytes = 128 << 10;
#endif

template <class T> class LargeAllocator {
public:
  using value_type = T;

  LargeAllocator() = default;
  template <class U> LargeAllocator(const LargeAllocator<U> &) {}

  T *allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_alloc();
    const std::size_t bytes = count * sizeof(T);
    if (bytes >= kLargeBytes) return static_cast<T *>(take_block(bytes));
    return static_cast<T *>(::operator new(bytes, std::align_val_t(kAlign)));
  }
  void deallocate(T *at, std::size_t count) noexcept {
    if (count * sizeof(T) >= kLargeBytes)
      give_block(at, count * sizeof(T));
    else
      ::operator delete(at, std::align_val_t(kAlign));
  }

  template <class U> bool operator==(const LargeAllocator<U> &) const { return true; }
  template <class U> bool operator!=(const LargeAllocator<U> &) const { return false; }

private:
  static constexpr std::size_t kAlign = alignof(T) > 16 ? alignof(T) : 16;
};

template <class T> using LargeList = std::vector<T, LargeAllocator<T>>;

} // namespace vbm::impl
