// SPDX-License-Identifier: GPL-3.0-or-later
// A small strict reader of point and mesh files: all of a file or an error with its line. It does
// not look at the locale.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

struct Geometry {
  std::vector<double> points;
  std::vector<uint32_t> sizes; // corners of every face
  std::vector<int32_t> corners;

  std::size_t size() const { return points.size() / 3; }
};

/// Reads .xyz, .off and .obj (vertices and faces). Throws std::runtime_error "line 7: ...".
Geometry read_geometry(const std::string &path);
