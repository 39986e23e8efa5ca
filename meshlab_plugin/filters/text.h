// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in sentences, the same in every locale.
#pragma once

#include <cstdint>
#include <string>

namespace vbm_filters {

std::string number(double value);       // "0.0125", six digits; "nan", "inf"
std::string count(std::uint64_t value); // "34834"
// "1 vertex", "3 vertices"
std::string count(std::uint64_t value, const char *one, const char *many);

} // namespace vbm_filters
