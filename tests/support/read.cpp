// SPDX-License-Identifier: GPL-3.0-or-later
#include "read.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>
#include <string_view>

namespace {

/// Words of a text, line by line; CR, LF and CRLF all end a line.
class Lines {
public:
  explicit Lines(const std::string &path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot open " + path);
    text_.assign(std::istreambuf_iterator<char>(file), {});
    if (text_.rfind("\xef\xbb\xbf", 0) == 0) at_ = 3;
  }

  bool empty() const { return text_.empty(); }

  /// The next line that has a word and is no comment; false at the end.
  bool next() {
    while (at_ < text_.size()) {
      ++line_;
      const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
      split(std::string_view(text_).substr(at_, end - at_));
      at_ = end + 1;
      if (end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n') ++at_;
      if (!words.empty() && words[0][0] != '#') return true;
    }
    words.clear();
    return false;
  }

  [[noreturn]] void fail(const std::string &what) const {
    throw std::runtime_error("line " + std::to_string(line_) + ": " + what);
  }

  double real(std::size_t word) const {
    const std::string_view w = at(word);
    if (w.find(',') != w.npos) fail("decimal comma in " + std::string(w));
    const bool minus = w[0] == '-', plus = w[0] == '+';
    const std::string_view digits = w.substr(plus);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.begin(), digits.end(), value);
    if (error == std::errc::result_out_of_range)
      return exponent_below_zero(w) ? 0
                                    : (minus ? -1 : 1) * std::numeric_limits<double>::infinity();
    if (error != std::errc() || end != digits.end()) fail("no number: " + std::string(w));
    return value;
  }

  long long integer(std::size_t word) const {
    const std::string_view w = at(word);
    long long value = 0;
    const auto [end, error] = std::from_chars(w.begin(), w.end(), value);
    if (error != std::errc() || (end != w.end() && *end != '/')) // OBJ: vertex/texture/normal
      fail("no whole number: " + std::string(w));
    return value;
  }

  std::vector<std::string_view> words;

private:
  void split(std::string_view line) {
    words.clear();
    constexpr const char *kSpace = " \t";
    for (std::size_t i = line.find_first_not_of(kSpace); i < line.size();
         i = line.find_first_not_of(kSpace, i)) {
      const std::size_t end = std::min(line.find_first_of(kSpace, i), line.size());
      words.push_back(line.substr(i, end - i));
      i = end;
    }
  }
  static bool exponent_below_zero(std::string_view w) { return w.find("e-") != w.npos; }
  std::string_view at(std::size_t word) const {
    if (word >= words.size()) fail("too few words");
    return words[word];
  }

  std::string text_;
  std::size_t at_ = 0, line_ = 0;
};

void read_point(const Lines &lines, std::size_t word, Geometry &out) {
  for (std::size_t a = 0; a < 3; ++a) out.points.push_back(lines.real(word + a));
}

Geometry read_xyz(Lines &lines) {
  Geometry out;
  while (lines.next()) read_point(lines, 0, out);
  return out;
}

Geometry read_off(Lines &lines) {
  Geometry out;
  if (!lines.next() || lines.words[0] != "OFF") lines.fail("not OFF");
  if (!lines.next()) lines.fail("no counts");
  const long long vertices = lines.integer(0), faces = lines.integer(1);
  if (vertices < 0 || faces < 0) lines.fail("a negative count");
  for (long long v = 0; v < vertices; ++v) { // no memory before there is a line for it
    if (!lines.next()) lines.fail("the file ends before its last vertex");
    read_point(lines, 0, out);
  }
  for (long long f = 0; f < faces; ++f) {
    if (!lines.next()) lines.fail("the file ends before its last face");
    const long long corners = lines.integer(0);
    if (corners < 0 || std::size_t(corners) + 1 > lines.words.size()) lines.fail("too few corners");
    out.sizes.push_back(uint32_t(corners));
    for (long long c = 1; c <= corners; ++c)
      out.corners.push_back(int32_t(lines.integer(std::size_t(c))));
  }
  return out;
}

Geometry read_obj(Lines &lines) {
  Geometry out;
  while (lines.next()) {
    const std::string_view key = lines.words[0];
    for (char c : key)
      if (c < 32 || c > 126) lines.fail("not a Wavefront OBJ");
    if (key == "v") {
      read_point(lines, 1, out);
    } else if (key == "f") {
      out.sizes.push_back(uint32_t(lines.words.size() - 1));
      for (std::size_t c = 1; c < lines.words.size(); ++c) {
        const long long i = lines.integer(c), n = (long long)(out.size());
        if (i == 0 || i > n || i < -n) lines.fail("no such vertex");
        out.corners.push_back(int32_t(i > 0 ? i - 1 : n + i));
      }
    }
  }
  return out;
}

} // namespace

Geometry read_geometry(const std::string &path) {
  Lines lines(path);
  const std::string extension = path.substr(path.rfind('.') + 1);
  if (extension == "xyz") return read_xyz(lines);
  if (lines.empty()) lines.fail("the file is empty");
  if (extension == "off") return read_off(lines);
  if (extension == "obj") return read_obj(lines);
  throw std::runtime_error("line 0: a ." + extension + " file is not read here");
}
