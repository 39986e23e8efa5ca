// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/formats.h"

#include <cstring>

namespace vbm::files {
namespace {

/// Little-endian on every machine.
template <class T> void append(std::string &out, T value) {
  unsigned char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  const uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  for (std::size_t i = 0; i < sizeof value; ++i)
    out += char(bytes[first ? i : sizeof value - 1 - i]);
}

} // namespace

std::string write_ply(const BallFile &balls) {
  std::string out = "ply\nformat binary_little_endian 1.0\ncomment balls\nelement vertex " +
                    std::to_string(balls.radii.size()) + "\n";
  for (const char *name : {"x", "y", "z", "radius"})
    out += std::string("property double ") + name + "\n";
  for (const auto &attribute : balls.attributes) out += "property int " + attribute.first + "\n";
  if (!balls.triangles.empty())
    out += "element face " + std::to_string(balls.triangles.size() / 3) +
           "\nproperty list uchar int vertex_indices\n";
  if (!balls.edges.empty())
    out += "element edge " + std::to_string(balls.edges.size() / 2) +
           "\nproperty int vertex1\nproperty int vertex2\n";
  out += "end_header\n";
  for (std::size_t i = 0; i < balls.radii.size(); ++i) {
    for (std::size_t a = 0; a < 3; ++a) append(out, balls.centers[3 * i + a]);
    append(out, balls.radii[i]);
    for (const auto &attribute : balls.attributes) append(out, attribute.second[i]);
  }
  for (std::size_t i = 0; i < balls.triangles.size(); ++i) {
    if (i % 3 == 0) append(out, uint8_t(3));
    append(out, balls.triangles[i]);
  }
  for (int32_t end : balls.edges) append(out, end);
  return out;
}

} // namespace vbm::files
