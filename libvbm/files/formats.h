// SPDX-License-Identifier: GPL-3.0-or-later
// The formats behind ball_file.h. Readers throw BadFile without the file's name.
#pragma once

#include "files/ball_file.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace vbm::files {

/// Throw BadFile if the beginning of a file of `total` bytes already shows that it is none of
/// these: before the rest is read.
void check_ply_head(std::string_view head, uint64_t total);
void check_ma_head(std::string_view head, uint64_t total);
void check_csv_head(std::string_view head, uint64_t total);

BallFile read_ply(const std::string &bytes);
BallFile read_csv(const std::string &bytes);
BallFile read_ma(const std::string &bytes);

std::string write_ply(const BallFile &balls);
std::string write_csv(const BallFile &balls);
std::string write_ma(const BallFile &balls);
std::string write_urdf(const BallFile &balls, const std::string &name);

} // namespace vbm::files
