// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in sentences, the same in every locale.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace vbm_filters {

std::string number(double value); // "0.0125", six digits; "nan", "inf"
// The number that a person would write for a float: 0.1, not 0.10000000149011612. It is read back
// as the same float.
double as_written(float value);
inline double as_written(double value) { return value; }
std::string count(std::uint64_t value); // "34834"
// "1 vertex", "3 vertices"
std::string count(std::uint64_t value, const char *one, const char *many);

// Of the library's labels, which are English.
std::string lower(std::string text);

// The library's notes, one sentence a line, each as a line of the log.
void add_notes(const char *notes, std::vector<std::string> &log);

} // namespace vbm_filters
