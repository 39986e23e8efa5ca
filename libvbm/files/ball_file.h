// SPDX-License-Identifier: GPL-3.0-or-later
// Balls in files: read and written whole, the same in every locale, exact to the last bit.
//
//   .ply   vertices x y z radius, faces and edges if there are any, part and level if there are;
//          read in all three formats, written in binary (little-endian)
//   .csv   x,y,z,radius; a header line is optional when reading
//   .ma    a medial mesh as Q-MAT and its family exchange it: nv ne nf; v x y z r; e i j; f i j k.
//   The sides of
//          faces that are not among the edges are written after them, as its readers expect
//   .urdf  written only: one link whose collision shapes are the balls; those of radius 0 are left
//   out
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace vbm::files {

struct BallFile {
  std::vector<double> centers;                            // n x 3
  std::vector<double> radii;                              // n
  std::vector<int32_t> triangles;                         // m x 3 balls
  std::vector<int32_t> edges;                             // k x 2 balls
  std::map<std::string, std::vector<int32_t>> attributes; // "part", "level": n each
};

/// The file's content is wrong, or it cannot hold the balls: one sentence that names the file and
/// the line or byte.
struct BadFile : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The system refuses: `code` is its errno.
struct NoFile : std::runtime_error {
  NoFile(int code, std::filesystem::path path);
  int code;
  std::filesystem::path path;
};

/// By the name's extension. Headers are checked, and counts in them against the file's size, before
/// the rest of the file is read or anything is allocated by them. Throw BadFile, NoFile,
/// std::bad_alloc.
BallFile read_balls(const std::filesystem::path &path);

/// By the name's extension. The file is complete or as it was before: it is written beside and
/// renamed.
void write_balls(const std::filesystem::path &path, const BallFile &balls);

/// From memory, for tests: `extension` is ".ply", ".csv" or ".ma".
BallFile parse_balls(const std::string &bytes, const std::string &extension);
std::string format_balls(const BallFile &balls, const std::string &extension,
                         const std::string &name = "balls");

} // namespace vbm::files
