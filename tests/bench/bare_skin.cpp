// SPDX-License-Identifier: GPL-3.0-or-later
#include "bare_skin.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Skin_surface_3.h>
#include <CGAL/Skin_surface_polyhedral_items_3.h>
#include <CGAL/Skin_surface_traits_3.h>
#include <CGAL/mesh_skin_surface_3.h>

#include <functional>
#include <numeric>

namespace bench {

SkinSize bare_skin(const std::vector<double> &centers, const std::vector<double> &radii,
                   double shrink) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Traits = CGAL::Skin_surface_traits_3<Kernel>;
  using Skin = CGAL::Skin_surface_3<Traits>;
  using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Skin_surface_polyhedral_items_3<Skin>>;
  std::vector<Kernel::Weighted_point_3> balls;
  for (std::size_t i = 0; i < radii.size(); ++i)
    balls.emplace_back(Kernel::Point_3(centers[3 * i], centers[3 * i + 1], centers[3 * i + 2]),
                       radii[i] * radii[i]);
  Skin skin(balls.begin(), balls.end(), shrink);
  Polyhedron mesh;
  CGAL::mesh_skin_surface_3(skin, mesh);

  SkinSize size{mesh.size_of_vertices(), mesh.size_of_facets(), 0};
  std::size_t number = 0;
  std::vector<std::size_t> parent(size.vertices);
  std::iota(parent.begin(), parent.end(), 0);
  const std::function<std::size_t(std::size_t)> find = [&](std::size_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  CGAL::Unique_hash_map<Polyhedron::Vertex_const_handle, std::size_t> index;
  for (auto v = mesh.vertices_begin(); v != mesh.vertices_end(); ++v) index[v] = number++;
  for (auto h = mesh.halfedges_begin(); h != mesh.halfedges_end(); ++h)
    parent[find(index[h->vertex()])] = find(index[h->opposite()->vertex()]);
  for (std::size_t v = 0; v < size.vertices; ++v) size.components += find(v) == v;
  return size;
}

} // namespace bench
