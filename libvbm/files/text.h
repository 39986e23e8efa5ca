// SPDX-License-Identifier: GPL-3.0-or-later
// Lines, words and numbers of text files, the same in every locale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vbm::files {

/// Throws BadFile("line N: why").
[[noreturn]] void bad_line(std::size_t line, const std::string &why);

/// What a message shows of a word from a file: in quotes, cut short, unprintable bytes as "?".
std::string shown(std::string_view word);

/// The lines of a text one after another, which may end in \n, \r\n or \r. A byte order mark at the
/// beginning is skipped.
class Lines {
public:
  explicit Lines(std::string_view text, std::size_t first_line = 1);
  /// False at the end.
  bool next();
  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }
  /// Where the next line begins.
  std::size_t position() const { return position_; }

private:
  std::string_view text_, line_;
  std::size_t position_ = 0, number_;
};

/// Words between blanks (spaces and tabs).
void split_words(std::string_view line, std::vector<std::string_view> &words);

/// A number, all of the word. Throw BadFile naming the line, for a decimal comma with a word on it.
double finite_number(std::string_view word, std::size_t line, const char *what);
uint64_t whole_number(std::string_view word, std::size_t line, const char *what);
/// An index below `count`.
int32_t index_below(std::string_view word, std::size_t count, std::size_t line, const char *what);
/// A finite number that is not negative.
double radius_number(std::string_view word, std::size_t line);

/// The shortest text that reads as the same number.
void append_number(std::string &out, double number);
void append_number(std::string &out, int64_t number);

} // namespace vbm::files
