// SPDX-License-Identifier: GPL-3.0-or-later
#include "medial/axis_views.h"

#include "core/disjoint_sets.h"
#include "core/progress.h"
#include "medial/cell_lists.h"
#include "medial/topology_graph.h"

#include <algorithm>

namespace vbm::impl {
namespace {

void add(std::vector<double> &out, const Vec3 &p) { out.insert(out.end(), {p.x, p.y, p.z}); }

/// The middle of every part: of its triangles by area, of its curves by length.
void fill_positions(Axis &axis) {
  const AxisCells &cells = *axis.cells;
  const Frame &frame = axis.model->samples.frame;
  const std::size_t count = axis.parts.list.size();
  std::vector<Vec3> sum(count), plain(count);
  std::vector<double> weight(count, 0), number(count, 0);
  const auto enter = [&](int32_t part, const Vec3 &middle, double size) {
    sum[part] += middle * size;
    weight[part] += size;
    plain[part] += middle;
    ++number[part];
  };
  for (std::size_t t = 0; t < cells.triangle.size(); ++t) {
    if (!axis.state.triangle[t]) continue;
    const auto &v = cells.triangle[t];
    const Vec3 &a = cells.ball[v[0]].center, &b = cells.ball[v[1]].center,
               &c = cells.ball[v[2]].center;
    enter(axis.parts.of_triangle[t], (a + b + c) * (1.0 / 3), length(cross(b - a, c - a)));
  }
  for (std::size_t e = 0; e < cells.edge.size(); ++e) {
    if (axis.parts.of_edge[e] < 0) continue;
    const Vec3 &a = cells.ball[cells.edge[e][0]].center, &b = cells.ball[cells.edge[e][1]].center;
    enter(axis.parts.of_edge[e], (a + b) * 0.5, distance(a, b));
  }
  for (std::size_t p = 0; p < count; ++p) {
    const Vec3 at =
        frame.to_input(weight[p] > 0 ? sum[p] * (1 / weight[p]) : plain[p] * (1 / number[p]));
    for (int a = 0; a < 3; ++a) axis.parts.list[p].position[a] = at[a];
  }
}

void fill_cells(Axis &axis, Progress &progress) {
  const AxisCells &cells = *axis.cells;
  const Frame &frame = axis.model->samples.frame;
  std::vector<int32_t> number(cells.ball.size(), -1);
  for (std::size_t v = 0; v < cells.ball.size(); ++v) {
    progress.tick(0, 1);
    if (!axis.state.vertex[v]) continue;
    number[v] = int32_t(axis.radii.size());
    add(axis.vertices, frame.to_input(cells.ball[v].center));
    axis.radii.push_back(frame.length_to_input(cells.ball[v].radius));
    axis.report.volume += cells.volume[v];
  }
  for (std::size_t t = 0; t < cells.triangle.size(); ++t) {
    progress.tick(0, 1);
    if (!axis.state.triangle[t]) continue;
    for (int32_t v : cells.triangle[t]) axis.triangles.push_back(number[v]);
    for (int32_t s : cells.triangle_samples[t]) axis.triangle_samples.push_back(s);
    axis.triangle_part.push_back(axis.parts.of_triangle[t]);
  }
  DisjointSets sets(axis.radii.size());
  axis.report.components = axis.radii.size();
  for (std::size_t e = 0; e < cells.edge.size(); ++e) {
    progress.tick(0, 1);
    if (!axis.state.edge[e]) continue;
    const int32_t a = number[cells.edge[e][0]], b = number[cells.edge[e][1]];
    ++axis.report.edges;
    axis.report.components -= sets.unite(a, b);
    if (axis.parts.of_edge[e] < 0) continue;
    axis.curves.insert(axis.curves.end(), {a, b});
    axis.curve_part.push_back(axis.parts.of_edge[e]);
  }
  axis.report.vertices = axis.radii.size();
  axis.report.triangles = axis.triangle_part.size();
  axis.report.curve_edges = axis.curve_part.size();
  axis.report.parts = axis.parts.list.size();
  axis.report.euler =
      int64_t(axis.report.vertices) - int64_t(axis.report.edges) + int64_t(axis.report.triangles);
}

void fill_balls(Axis &axis) {
  const std::vector<int32_t> &vertex = axis.cells->vertex_of_ball;
  axis.kept.resize(vertex.size());
  for (std::size_t b = 0; b < vertex.size(); ++b)
    axis.kept[b] = vertex[b] < 0 || axis.state.vertex[vertex[b]];
  axis.part_balls =
      lists_of(axis.parts.list.size(), vertex.size(), [&](std::size_t b, auto &&call) {
        if (vertex[b] >= 0 && axis.parts.of_vertex[vertex[b]] >= 0)
          call(axis.parts.of_vertex[vertex[b]]);
      });
}

} // namespace

void fill_views(Axis &axis, Progress &progress) {
  axis.report.struct_size = sizeof axis.report;
  fill_positions(axis);
  fill_cells(axis, progress);
  fill_balls(axis);
  TopologyGraph graph = topology_graph(*axis.cells, axis.state, axis.parts);
  for (const Vec3 &p : graph.node) add(axis.nodes, axis.model->samples.frame.to_input(p));
  axis.part_nodes = std::move(graph.part_nodes);
}

} // namespace vbm::impl
