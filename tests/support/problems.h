// SPDX-License-Identifier: GPL-3.0-or-later
// What a check found wrong, in sentences. No test framework, so that the fuzz target can use it.
#pragma once

#include <cstddef>
#include <string>

class Problems {
public:
  /// Add a sentence unless there are many already.
  void add(const std::string &sentence) {
    if (++count_ <= 8) text_ += sentence + "\n";
  }
  /// Add the sentence if `holds` is false.
  void require(bool holds, const char *sentence) {
    if (!holds) add(sentence);
  }
  void require(bool holds, const char *sentence, std::size_t where) {
    if (!holds) add(std::string(sentence) + " (" + std::to_string(where) + ")");
  }
  bool none() const { return count_ == 0; }
  std::string text() const {
    return count_ <= 8 ? text_ : text_ + "... " + std::to_string(count_) + " in all\n";
  }

private:
  std::string text_;
  std::size_t count_ = 0;
};
