// SPDX-License-Identifier: GPL-3.0-or-later
#include "medial/lock_text.h"

namespace vbm::impl {
namespace {

/// Numbers of parts in one sentence; vbm_axis_stayed() has them all.
constexpr std::size_t kShown = 12;

} // namespace

const char *lock_text(int32_t lock) {
  switch (lock) {
  case VBM_LOCK_INNER:
    return "it has no border, so the parts around it must go first";
  case VBM_LOCK_TUNNEL:
    return "a tunnel or cavity of the shape would be lost";
  case VBM_LOCK_BRIDGE:
    return "the shape would fall apart";
  case VBM_LOCK_LAST:
    return "it is all that is left of a piece of the shape";
  case VBM_LOCK_NONE:
    break;
  }
  return "";
}

std::string stayed_text(const std::vector<int32_t> &parts, const std::vector<int32_t> &locks) {
  std::string text;
  for (int lock = VBM_LOCK_INNER; lock <= VBM_LOCK_LAST; ++lock) {
    std::string numbers;
    std::size_t count = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (locks[i] != lock) continue;
      if (count < kShown) numbers += (count ? ", " : "") + std::to_string(parts[i]);
      ++count;
    }
    if (count > kShown) numbers += ", ...";
    if (count)
      text +=
          std::to_string(count) +
          (count == 1 ? " part below the threshold stays: " : " parts below the threshold stay: ") +
          lock_text(lock) + " (" + numbers + ")\n";
  }
  return text;
}

} // namespace vbm::impl
