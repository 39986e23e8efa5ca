// SPDX-License-Identifier: GPL-3.0-or-later
// The bad inputs that nasty/make_nasty.py writes beside the repository.
#pragma once

#include <string>
#include <vector>

/// Where they are, written if need be; "" if there is no script to write them.
const std::string &nasty_folder();

/// All files of that index whose path begins with `prefix`.
std::vector<std::string> nasty_index(const std::string &prefix);
