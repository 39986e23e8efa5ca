// SPDX-License-Identifier: GPL-3.0-or-later
// Balls from PLY files. Faces become triangles (a polygon a fan); elements and properties that are
// not known are skipped. Written here because the libraries Debian has keep no radius (OpenMesh) or
// no more than floats, or are not packaged (tinyply, happly).
#include "files/formats.h"
#include "files/ply_header.h"
#include "files/text.h"

#include <cmath>
#include <cstring>

namespace vbm::files {
namespace {

constexpr int kNone = -1;

/// The data, number by number, and where the reading is.
class Numbers {
public:
  Numbers(const PlyHeader &header, std::string_view bytes)
      : format_(header.format), bytes_(bytes), at_(header.size),
        lines_(bytes.substr(header.size), header.lines + 1) {}

  /// Before each element.
  void begin_row(const std::string &name, uint64_t index) {
    name_ = &name;
    index_ = index;
    if (format_ != PlyFormat::ascii) return;
    do
      if (!lines_.next()) fail("is missing: the file ends");
    while (split_words(lines_.line(), words_), words_.empty());
    next_ = 0;
  }
  void end_row() {
    if (format_ == PlyFormat::ascii && next_ != words_.size()) fail("has too many numbers");
  }

  double read(PlyType type, const char *what) {
    if (format_ != PlyFormat::ascii) return read_binary(type);
    return finite_number(word(), lines_.number(), what);
  }
  uint64_t read_count(PlyType type) {
    if (format_ == PlyFormat::ascii)
      return whole_number(word(), lines_.number(), "the number of a list's items");
    const double count = read_binary(type);
    if (count < 0) fail("has a list of a negative number of items");
    return uint64_t(count);
  }
  /// How many more numbers of this type there can be.
  uint64_t room(PlyType type) const {
    return format_ == PlyFormat::ascii ? words_.size() - next_
                                       : (bytes_.size() - at_) / size_of(type);
  }

  [[noreturn]] void fail(const std::string &why) const {
    const std::string what = "element \"" + *name_ + "\" " + std::to_string(index_) + " " + why;
    if (format_ == PlyFormat::ascii) bad_line(lines_.number(), what);
    throw BadFile("byte " + std::to_string(at_) + ": " + what);
  }

private:
  std::string_view word() {
    if (next_ == words_.size()) fail("has too few numbers");
    return words_[next_++];
  }

  template <class T> T raw() {
    if (bytes_.size() - at_ < sizeof(T)) fail("is cut off: the file ends");
    unsigned char b[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i)
      b[format_ == little_here() ? i : sizeof(T) - 1 - i] =
          static_cast<unsigned char>(bytes_[at_ + i]);
    at_ += sizeof(T);
    T value;
    std::memcpy(&value, b, sizeof value);
    return value;
  }

  static PlyFormat little_here() {
    const uint16_t one = 1;
    unsigned char first;
    std::memcpy(&first, &one, 1);
    return first ? PlyFormat::little_endian : PlyFormat::big_endian;
  }

  double read_binary(PlyType type) {
    switch (type) {
    case PlyType::int8:
      return raw<int8_t>();
    case PlyType::uint8:
      return raw<uint8_t>();
    case PlyType::int16:
      return raw<int16_t>();
    case PlyType::uint16:
      return raw<uint16_t>();
    case PlyType::int32:
      return raw<int32_t>();
    case PlyType::uint32:
      return raw<uint32_t>();
    case PlyType::float32:
      return double(raw<float>());
    case PlyType::float64:
      break;
    }
    return raw<double>();
  }

