// SPDX-License-Identifier: GPL-3.0-or-later
#include "text.h"

#include <charconv>
#include <sstream>

namespace vbm_filters {

std::string number(double value) {
  char buffer[64];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 6);
  return std::string(buffer, end.ptr);
}

double as_written(float value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  double result = value;
  std::from_chars(text, end, result);
  return result;
}

std::string count(std::uint64_t value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, end.ptr);
}

std::string count(std::uint64_t value, const char *one, const char *many) {
  return count(value) + " " + (value == 1 ? one : many);
}

std::string lower(std::string text) {
  for (char &c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

void add_notes(const char *notes, std::vector<std::string> &log) {
  std::istringstream lines(notes);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) log.push_back(line);
}

} // namespace vbm_filters
