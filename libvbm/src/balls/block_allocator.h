// SPDX-License-Identifier: GPL-3.0-or-later
// Memory for CGAL's containers that is not lost when they run out of it.
//
// Compact_container takes a block of elements and then enters it in its list of blocks; if the list
// cannot grow, it forgets the block. Here the owner of the containers owns their blocks too.
#pragma once

#include <algorithm>
#include <cstddef>
#include <new>
#include <vector>

namespace vbm::impl {

/// Owns all blocks handed out while it was current and not given back.
class Blocks {
public:
  Blocks() = default;
  Blocks(const Blocks &) = delete;
  Blocks &operator=(const Blocks &) = delete;
  ~Blocks() {
    for (void *block : blocks_) ::operator delete(block);
  }

  void *allocate(std::size_t size) {
    blocks_.push_back(nullptr);
    try {
      blocks_.back() = ::operator new(size);
    } catch (...) {
      blocks_.pop_back();
      throw;
    }
    return blocks_.back();
  }
  void deallocate(void *block) {
    blocks_.erase(std::find(blocks_.begin(), blocks_.end(), block));
    ::operator delete(block);
  }

  /// Makes containers that are constructed in this scope and thread use `blocks`.
  class Scope {
  public:
    explicit Scope(Blocks &blocks) : before_(current()) { current() = &blocks; }
    ~Scope() { current() = before_; }
    Scope(const Scope &) = delete;
    Scope &operator=(const Scope &) = delete;

  private:
    Blocks *before_;
  };

  static Blocks *&current() {
    static thread_local Blocks *blocks = nullptr; // only within a Scope, as CGAL's containers are
    return blocks;                                // default-constructed deep in the triangulation
  }

private:
  std::vector<void *> blocks_;
};

/// A standard allocator: from the Blocks that were current when it was made, or from the heap.
template <class T> class BlockAllocator {
public:
  using value_type = T;

  BlockAllocator() : blocks_(Blocks::current()) {}
  template <class U> BlockAllocator(const BlockAllocator<U> &other) : blocks_(other.blocks()) {}

  T *allocate(std::size_t count) {
    const std::size_t size = count * sizeof(T);
    return static_cast<T *>(blocks_ ? blocks_->allocate(size) : ::operator new(size));
  }
  void deallocate(T *block, std::size_t) {
    if (blocks_)
      blocks_->deallocate(block);
    else
      ::operator delete(block);
  }

  Blocks *blocks() const { return blocks_; }
  template <class U> bool operator==(const BlockAllocator<U> &other) const {
    return blocks_ == other.blocks();
  }
  template <class U> bool operator!=(const BlockAllocator<U> &other) const {
    return !(*this == other);
  }

private:
  Blocks *blocks_;
};

} // namespace vbm::impl
