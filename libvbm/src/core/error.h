// SPDX-License-Identifier: GPL-3.0-or-later
// The one exception the library throws on purpose; the C interface turns it into a status.
#pragma once

#include <vbm/vbm.h>

#include <cstdint>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace vbm::impl {

/// A failure with one sentence saying what is wrong and where. `elements` are the input elements it
/// is about (at most kMaxListed of them), `kind` what they are, `total` how many there were in all.
class Error : public std::exception {
public:
  static constexpr std::size_t kMaxListed = 4096;

  Error(vbm_status status, std::string message) : status(status), message(std::move(message)) {}
  Error(vbm_status status, std::string message, const char *kind, std::vector<int64_t> elements,
        std::size_t total)
      : status(status), message(std::move(message)), kind(kind), elements(std::move(elements)),
        total(total) {}

  const char *what() const noexcept override { return message.c_str(); }

  vbm_status status;
  std::string message;
  const char *kind = "";
  std::vector<int64_t> elements;
  std::size_t total = 0;
};

} // namespace vbm::impl
