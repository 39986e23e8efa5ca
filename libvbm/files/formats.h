// SPDX-License-Identifier: GPL-3.0-or-later
// The formats behind ball_file.h. Readers throw BadFile without the file's name.
#pragma once

#include "files/ball_file.h"

#include <string>

namespace vbm::files {

BallFile read_ply(const std::string &bytes);
BallFile read_csv(const std::string &bytes);
BallFile read_ma(const std::string &bytes);

std::string write_ply(const BallFile &balls);
std::string write_csv(const BallFile &balls);
std::string write_ma(const BallFile &balls);
std::string write_urdf(const BallFile &balls, const std::string &name);

} // namespace vbm::files
