// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences about parts that cannot go.
#pragma once

#include <vbm/vbm.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vbm::impl {

/// "the shape would fall apart"; "" for what is no lock. Every host says it in these words.
const char *lock_text(int32_t lock);

/// A line for every reason, with the first few parts it keeps: "3 parts below the threshold stay:
/// the shape would fall apart (2, 5, 9)".
std::string stayed_text(const std::vector<int32_t> &parts, const std::vector<int32_t> &locks);

} // namespace vbm::impl
