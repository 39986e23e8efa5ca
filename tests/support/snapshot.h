// SPDX-License-Identifier: GPL-3.0-or-later
// Everything a handle shows, as bytes: two results are the same if and only if these are.
#pragma once

#include <vbm/vbm.h>

#include <string>

std::string snapshot(const vbm_model *model);
std::string snapshot(const vbm_surface *surface);
std::string snapshot(const vbm_axis *axis);
