// SPDX-License-Identifier: GPL-3.0-or-later
// Collision spheres for robots: the Unified Robot Description Format, https://wiki.ros.org/urdf/XML
#include "files/formats.h"
#include "files/text.h"

namespace vbm::files {
namespace {

std::string escaped(const std::string &text) {
  std::string out;
  for (char c : text) switch (c) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    default:
      out += static_cast<unsigned char>(c) < 32 ? '_' : c; // XML allows no control characters
    }
  return out;
}

} // namespace

std::string write_urdf(const BallFile &balls, const std::string &name) {
  if (!balls.triangles.empty() || !balls.edges.empty())
    throw BadFile("a URDF file holds balls only, no triangles or edges: use .ply or .ma");
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<robot name=\"" + escaped(name) +
                    "\">\n  <link name=\"" + escaped(name) + "\">\n";
  for (std::size_t i = 0; i < balls.radii.size(); ++i) {
    if (!(balls.radii[i] > 0)) continue; // a point collides with nothing, and simulators refuse it
    out += "    <collision>\n      <origin xyz=\"";
    for (std::size_t a = 0; a < 3; ++a) {
      if (a) out += " ";
      append_number(out, balls.centers[3 * i + a]);
    }
    out += "\" rpy=\"0 0 0\"/>\n      <geometry><sphere radius=\"";
    append_number(out, balls.radii[i]);
    out += "\"/></geometry>\n    </collision>\n";
  }
  return out + "  </link>\n</robot>\n";
}

} // namespace vbm::files
