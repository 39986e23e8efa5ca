// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_mesh.h"

#include <vbm/vbm.hpp>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <functional>
#include <vector>

namespace {

using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;

void check(std::size_t vertices, std::size_t faces, int64_t euler,
           const std::function<vbm::View<int32_t>(std::size_t)> &face, const char *what,
           Problems &problems) {
  Mesh mesh;
  std::vector<Mesh::VertexHandle> handle(vertices), corners;
  for (auto &v : handle) v = mesh.add_vertex({0, 0, 0});
  for (std::size_t f = 0; f < faces; ++f) {
    corners.clear();
    const auto ring = face(f);
    for (std::size_t i = 0; i < ring.size; ++i) corners.push_back(handle[std::size_t(ring[i])]);
    if (!mesh.add_face(corners).is_valid())
      problems.add(std::string("OpenMesh refuses ") + what + " " + std::to_string(f));
  }
  for (const auto &h : mesh.halfedges())
    if (mesh.is_boundary(h)) return problems.add(std::string("OpenMesh finds a boundary: ") + what);
  for (const auto &v : mesh.vertices())
    if (!mesh.is_manifold(v))
      return problems.add(std::string("OpenMesh finds a vertex not manifold: ") + what);
  const int64_t counted =
      int64_t(mesh.n_vertices()) - int64_t(mesh.n_edges()) + int64_t(mesh.n_faces());
  problems.require(counted == euler, "OpenMesh counts another Euler characteristic",
                   std::size_t(faces));
}

} // namespace

void open_mesh_check(const vbm_surface *surface, Problems &problems) {
  size_t vertices = 0, triangles = 0, corners = 0;
  vbm_surface_report report{};
  report.struct_size = sizeof report;
  vbm_surface_get_report(surface, &report);
  vbm_surface_vertices(surface, &vertices);
  const int32_t *triangle = vbm_surface_triangles(surface, &triangles);
  check(
      vertices, triangles, report.euler,
      [&](std::size_t t) {
        return vbm::View<int32_t>{triangle + 3 * t, 3};
      },
      "triangle", problems);
  const uint64_t *offsets = nullptr;
  const int32_t *index = vbm_surface_polygons(surface, &offsets, &corners);
  check(
      vertices, report.polygons, report.euler,
      [&](std::size_t p) {
        return vbm::View<int32_t>{index + offsets[p], std::size_t(offsets[p + 1] - offsets[p])};
      },
      "polygon", problems);
}
