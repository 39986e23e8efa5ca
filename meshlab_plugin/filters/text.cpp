// SPDX-License-Identifier: GPL-3.0-or-later
#include "text.h"

#include <charconv>

namespace vbm_filters {

std::string number(double value) {
  char buffer[64];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 6);
  return std::string(buffer, end.ptr);
}

std::string count(std::uint64_t value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, end.ptr);
}

std::string count(std::uint64_t value, const char *one, const char *many) {
  return count(value) + " " + (value == 1 ? one : many);
}

} // namespace vbm_filters
