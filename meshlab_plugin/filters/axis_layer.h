// SPDX-License-Identifier: GPL-3.0-or-later
// A medial axis, as a layer.
#pragma once

#include "layer.h"
#include "text.h"

#include <vbm/vbm.hpp>

#include <string>
#include <vector>

namespace vbm_filters {

// Vertices are balls, with their radii as radius and quality; faces have the colour of their part,
// and its number as quality. Hosts have no edges: of curves
// only the vertices show.
NewLayer axis_layer(const vbm::Axis &axis, std::string name);

// What it is, and which parts cannot go, a sentence each.
void describe(const vbm::Axis &axis, std::vector<std::string> &log);

// How many triangles, curve edges and components a report tells of, after what it is.
template <class Report>
void describe_simplices(std::string what, const Report &report, std::vector<std::string> &log) {
  what += count(report.triangles, "triangle", "triangles") + ", ";
  if (report.curve_edges) what += count(report.curve_edges, "curve edge", "curve edges") + ", ";
  log.push_back(what + count(report.components, "component", "components") +
                ", Euler characteristic " + std::to_string(report.euler) + ".");
  if (report.curve_edges)
    log.push_back("MeshLab's layers have no edges: curves show as their vertices only, the balls.");
}

// The name of the layer that an axis layer was made from.
std::string without_axis(const std::string &name);

} // namespace vbm_filters
