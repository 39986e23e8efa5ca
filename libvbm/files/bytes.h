// SPDX-License-Identifier: GPL-3.0-or-later
// Whole files.
#pragma once

#include <filesystem>
#include <string>

namespace vbm::files {

/// Throws NoFile.
std::string read_bytes(const std::filesystem::path &path);

/// Complete, or not at all: whatever stood there before is untouched until all is written. Throws
/// NoFile.
void write_bytes(const std::filesystem::path &path, const std::string &bytes);

} // namespace vbm::files
