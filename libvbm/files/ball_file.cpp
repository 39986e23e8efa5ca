// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/ball_file.h"

#include "files/bytes.h"
#include "files/formats.h"

#include <cmath>
#include <limits>

namespace vbm::files {
namespace {

std::string extension_of(const std::filesystem::path &path) {
  std::string extension = path.extension().u8string();
  for (char &c : extension)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return extension;
}

std::string named(const std::filesystem::path &path, const std::exception &error) {
  return path.filename().u8string() + ": " + error.what();
}

void check(const BallFile &b) {
  const std::size_t n = b.radii.size();
  if (b.centers.size() != 3 * n)
    throw BadFile(std::to_string(b.centers.size() / 3) + " centres, but " + std::to_string(n) +
                  " radii");
  if (n > std::size_t(std::numeric_limits<int32_t>::max()))
    throw BadFile(std::to_string(n) + " balls are more than indices can name");
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t a = 0; a < 3; ++a)
      if (!std::isfinite(b.centers[3 * i + a]))
        throw BadFile("ball " + std::to_string(i) + " has a centre that is not finite");
    if (!(std::isfinite(b.radii[i]) && b.radii[i] >= 0))
      throw BadFile("ball " + std::to_string(i) + " has a radius that is " +
                    (b.radii[i] < 0 ? "negative" : "not finite"));
  }
  const auto indices = [&](const std::vector<int32_t> &list, std::size_t width, const char *what) {
    for (std::size_t i = 0; i < list.size(); ++i)
      if (list[i] < 0 || std::size_t(list[i]) >= n)
        throw BadFile(std::string(what) + " " + std::to_string(i / width) + " names ball " +
                      std::to_string(list[i]) + ", but there are " + std::to_string(n));
  };
  indices(b.triangles, 3, "triangle");
  indices(b.edges, 2, "edge");
  for (const auto &[name, values] : b.attributes) {
    if (name != "part" && name != "level")
      throw BadFile("there is no attribute \"" + name + "\": part and level are kept");
    if (values.size() != n)
      throw BadFile("attribute " + name + " has " + std::to_string(values.size()) + " values for " +
                    std::to_string(n) + " balls");
  }
}

} // namespace

BallFile parse_balls(const std::string &bytes, const std::string &extension) {
  if (extension == ".ply") return read_ply(bytes);
  if (extension == ".csv") return read_csv(bytes);
  if (extension == ".ma") return read_ma(bytes);
  throw BadFile("balls are read from .ply, .csv and .ma files, by the name's extension");
}

std::string format_balls(const BallFile &balls, const std::string &extension,
                         const std::string &name) {
  check(balls);
  const bool plain = balls.attributes.empty();
  if (extension == ".ply") return write_ply(balls);
  if (extension == ".csv") return write_csv(balls);
  if (extension == ".ma" && plain) return write_ma(balls);
  if (extension == ".urdf" && plain) return write_urdf(balls, name);
  if (extension == ".ma" || extension == ".urdf")
    throw BadFile("a " + extension + " file holds no part or level: use .ply or .csv");
  throw BadFile("balls are written to .ply, .csv, .ma and .urdf files, by the name's extension");
}

BallFile read_balls(const std::filesystem::path &path) {
  try {
    const std::string extension = extension_of(path);
    if (extension != ".ply" && extension != ".csv" && extension != ".ma")
      return parse_balls({}, extension); // says which there are
    const auto check_head = [&](std::string_view head, uint64_t size) {
      if (extension == ".ply") check_ply_head(head, size);
      if (extension == ".ma") check_ma_head(head, size);
      if (extension == ".csv") check_csv_head(head, size);
    };
    return parse_balls(read_bytes(path, check_head), extension);
  } catch (const BadFile &error) {
    throw BadFile(named(path, error));
  }
}

void write_balls(const std::filesystem::path &path, const BallFile &balls) {
  std::string bytes;
  try {
    bytes = format_balls(balls, extension_of(path), path.stem().u8string());
  } catch (const BadFile &error) {
    throw BadFile(named(path, error));
  }
  write_bytes(path, bytes);
}

} // namespace vbm::files
