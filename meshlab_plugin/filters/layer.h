// SPDX-License-Identifier: GPL-3.0-or-later
// What a filter reads and what it leaves, as plain arrays: nothing here knows MeshLab.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace vbm_filters {

struct Color {
  std::uint8_t r = 255, g = 255, b = 255, a = 255;
};

// The layer a filter is applied to, copied out of the host before anything else happens.
struct Layer {
  std::string name;                    // without a file's suffix
  std::vector<double> points;          // 3 per vertex
  std::vector<double> normals;         // 3 per vertex, or empty
  std::vector<std::int32_t> triangles; // 3 vertex indices each; empty for a point cloud
  std::vector<Color> colors;           // per vertex, or empty
  std::vector<double> radius;          // per vertex, or empty
  std::vector<std::uint8_t> selected_vertices, selected_triangles; // one each: 1 if selected
  bool transformed = false;                                        // its matrix is not the identity
  bool renumbered = false; // deleted vertices were left out of the numbering

  std::size_t vertex_count() const { return points.size() / 3; }
};

// Values from `low` (red) to `high` (blue) of a colour ramp.
struct Ramp {
  bool wanted = false;
  double low = 0, high = 0;
};

// A layer that the host is to add.
struct NewLayer {
  std::string name;
  std::vector<double> points;           // 3 per vertex
  std::vector<std::int32_t> triangles;  // may be empty
  std::vector<std::uint8_t> inner_edge; // per corner: 1 if the edge from it is inside a polygon
  std::vector<double> radius, quality;  // per vertex
  std::vector<std::uint8_t> selected;   // per vertex, 1 if it is to be selected; or empty
  std::vector<Color> colors;            // per vertex, or empty
  std::vector<Color> triangle_colors;   // per triangle, or empty
  std::vector<double> triangle_quality; // per triangle, or empty
  bool hide_source = false;             // hide the layer it was made from: it would cover this one
  Ramp ramp;                            // used if there are no colours
};

// Values for the vertices of the layer that the filter was applied to.
struct VertexValues {
  std::vector<double> quality; // per vertex; NaN where there is none
  std::vector<double> radius;  // the same, or empty
  std::vector<Color> colors;   // per vertex, or empty
  Ramp ramp;                   // used if there are no colours
};

struct Outcome {
  std::vector<NewLayer> layers;     // the last one is the host's current layer then
  std::vector<VertexValues> values; // at most one
  // The vertices of the layer that the filter was applied to: 1 for those that are to be selected,
  // alone. Empty: what is selected stays.
  std::vector<std::uint8_t> selected;
  std::vector<std::string> log;           // sentences for the user
  std::map<std::string, double> measures; // numbers for scripts, by name
};

// Why a filter did nothing. The message is one sentence for the user.
class Failure : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

} // namespace vbm_filters
