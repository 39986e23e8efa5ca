// SPDX-License-Identifier: GPL-3.0-or-later
// The header of a PLY file. Turk, "The PLY polygon file format" (1994).
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
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
  std::size_t line = 0; // of the header
  std::vector<PlyProperty> properties;

  /// Bytes that one of them takes at least.
  uint64_t least_size(PlyFormat format) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0; // bytes: where the data begin
  std::size_t lines = 0;
};

/// Of a file of `total` bytes, of which `bytes` are the first. Throws BadFile for a header that is
/// wrong, that announces more than the file has room for, or of a file without balls.
PlyHeader read_ply_header(std::string_view bytes, uint64_t total);

/// Where an element has a property by one of these names; -1: nowhere.
int property_of(const PlyElement &element, std::initializer_list<const char *> names);

} // namespace vbm::files
