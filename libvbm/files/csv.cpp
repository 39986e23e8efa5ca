// SPDX-License-Identifier: GPL-3.0-or-later
// Comma-separated values: x, y, z and radius by name where there is a header, else in this order.
// Semicolons and tabs separate as well; lines that are empty or begin with # are skipped.
#include "files/formats.h"
#include "files/text.h"

#include <algorithm>
#include <array>
#include <limits>

namespace vbm::files {
namespace {

constexpr std::size_t kNone = std::size_t(-1);

using Words = std::vector<std::string_view>;

std::string_view trimmed(std::string_view word) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!word.empty() && blank(word.front())) word.remove_prefix(1);
  while (!word.empty() && blank(word.back())) word.remove_suffix(1);
  return word;
}

std::string_view unquoted(std::string_view word) {
  word = trimmed(word);
  if (word.size() >= 2 && word.front() == '"' && word.back() == '"')
    word = word.substr(1, word.size() - 2);
  return word;
}

void split(std::string_view line, char separator, Words &fields) {
  fields.clear();
  for (std::size_t begin = 0;;) {
    const std::size_t end = line.find(separator, begin);
    fields.push_back(unquoted(line.substr(begin, end == line.npos ? end : end - begin)));
    if (end == line.npos) return;
    begin = end + 1;
  }
}

std::size_t column(const Words &header, std::initializer_list<const char *> names) {
  for (const char *name : names)
    for (std::size_t i = 0; i < header.size(); ++i) {
      std::string lower(header[i]);
      for (char &c : lower)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
      if (lower == name) return i;
    }
  return kNone;
}

/// Whether no field could be a number: they all begin with a letter.
bool is_header(const Words &fields) {
  return std::all_of(fields.begin(), fields.end(), [](std::string_view f) {
    return !f.empty() && ((f[0] >= 'a' && f[0] <= 'z') || (f[0] >= 'A' && f[0] <= 'Z')) &&
           f != "nan" && f != "inf" && f != "NaN" && f != "Inf";
  });
}

std::string columns(std::size_t count) {
  return count == 1 ? "there is 1 column" : "there are " + std::to_string(count) + " columns";
}

/// False if there is not one line to take.
bool read_lines(std::string_view bytes, BallFile &balls) {
  std::array<std::size_t, 4> at = {0, 1, 2, 3};
  std::vector<std::pair<std::string, std::size_t>> extra; // attributes and their columns
  std::size_t width = 0;
  char separator = 0;
  Words fields;
  for (Lines lines(bytes); lines.next();) {
    const std::string_view line = trimmed(lines.line());
    if (line.empty() || line.front() == '#') continue;
    const std::size_t n = lines.number();
    const bool first = !separator;
    if (first)
      separator = line.find(';') != line.npos ? ';' : line.find(',') != line.npos ? ',' : '\t';
    split(line, separator, fields);
    if (first) {
      width = fields.size();
      if (width < 4) bad_line(n, columns(width) + ", but x, y, z and radius are four");
      if (is_header(fields)) {
        at = {column(fields, {"x", "center_x", "cx"}), column(fields, {"y", "center_y", "cy"}),
              column(fields, {"z", "center_z", "cz"}), column(fields, {"radius", "r"})};
        const char *const names[] = {"x", "y", "z", "radius"};
        for (int i = 0; i < 4; ++i)
          if (at[std::size_t(i)] == kNone)
            bad_line(n, std::string("the header names no column \"") + names[i] + "\"");
        for (const char *name : {"part", "level"})
          if (const std::size_t c = column(fields, {name}); c != kNone) {
            extra.push_back({name, c});
            balls.attributes[name];
          }
        continue;
      }
    }
    if (fields.size() != width)
      bad_line(n, columns(fields.size()) + " where the first line has " + std::to_string(width));
    for (int i = 0; i < 3; ++i)
      balls.centers.push_back(finite_number(fields[at[std::size_t(i)]], n, "a coordinate"));
    balls.radii.push_back(radius_number(fields[at[3]], n));
    for (const auto &[name, c] : extra) {
      const double value = finite_number(fields[c], n, name.c_str());
      if (!(std::int32_t(std::clamp(value, -2147483648.0, 2147483647.0)) == value))
        bad_line(n, name + " is " + shown(fields[c]) + ", which is no index");
      balls.attributes[name].push_back(int32_t(value));
    }
  }
  return separator != 0;
}

} // namespace

void check_csv_head(std::string_view head, uint64_t total) {
  if (head.size() >= total) return; // all of it is here, and read next
  const std::size_t end = head.find_last_of("\r\n");
  if (end == head.npos) {
    if (head.front() == '#') return;
    bad_line(1, "it is longer than " + std::to_string(head.size()) + " bytes");
  }
  BallFile begun;
  read_lines(head.substr(0, end), begun);
}

BallFile read_csv(const std::string &bytes) {
  BallFile balls;
  if (!read_lines(bytes, balls)) bad_line(1, "the file is empty");
  return balls;
}

std::string write_csv(const BallFile &balls) {
  if (!balls.triangles.empty() || !balls.edges.empty())
    throw BadFile("a CSV file holds balls only, no triangles or edges: use .ply or .ma");
  std::string out = "x,y,z,radius";
  for (const auto &attribute : balls.attributes) out += "," + attribute.first;
  out += "\n";
  for (std::size_t i = 0; i < balls.radii.size(); ++i) {
    for (std::size_t a = 0; a < 3; ++a) {
      append_number(out, balls.centers[3 * i + a]);
      out += ",";
    }
    append_number(out, balls.radii[i]);
    for (const auto &attribute : balls.attributes) {
      out += ",";
      append_number(out, int64_t(attribute.second[i]));
    }
    out += "\n";
  }
  return out;
}

} // namespace vbm::files
