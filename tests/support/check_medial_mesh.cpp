// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_medial_mesh.h"

#include "check_axis.h"
#include "snapshot.h"

#include <vbm/medial_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace {

using Pair = std::array<int32_t, 2>;

template <std::size_t N> bool unique(std::vector<std::array<int32_t, N>> &rows) {
  std::sort(rows.begin(), rows.end());
  return std::adjacent_find(rows.begin(), rows.end()) == rows.end();
}

/// Rows with their corners ascending; those with a corner that is not there are problems.
template <std::size_t N>
std::vector<std::array<int32_t, N>> rows(const int32_t *data, size_t count, size_t vertices,
                                         Problems &problems) {
  std::vector<std::array<int32_t, N>> out(count);
  for (size_t i = 0; i < count; ++i) {
    std::copy_n(data + N * i, N, out[i].begin());
    std::sort(out[i].begin(), out[i].end());
    problems.require(out[i][0] >= 0 && size_t(out[i][N - 1]) < vertices, "no such vertex", i);
    for (std::size_t k = 1; k < N; ++k)
      problems.require(out[i][k - 1] != out[i][k], "a corner twice", i);
  }
  return out;
}

Problems check_mesh(const vbm_medial_mesh *mesh, int64_t euler, uint64_t components,
                    std::string *bytes) {
  Problems problems;
  vbm_medial_mesh_report report;
  report.struct_size = sizeof report;
  if (vbm_medial_mesh_get_report(mesh, &report) != VBM_OK) problems.add("no report");
  size_t vertices = 0, radii = 0, triangles = 0, curves = 0;
  const double *at = vbm_medial_mesh_vertices(mesh, &vertices);
  const double *radius = vbm_medial_mesh_radii(mesh, &radii);
  const int32_t *corners = vbm_medial_mesh_triangles(mesh, &triangles);
  const int32_t *ends = vbm_medial_mesh_edges(mesh, &curves);
  problems.require(vertices > 0 && radii == vertices && report.vertices == vertices &&
                       report.triangles == triangles && report.curve_edges == curves,
                   "sizes of views and report differ");
  for (size_t i = 0; i < 3 * vertices; ++i)
    problems.require(std::isfinite(at[i]), "a vertex is not finite", i / 3);
  for (size_t v = 0; v < radii; ++v)
    problems.require(std::isfinite(radius[v]) && radius[v] >= 0, "no radius", v);
  for (double error : {report.error_max, report.error_mean})
    problems.require(std::isfinite(error) && error >= 0, "no error");
  auto faces = rows<3>(corners, triangles, vertices, problems);
  auto edges = rows<2>(ends, curves, vertices, problems);
  if (!problems.none()) return problems;
  problems.require(unique(faces), "a triangle is there twice");
  std::vector<Pair> sides;
  for (const auto &[a, b, c] : faces) sides.insert(sides.end(), {{a, b}, {b, c}, {a, c}});
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  edges.insert(edges.end(), sides.begin(), sides.end());
  problems.require(unique(edges), "an edge is there twice");
  std::vector<int32_t> parent(vertices);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  uint64_t pieces = vertices;
  for (const auto &[a, b] : edges) {
    const int32_t i = root(a), j = root(b);
    pieces -= i != j;
    parent[std::max(i, j)] = std::min(i, j);
  }
  const int64_t counted = int64_t(vertices) - int64_t(edges.size()) + int64_t(triangles);
  problems.require(report.edges == edges.size() && report.euler == counted &&
                       report.components == pieces,
                   "the report is not what is there");
  problems.require(counted == euler && pieces == components, "the topology is not the solid's");
  if (bytes) {
    bytes->append(reinterpret_cast<const char *>(at), 3 * vertices * sizeof *at);
    bytes->append(reinterpret_cast<const char *>(radius), radii * sizeof *radius);
    bytes->append(reinterpret_cast<const char *>(corners), 3 * triangles * sizeof *corners);
    bytes->append(reinterpret_cast<const char *>(ends), 2 * curves * sizeof *ends);
  }
  return problems;
}

} // namespace

Problems exercise_derived(vbm_context *context, const vbm_model *model, const vbm_axis *axis,
                          int64_t euler, uint64_t components, std::string *bytes) {
  Problems problems;
  const auto found = [&](const char *what, const Problems &wrong) {
    if (!wrong.none()) problems.add(std::string(what) + ":\n" + wrong.text());
  };
  const auto failed = [&](const char *what) {
    problems.add(std::string(what) + ": " + vbm_context_message(context));
  };
  vbm_simplify_options options;
  vbm_simplify_options_init(&options, sizeof options);
  options.count = 12;
  vbm_medial_mesh *mesh = nullptr;
  const vbm_status status = vbm_axis_simplify(context, axis, &options, &mesh);
  if (status == VBM_OK)
    found("axis of 12 balls", check_mesh(mesh, euler, components, bytes));
  else if (status != VBM_ERROR_ARGUMENT || mesh || // the topology may need more
           std::string(vbm_context_message(context)).find("topology") == std::string::npos)
    failed("axis of 12 balls");
  vbm_medial_mesh_free(mesh);
  if (vbm_axis_curve_skeleton(context, axis, nullptr, &mesh) == VBM_OK)
    found("curve skeleton", check_mesh(mesh, euler, components, bytes));
  else
    failed("curve skeleton");
  vbm_medial_mesh_free(mesh);
  vbm_axis_options other;
  vbm_axis_options_init(&other, sizeof other);
  other.method = VBM_AXIS_POWER_SHAPE;
  vbm_axis *made = nullptr;
  if (vbm_model_medial_axis(context, model, &other, &made) == VBM_OK) {
    found("axis of the power shape", check_axis(made, model, euler, components));
    if (bytes) *bytes += snapshot(made);
  } else {
    failed("axis of the power shape");
  }
  vbm_axis_free(made);
  return problems;
}
