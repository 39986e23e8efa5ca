// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/ply_header.h"

#include "files/ball_file.h"
#include "files/text.h"

#include <algorithm>

namespace vbm::files {
namespace {

/// Elements and properties beyond this are no model: a header of any length is read in linear time.
constexpr std::size_t kMostElements = 64, kMostProperties = 256;

PlyType type_of(std::string_view word, std::size_t line) {
  const struct {
    const char *name, *other;
    PlyType type;
  } types[] = {{"char", "int8", PlyType::int8},        {"uchar", "uint8", PlyType::uint8},
               {"short", "int16", PlyType::int16},     {"ushort", "uint16", PlyType::uint16},
               {"int", "int32", PlyType::int32},       {"uint", "uint32", PlyType::uint32},
               {"float", "float32", PlyType::float32}, {"double", "float64", PlyType::float64}};
  for (const auto &t : types)
    if (word == t.name || word == t.other) return t.type;
  bad_line(line, shown(word) + " is no type of a PLY property");
}

void check_sizes(const PlyHeader &header, uint64_t left) {
  for (const PlyElement &element : header.elements) {
    const uint64_t each = element.least_size(header.format);
    // The last line of a text needs no end.
    const uint64_t room = each ? (left + (header.format == PlyFormat::ascii)) / each : 0;
    if (element.count > room || element.count > INT32_MAX)
      bad_line(element.line, std::to_string(element.count) + " elements \"" + element.name +
                                 "\" are announced, more than the " + std::to_string(left) +
                                 " bytes after them have room for");
    left -= std::min(left, element.count * each);
  }
}

/// That there are vertices, once, and that these are balls.
void check_elements(const PlyHeader &header) {
  const PlyElement *vertex = nullptr;
  for (const PlyElement &e : header.elements) {
    if (e.name == "vertex") {
      if (vertex) bad_line(e.line, "this is the second element \"vertex\"");
      vertex = &e;
    } else if (e.name == "edge" &&
               (property_of(e, {"vertex1"}) < 0 || property_of(e, {"vertex2"}) < 0)) {
      bad_line(e.line, "the edges have no vertices");
    }
  }
  if (!vertex)
    bad_line(header.lines, "there is no element \"vertex\" before this end of the header");
  const std::initializer_list<const char *> names[] = {{"x"}, {"y"}, {"z"}, {"radius", "r"}};
  for (const auto &name : names) {
    const int p = property_of(*vertex, name);
    if (p < 0 || vertex->properties[std::size_t(p)].list)
      bad_line(vertex->line, std::string("the vertices have no ") + *name.begin());
  }
}

} // namespace

int property_of(const PlyElement &element, std::initializer_list<const char *> names) {
  for (const char *name : names)
    for (std::size_t i = 0; i < element.properties.size(); ++i)
      if (element.properties[i].name == name) return int(i);
  return -1;
}

std::size_t size_of(PlyType type) {
  switch (type) {
  case PlyType::int8:
  case PlyType::uint8:
    return 1;
  case PlyType::int16:
  case PlyType::uint16:
    return 2;
  case PlyType::int32:
  case PlyType::uint32:
  case PlyType::float32:
    return 4;
  case PlyType::float64:
    break;
  }
  return 8;
}

uint64_t PlyElement::least_size(PlyFormat format) const {
  uint64_t size = 0;
  for (const PlyProperty &p : properties)
    size += format == PlyFormat::ascii ? 2 // a digit and what follows it
                                       : size_of(p.list ? p.count_type : p.type);
  return size;
}

PlyHeader read_ply_header(std::string_view bytes, uint64_t total) {
  PlyHeader header;
  Lines lines(bytes);
  std::vector<std::string_view> words;
  if (bytes.empty()) bad_line(1, "the file is empty");
  if (!lines.next() || lines.line() != "ply") throw BadFile("line 1: no PLY file begins like this");
  bool format = false;
  while (lines.next()) {
    const std::size_t n = lines.number();
    split_words(lines.line(), words);
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") {
      if (!format) bad_line(n, "the header names no format");
      header.size = lines.position();
      header.lines = n;
      check_sizes(header, total - header.size);
      check_elements(header);
      return header;
    }
    if (words[0] == "format") {
      if (words.size() < 3) bad_line(n, "the format is incomplete");
      if (words[2] != "1.0") bad_line(n, "PLY version " + shown(words[2]) + " is not known");
      if (words[1] == "ascii")
        header.format = PlyFormat::ascii;
      else if (words[1] == "binary_little_endian")
        header.format = PlyFormat::little_endian;
      else if (words[1] == "binary_big_endian")
        header.format = PlyFormat::big_endian;
      else
        bad_line(n, shown(words[1]) + " is no format of PLY files");
      format = true;
    } else if (words[0] == "element") {
      if (words.size() != 3) bad_line(n, "an element needs a name and a number");
      if (header.elements.size() == kMostElements) bad_line(n, "there are too many elements");
      PlyElement element;
      element.name = std::string(words[1]);
      element.line = n;
      element.count = whole_number(words[2], n, "the number of elements");
      header.elements.push_back(std::move(element));
    } else if (words[0] == "property") {
      if (header.elements.empty()) bad_line(n, "a property comes before any element");
      auto &properties = header.elements.back().properties;
      if (properties.size() == kMostProperties) bad_line(n, "there are too many properties");
      PlyProperty property{};
      property.list = words.size() > 1 && words[1] == "list";
      if (words.size() != (property.list ? 5u : 3u)) bad_line(n, "the property is incomplete");
      if (property.list) property.count_type = type_of(words[2], n);
      if (property.count_type == PlyType::float32 || property.count_type == PlyType::float64)
        bad_line(n, "the number of a list's items is no whole number");
      property.type = type_of(words[words.size() - 2], n);
      property.name = std::string(words.back());
      properties.push_back(std::move(property));
    } else {
      bad_line(n, shown(words[0]) + " is no part of a PLY header");
    }
  }
  throw BadFile("line " + std::to_string(lines.number()) + ": the header has no end");
}

} // namespace vbm::files
