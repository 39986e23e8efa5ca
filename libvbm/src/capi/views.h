// SPDX-License-Identifier: GPL-3.0-or-later
// Borrowed arrays of the handles, and copies of their reports.
#pragma once

#include "core/model.h"

#include <vbm/vbm.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace vbm::impl {

/// `width` numbers an element.
template <class T> const T *view(const std::vector<T> &v, std::size_t width, size_t *count) {
  if (count) *count = v.size() / width;
  return v.data();
}

inline const int32_t *view(const Incidence &lists, const uint64_t **offsets, size_t *count) {
  if (offsets) *offsets = lists.offset.data();
  if (count) *count = lists.index.size();
  return lists.index.data();
}

template <class T> const T *none(size_t *count) {
  if (count) *count = 0;
  return nullptr;
}

inline const int32_t *none(const uint64_t **offsets, size_t *count) {
  if (offsets) *offsets = nullptr;
  return none<int32_t>(count);
}

/// Copy as much of a report as the caller's struct_size has room for; clear what this library does
/// not know.
template <class Report> vbm_status copy_report(const Report *from, Report *to) {
  if (!from || !to || to->struct_size < sizeof(size_t)) return VBM_ERROR_ARGUMENT;
  const size_t size = to->struct_size;
  std::memset(static_cast<void *>(to), 0, size);
  std::memcpy(to, from, std::min(size, sizeof *from));
  to->struct_size = size;
  return VBM_OK;
}

} // namespace vbm::impl
