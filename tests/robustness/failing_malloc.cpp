// SPDX-License-Identifier: GPL-3.0-or-later
// For glibc, which keeps its own functions under other names.
#include "failing_memory.h"

#include <cerrno>
#include <cstddef>

// The libraries must find these instead of glibc's: memory that is not counted when it is taken
// would be when it is given back.
#pragma GCC visibility push(default)
extern "C" {

void *__libc_malloc(std::size_t);
void *__libc_calloc(std::size_t, std::size_t);
void *__libc_realloc(void *, std::size_t);
void *__libc_memalign(std::size_t, std::size_t);
void __libc_free(void *);

static void *counted(void *p) {
  failing_memory::blocks += p != nullptr;
  return p;
}
static void *refuse() {
  errno = ENOMEM;
  return nullptr;
}

void *malloc(std::size_t size) {
  return failing_memory::must_fail() ? refuse() : counted(__libc_malloc(size));
}
void *calloc(std::size_t count, std::size_t size) {
  return failing_memory::must_fail() ? refuse() : counted(__libc_calloc(count, size));
}
void *realloc(void *old, std::size_t size) {
  if (failing_memory::must_fail()) return refuse();
  void *p = __libc_realloc(old, size);
  if (!old) return counted(p);
  failing_memory::blocks -= size == 0 && !p;
  return p;
}
void *memalign(std::size_t alignment, std::size_t size) {
  return failing_memory::must_fail() ? refuse() : counted(__libc_memalign(alignment, size));
}
void *aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }
int posix_memalign(void **out, std::size_t alignment, std::size_t size) {
  void *p = memalign(alignment, size);
  if (!p) return ENOMEM;
  *out = p;
  return 0;
}
void free(void *p) {
  failing_memory::blocks -= p != nullptr;
  __libc_free(p);
}

} // extern "C"
#pragma GCC visibility pop
