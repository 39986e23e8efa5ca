// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/large_list.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>

#include <sys/mman.h>

namespace vbm::impl {
namespace {

/// What is kept at most: of a call with ten thousand balls, all.
constexpr std::size_t kKeptBytes = 16 << 20;

/// From so many bytes on pages are to be large ones, where there are any.
constexpr std::size_t kLargePages = 4 << 20;

constexpr std::size_t kLeast = 128 << 10;

/// Sizes of blocks: powers of two, and those half as large again, so that those that are kept fit
/// others.
std::size_t size_of(std::size_t bytes) {
  std::size_t size = kLeast;
  while (size < bytes) {
    if (size > std::numeric_limits<std::size_t>::max() / 4) throw std::bad_alloc();
    if (size + size / 2 >= bytes) return size + size / 2;
    size *= 2;
  }
  return size;
}

/// Blocks that are kept, those that were given first before the others. Who cannot have the lock at
/// once does without: so nobody waits, nor does a process that was forked while another thread had
/// it.
class Kept {
public:
  /// One of that size, or null.
  void *take(std::size_t size) {
    const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
    for (std::size_t i = lock ? count_ : 0; i-- > 0;)
      if (block_[i].size == size) return remove(i);
    return nullptr;
  }

  /// False if it is not kept.
  bool put(void *at, std::size_t size) {
    const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
    if (!lock || closed_) return false;
    while (count_ > 0 && (count_ == block_.size() || bytes_ + size > kKeptBytes)) drop_first();
    block_[count_++] = {at, size};
    bytes_ += size;
    return true;
  }

  /// Gives all back; none is kept any more if it is `last`.
  void drop(bool last) {
    const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
    if (last) closed_ = true;
    while (lock && count_ > 0) drop_first();
  }

private:
  struct Block {
    void *at;
    std::size_t size;
  };

  void drop_first() {
    const std::size_t size = block_[0].size;
    munmap(remove(0), size);
  }

  void *remove(std::size_t i) {
    void *const at = block_[i].at;
    bytes_ -= block_[i].size;
    std::copy(block_.begin() + std::ptrdiff_t(i) + 1, block_.begin() + std::ptrdiff_t(count_),
              block_.begin() + std::ptrdiff_t(i));
    --count_;
    return at;
  }

  std::mutex mutex_;
  std::array<Block, 64> block_{};
  std::size_t count_ = 0, bytes_ = 0;
  std::atomic<bool> closed_{false}; // also by who does not get the lock
};

Kept kept; // is never destroyed: lists may be freed after the end

/// When the library is unloaded.
struct AtEnd {
  ~AtEnd() { kept.drop(true); }
} at_end;

void *map_block(std::size_t size) {
  void *const at = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return at == MAP_FAILED ? nullptr : at;
}

} // namespace

void *take_block(std::size_t bytes) {
  const std::size_t size = size_of(bytes);
  if (void *const at = kept.take(size)) return at;
  void *at = map_block(size);
  if (!at) { // what lies idle may be what is missing
    kept.drop(false);
    at = map_block(size);
  }
  if (!at) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  if (size >= kLargePages) madvise(at, size, MADV_HUGEPAGE);
#endif
  return at;
}

void give_block(void *block, std::size_t bytes) noexcept {
  const std::size_t size = size_of(bytes);
  if (size > kKeptBytes / 4 || !kept.put(block, size)) munmap(block, size);
}

} // namespace vbm::impl