  const PlyFormat format_;
  const std::string_view bytes_;
  std::size_t at_;
  Lines lines_;
  std::vector<std::string_view> words_;
  std::size_t next_ = 0;
  const std::string *name_ = nullptr;
  uint64_t index_ = 0;
};

int32_t whole(const Numbers &numbers, double value, const std::string &name) {
  if (!(value >= -2147483648.0 && value <= 2147483647.0) || value != std::floor(value))
    numbers.fail("has a " + name + " that is no index");
  return int32_t(value);
}

/// One element's properties: the lone numbers in `values`, the items of one list in `list`.
void read_row(Numbers &numbers, const PlyElement &element, int list_property,
              std::vector<double> &values, std::vector<double> &list) {
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty &property = element.properties[p];
    if (!property.list) {
      values[p] = numbers.read(property.type, property.name.c_str());
      continue;
    }
    const uint64_t count = numbers.read_count(property.count_type);
    if (count > numbers.room(property.type))
      numbers.fail("has a list of " + std::to_string(count) +
                   " items, more than the file has room for");
    const bool keep = int(p) == list_property;
    if (keep) list.clear();
    for (uint64_t i = 0; i < count; ++i) {
      const double item = numbers.read(property.type, property.name.c_str());
      if (keep) list.push_back(item);
    }
  }
}

void read_vertices(Numbers &numbers, const PlyElement &element, BallFile &balls) {
  const int at[] = {property_of(element, {"x"}), property_of(element, {"y"}),
                    property_of(element, {"z"}), property_of(element, {"radius", "r"})};
  const char *const names[] = {"x", "y", "z", "radius"};
  std::vector<std::pair<std::string, std::size_t>> extra;
  for (const char *name : {"part", "level"})
    if (const int p = property_of(element, {name});
        p != kNone && !element.properties[std::size_t(p)].list)
      extra.push_back({name, std::size_t(p)}), balls.attributes[name];
  std::vector<double> values(element.properties.size()), list;
  for (uint64_t i = 0; i < element.count; ++i) {
    numbers.begin_row(element.name, i);
    read_row(numbers, element, kNone, values, list);
    for (int k = 0; k < 4; ++k) {
      const double value = values[std::size_t(at[k])];
      if (!std::isfinite(value)) numbers.fail(std::string("has no finite ") + names[k]);
      if (k < 3) balls.centers.push_back(value);
    }
    if (values[std::size_t(at[3])] < 0) numbers.fail("has a negative radius");
    balls.radii.push_back(values[std::size_t(at[3])]);
    for (const auto &[name, p] : extra)
      balls.attributes[name].push_back(whole(numbers, values[p], name));
    numbers.end_row();
  }
}

int32_t corner(const Numbers &numbers, double value, std::size_t count) {
  const int32_t index = whole(numbers, value, "vertex");
  if (index < 0 || std::size_t(index) >= count)
    numbers.fail("has the vertex " + std::to_string(index) + ", but there are " +
                 std::to_string(count));
  return index;
}

} // namespace

void check_ply_head(std::string_view head, uint64_t total) {
  Lines lines(head);
  if (head.size() == total || !lines.next() || lines.line() != "ply" ||
      head.find("\nend_header") != head.npos || head.find("\rend_header") != head.npos)
    read_ply_header(head, total);
}

BallFile read_ply(const std::string &bytes) {
  const PlyHeader header = read_ply_header(bytes, bytes.size());
  uint64_t count = 0;
  for (const PlyElement &e : header.elements)
    if (e.name == "vertex") count = e.count;
  BallFile balls;
  balls.centers.reserve(3 * count);
  balls.radii.reserve(count);
  Numbers numbers(header, bytes);
  std::vector<double> values, list;
  for (const PlyElement &element : header.elements) {
    if (element.name == "vertex") {
      read_vertices(numbers, element, balls);
      continue;
    }
    int corners =
        element.name == "face" ? property_of(element, {"vertex_indices", "vertex_index"}) : kNone;
    const bool edge = element.name == "edge";
    const int ends[] = {property_of(element, {"vertex1"}), property_of(element, {"vertex2"})};
    if (corners != kNone && !element.properties[std::size_t(corners)].list) corners = kNone;
    values.assign(element.properties.size(), 0);
    for (uint64_t i = 0; i < element.count; ++i) {
      numbers.begin_row(element.name, i);
      list.clear();
      read_row(numbers, element, corners, values, list);
      for (std::size_t k = 2; k < list.size(); ++k)
        for (const double item : {list[0], list[k - 1], list[k]})
          balls.triangles.push_back(corner(numbers, item, count));
      if (edge)
        for (const int end : ends)
          balls.edges.push_back(corner(numbers, values[std::size_t(end)], count));
      numbers.end_row();
    }
  }
  return balls;
}

} // namespace vbm::files
