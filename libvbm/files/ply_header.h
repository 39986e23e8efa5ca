// SPDX-License-Identifier: GPL-3.0-or-later
// The header of a PLY file. Turk, "The PLY polygon file format" (1994).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vbm::files {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyFormat { ascii, little_endian, big_endian };

std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  bool list = false;
  PlyType count_type = PlyType::uint8; // of a list
};

struct PlyElement {
  std::string name;
  uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Bytes that one of them takes at least.
  uint64_t least_size(PlyFormat format) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;       // bytes: where the data begin
  std::size_t lines = 0;
};

/// Throws BadFile for a header that is wrong, or that announces more than the file has room for.
PlyHeader read_ply_header(std::string_view bytes);

} // namespace vbm::files
