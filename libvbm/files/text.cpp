// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/text.h"

#include "files/ball_file.h"

#include <charconv>
#include <cmath>
#include <system_error>

namespace vbm::files {
namespace {

constexpr std::size_t kShown = 40; // characters of a word in a message

/// from_chars without the signs it does not know.
template <class Number> std::errc parse(std::string_view word, Number &number) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const char *end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  return error == std::errc() && stop != end ? std::errc::invalid_argument : error;
}

} // namespace

void bad_line(std::size_t line, const std::string &why) {
  throw BadFile("line " + std::to_string(line) + ": " + why);
}

std::string shown(std::string_view word) {
  std::string out = "\"";
  for (char c : word.substr(0, kShown)) out += c >= 32 && c < 127 ? c : '?';
  return out + (word.size() > kShown ? "...\"" : "\"");
}

Lines::Lines(std::string_view text, std::size_t first_line)
    : text_(text), number_(first_line - 1) {
  if (text_.substr(0, 3) == "\xef\xbb\xbf") position_ = 3;
}

bool Lines::next() {
  if (position_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find_first_of("\r\n", position_), text_.size());
  line_ = text_.substr(position_, end - position_);
  position_ = end;
  if (position_ < text_.size())
    position_ += text_[position_] == '\r' && text_.substr(position_, 2) == "\r\n" ? 2 : 1;
  ++number_;
  return true;
}

void split_words(std::string_view line, std::vector<std::string_view> &words) {
  words.clear();
  for (std::size_t begin = 0; (begin = line.find_first_not_of(" \t", begin)) != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = end;
  }
}

double finite_number(std::string_view word, std::size_t line, const char *what) {
  double number = 0;
  const std::errc error = parse(word, number);
  if (error == std::errc() && std::isfinite(number)) return number;
  const std::string is = std::string(what) + " is " + shown(word);
  if (error == std::errc()) bad_line(line, is + ", which is not finite");
  if (error == std::errc::result_out_of_range)
    bad_line(line, is + ", which is beyond the range of numbers");
  if (word.find(',') != word.npos)
    bad_line(line, is + ", a decimal comma: decimals are written with a point");
  bad_line(line, is + ", which is no number");
}

uint64_t whole_number(std::string_view word, std::size_t line, const char *what) {
  uint64_t number = 0;
  if (parse(word, number) != std::errc())
    bad_line(line, std::string(what) + " is " + shown(word) + ", which is no whole number");
  return number;
}

int32_t index_below(std::string_view word, std::size_t count, std::size_t line, const char *what) {
  const uint64_t index = whole_number(word, line, what);
  if (index >= count)
    bad_line(line, std::string(what) + " is " + std::to_string(index) + ", but there are " +
                       std::to_string(count) + " balls, counted from 0");
  return int32_t(index);
}

double radius_number(std::string_view word, std::size_t line) {
  const double radius = finite_number(word, line, "the radius");
  if (radius < 0) bad_line(line, "the radius is " + shown(word) + ", which is negative");
  return radius;
}

void append_number(std::string &out, double number) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, number);
  out.append(buffer, result.ptr);
}

void append_number(std::string &out, int64_t number) { out += std::to_string(number); }

} // namespace vbm::files
