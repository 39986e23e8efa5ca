// SPDX-License-Identifier: GPL-3.0-or-later
#include "medial/axis_views.h"

#include "core/progress.h"
#include "medial/cell_lists.h"

#include <algorithm>

namespace vbm::impl {
namespace {

void add(std::vector<double> &out, const Vec3 &p) { out.insert(out.end(), {p.x, p.y, p.z}); }

void fill_positions(Axis &axis) {
  for (std::size_t p = 0; p < axis.parts.list.size(); ++p) {
    const Vec3 at = axis.model->samples.frame.to_input(axis.parts.middle[p]);
    for (int a = 0; a < 3; ++a) axis.parts.list[p].position[a] = at[a];
  }
}

void fill_cells(Axis &axis, const TopologyGraph &graph, std::size_t pieces, Progress &progress) {
  const AxisCells &cells = *axis.cells;
  const AxisParts &parts = axis.parts;
  const Frame &frame = axis.model->samples.frame;
  const auto left = [](const std::vector<uint8_t> &state) {
    return std::size_t(std::count(state.begin(), state.end(), 1));
  };
  axis.report.vertices = left(axis.state.vertex);
  axis.report.edges = left(axis.state.edge);
  axis.report.triangles = left(axis.state.triangle);
  axis.report.components = pieces;
  std::vector<int32_t> number(cells.ball.size(), -1);
  axis.vertices.reserve(3 * axis.report.vertices);
  axis.radii.reserve(axis.report.vertices);
  for (std::size_t v = 0; v < cells.ball.size(); ++v) {
    progress.tick(0, 1);
    if (!axis.state.vertex[v]) continue;
    number[v] = int32_t(axis.radii.size());
    add(axis.vertices, frame.to_input(cells.ball[v].center));
    axis.radii.push_back(frame.length_to_input(cells.ball[v].radius));
    axis.report.volume += cells.volume[v];
    axis.report.components += parts.of_vertex[v] == AxisParts::kNothing; // a vertex alone
  }
  axis.triangles.reserve(3 * axis.report.triangles);
  axis.triangle_samples.reserve(2 * axis.report.triangles);
  axis.triangle_part.reserve(axis.report.triangles);
  axis.triangle_width.reserve(axis.report.triangles);
  axis.triangle_angle.reserve(axis.report.triangles);
  for (std::size_t t = 0; t < cells.triangle.size(); ++t) {
    progress.tick(0, 1);
    if (!axis.state.triangle[t]) continue;
    for (int32_t v : cells.triangle[t]) axis.triangles.push_back(number[v]);
    for (int32_t s : cells.triangle_samples[t]) axis.triangle_samples.push_back(s);
    axis.triangle_part.push_back(parts.of_triangle[t]);
    axis.triangle_width.push_back(cells.width[t] * cells.unit);
    axis.triangle_angle.push_back(triangle_angle(cells, t));
  }
  std::vector<int32_t> curves = parts.curve_edges.index;
  std::sort(curves.begin(), curves.end());
  for (int32_t e : curves) {
    for (int32_t v : cells.edge[e]) axis.curves.push_back(number[v]);
    axis.curve_part.push_back(parts.of_edge[e]);
    axis.curve_width.push_back(cells.curve_width[e] * cells.unit);
    axis.curve_angle.push_back(curve_angle(cells, e));
  }
  for (int32_t e : graph.contact_edge)
    for (int32_t v : cells.edge[e]) axis.contact_edges.push_back(number[v]);
  axis.contact_node = graph.contact_node;
  axis.report.curve_edges = curves.size();
  axis.report.parts = parts.list.size();
  axis.report.euler =
      int64_t(axis.report.vertices) - int64_t(axis.report.edges) + int64_t(axis.report.triangles);
}

void fill_points(Axis &axis, Progress &progress) {
  const AxisCells &cells = *axis.cells;
  const Samples &samples = axis.model->samples;
  axis.triangle_points.reserve(6 * axis.report.triangles);
  for (std::size_t t = 0; t < cells.triangle.size(); ++t) {
    progress.tick(0, 1);
    if (!axis.state.triangle[t]) continue;
    for (std::size_t i = 0; i < 2; ++i)
      add(axis.triangle_points, cells.triangle_points.empty()
                                    ? samples.input_position[cells.triangle_samples[t][i]]
                                    : samples.frame.to_input(cells.triangle_points[t][i]));
  }
}

void fill_balls(Axis &axis) {
  const std::vector<int32_t> &vertex = axis.cells->vertex_of_ball;
  axis.kept = kept_balls(*axis.cells, axis.state);
  for (std::size_t b = 0; b < vertex.size();
       ++b) { // whole twigs that went while their vertex is left
    const Twig &twig = axis.cells->twigs[b];
    const bool whole = !axis.state.twig[b] && (twig.below < 0 || axis.state.twig[twig.below]);
    if (whole && axis.state.vertex[vertex[b]]) axis.report.volume -= twig.volume;
  }
  axis.part_balls =
      lists_of(axis.parts.list.size(), vertex.size(), [&](std::size_t b, auto &&call) {
        if (vertex[b] >= 0 && axis.parts.of_vertex[vertex[b]] >= 0)
          call(axis.parts.of_vertex[vertex[b]]);
      });
}

} // namespace

void fill_views(Axis &axis, const TopologyGraph &graph, std::size_t pieces, Progress &progress) {
  axis.report.struct_size = sizeof axis.report;
  fill_positions(axis);
  fill_cells(axis, graph, pieces, progress);
  fill_points(axis, progress);
  fill_balls(axis);
  for (const Vec3 &p : graph.node) add(axis.nodes, axis.model->samples.frame.to_input(p));
  axis.part_nodes = graph.part_nodes;
}

} // namespace vbm::impl
