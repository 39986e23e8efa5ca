// SPDX-License-Identifier: GPL-3.0-or-later
// Whole files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace vbm::files {

/// Throws NoFile, and what `check` throws, which sees the first 64 KiB and the size of the whole
/// before more is read or room for it made. It is not called for what has no size beforehand, as a
/// pipe.
std::string read_bytes(const std::filesystem::path &path,
                       const std::function<void(std::string_view head, uint64_t size)> &check);

/// Complete, or not at all: whatever stood there before is untouched until all is written. Throws
/// NoFile.
void write_bytes(const std::filesystem::path &path, const std::string &bytes);

} // namespace vbm::files
