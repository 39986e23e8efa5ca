// SPDX-License-Identifier: GPL-3.0-or-later
// The medial axis as a simplicial complex.
#pragma once

#include "medial/twigs.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

/// Vertices, edges and triangles, no two alike, and every edge of a triangle among the edges: a
/// simplicial complex of the solid's homotopy type. Which of them are left after pruning is an
/// AxisState's.
struct AxisCells {
  std::vector<Ball> ball;                               // per vertex, unit frame
  std::vector<std::array<int32_t, 2>> edge;             // vertices, ascending
  std::vector<std::array<int32_t, 3>> triangle;         // vertices
  std::vector<std::array<int32_t, 3>> triangle_edges;   // edge i joins corners i and i + 1
  std::vector<std::array<int32_t, 2>> triangle_samples; // it is equidistant from
  std::vector<std::array<Vec3, 2>> triangle_points; // it is exactly equidistant from; none: samples
  std::vector<uint8_t> seam; // per edge: parts end there, even where only two triangles are left
  Incidence edge_triangles, vertex_edges;
  std::vector<double> width;           // per triangle: distance of its samples
  std::vector<double> curve_width;     // per edge: of no triangle, the smallest distance of two of
                                       // the three samples it is equidistant from; else 0
  std::vector<double> volume;          // per vertex: share of the solid's tetrahedra drawn into it
  std::vector<int32_t> vertex_of_ball; // per inner ball of the model
  std::vector<Twig> twigs;             // the same
  ThinShare thin;                      // what is not resolved
  double unit = 1;                     // length of the unit frame's unit in the input
};

/// The angle in degrees under which two samples this far apart are seen from a ball they touch.
double object_angle(double width, double radius);

/// The same for the samples of a triangle, or of an edge of none; the ball is the mean of those at
/// its corners.
double triangle_angle(const AxisCells &cells, std::size_t triangle);
double curve_angle(const AxisCells &cells, std::size_t edge);

AxisCells axis_cells(const DualComplex &complex, const Collapsed &left, const Model &model,
                     Progress &progress);

} // namespace vbm::impl
