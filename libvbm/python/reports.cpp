// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports.h"

#include "options.h"

#include <string>
#include <vector>

namespace vbm::python {

namespace {

// A field of a report: its name, its help, and how it is read.
template <class Report> struct Field {
  const char *name;
  const char *doc;
  py::object (*get)(const Report &);
};

template <class Report, auto Member> py::object number(const Report &report) {
  return py::cast(report.*Member);
}
#define VBM_FIELD(Report, member, doc)                                                             \
  { #member, doc, &number < Report, &Report::member> }

using M = vbm_model_report;
const Field<M> kModelFields[] = {
    {"rule", "How inside was told from outside: 'normals', 'propagation', 'voxels' or 'scan'.",
     [](const M &r) -> py::object { return py::str(enum_name("labels", r.rule)); }},
    {"flipped", "True: the mesh was inside out and was taken as upright.",
     [](const M &r) -> py::object { return py::bool_(r.flipped != 0); }},
    VBM_FIELD(M, input_points, "Vertices, points or voxels given."),
    VBM_FIELD(M, dropped, "Points left out: not finite, of no face, or inside other parts of a mesh."),
    VBM_FIELD(M, merged, "Points merged into an earlier one within 2e-11 of the whole's size."),
    VBM_FIELD(M, added, "Samples added on faces and edges."),
    VBM_FIELD(M, samples, "Samples in the Delaunay triangulation."),
    VBM_FIELD(M, cells, "Delaunay tetrahedra."),
    VBM_FIELD(M, inner_balls, "Inner balls."),
    VBM_FIELD(M, outer_balls, "Outer balls."),
    VBM_FIELD(M, exact_centers, "Centres that doubles could not give and exact numbers did."),
    VBM_FIELD(
        M, undersampled,
        "Samples where the sampling is too thin to trust the surface; Model.undersampled lists "
        "them."),
    VBM_FIELD(M, unused_samples, "Samples not on the interpolating surface."),
    VBM_FIELD(M, skipped_faces, "Faces with fewer than three different corners."),
    VBM_FIELD(M, open_loops, "Boundary loops of the mesh."),
    VBM_FIELD(M, inconsistent_edges,
              "Edges whose two faces contradict each other, or with three or more faces."),
    VBM_FIELD(M, spacing, "Spacing used on the mesh; 0 where no samples were added."),
    VBM_FIELD(M, diagonal, "Bounding-box diagonal of the samples."),
};

using S = vbm_surface_report;
const Field<S> kSurfaceFields[] = {
    VBM_FIELD(S, vertices, "Vertices."),
    VBM_FIELD(S, triangles, "Triangles."),
    VBM_FIELD(S, polygons, "Polygons."),
    VBM_FIELD(S, components,
              "Connected components of the surface; the wall of a cavity inside counts."),
    VBM_FIELD(S, euler, "Euler characteristic."),
    VBM_FIELD(S, genus, "Handles in all: components - euler / 2."),
    VBM_FIELD(S, split_vertices,
              "Vertices that stand where another stands, to keep the surface manifold."),
    VBM_FIELD(S, area, "Area of the triangles."),
    VBM_FIELD(S, volume, "Volume inside; positive."),
    VBM_FIELD(S, hidden_balls, "From balls: those that are covered by others, or points."),
    VBM_FIELD(S, singular_points, "From balls: where three spheres meet on the boundary."),
    VBM_FIELD(S, merged_points, "Singular points that became one with another."),
    VBM_FIELD(S, offset_points, "Singular points where three balls do not meet (thesis 8.3.5)."),
    VBM_FIELD(S, added_points, "From balls: vertices that are no singular points."),
    VBM_FIELD(S, gap_max, "From balls: largest distance of a triangle's middle from its sphere."),
    VBM_FIELD(S, gap_mean, "The same on average, by area."),
    VBM_FIELD(S, surface_error_max,
              "From balls, with errors=True: largest distance from the surface to the boundary\nof the "
              "balls' union."),
    VBM_FIELD(S, surface_error_mean, "The same on average, by area."),
    VBM_FIELD(S, union_error_max, "Largest distance from the union's boundary to the surface."),
    VBM_FIELD(S, union_error_mean, "The same on average, at points on the boundary."),
};

using A = vbm_axis_report;
const Field<A> kAxisFields[] = {
    VBM_FIELD(A, vertices, "Vertices."),
    VBM_FIELD(A, triangles, "Triangles."),
    VBM_FIELD(A, edges, "Edges, those of triangles too."),
    VBM_FIELD(A, curve_edges, "Edges of no triangle."),
    VBM_FIELD(A, parts, "Parts."),
    VBM_FIELD(A, components, "Connected pieces."),
    VBM_FIELD(A, euler, "Euler characteristic: vertices - edges + triangles."),
    VBM_FIELD(A, volume, "Share of the shape's volume that what is left stands for, 0 to 1."),
};

using N = vbm_medial_mesh_report;
const Field<N> kMedialMeshFields[] = {
    VBM_FIELD(N, vertices, "Vertices: balls."),
    VBM_FIELD(N, triangles, "Triangles."),
    VBM_FIELD(N, edges, "Edges, those of triangles too."),
    VBM_FIELD(N, curve_edges, "Edges of no triangle."),
    VBM_FIELD(N, components, "Connected pieces."),
    VBM_FIELD(N, euler, "Euler characteristic: vertices - edges + triangles."),
    VBM_FIELD(N, diagonal, "Bounding-box diagonal of the samples, which errors are shares of."),
    VBM_FIELD(N, sample_error_max,
              "Largest distance from the samples on the surface to the envelope's boundary."),
    VBM_FIELD(N, sample_error_mean, "Their mean distance."),
    VBM_FIELD(N, envelope_error_max,
              "Largest distance from the envelope's boundary to the interpolating surface."),
    VBM_FIELD(N, envelope_error_mean, "The mean of that distance, over the boundary."),
    VBM_FIELD(N, error_max, "Two-sided: the larger of the two largest."),
    VBM_FIELD(N, error_mean, "Two-sided: the mean of the two means."),
};

using C = vbm_clusters_report;
const Field<C> kClustersFields[] = {
    VBM_FIELD(C, balls, "Balls given."),
    VBM_FIELD(C, clusters, "Clusters: balls made."),
    VBM_FIELD(C, singles, "Clusters of one ball."),
    VBM_FIELD(C, sphericity, "Least sphericity of a cluster."),
    VBM_FIELD(C, largest, "Radius of the largest ball given."),
    VBM_FIELD(C, gap,
              "Largest of Clusters.gap: no point of the clusters' boundary is farther than this "
              "from the\nunion of the balls given."),
    VBM_FIELD(C, bound, "Theorem 3.3's bound, which gap never exceeds: that is checked."),
};

py::object position(const double (&p)[3]) { return py::make_tuple(p[0], p[1], p[2]); }

using E = vbm_cluster_error;
const Field<E> kClusterErrorFields[] = {
    VBM_FIELD(E, outward, "Largest distance from the clusters' boundary to the given one; exact at "
                          "each point."),
    VBM_FIELD(E, outward_mean, "Its mean."),
    {"outward_position", "Where it is largest, (x, y, z).",
     [](const E &e) { return position(e.outward_position); }},
    VBM_FIELD(E, outward_points, "Points looked at."),
    VBM_FIELD(E, inward, "Largest distance from the given boundary to the clusters': large where a "
                         "narrow gap was\nclosed. At a point never less than the distance."),
    VBM_FIELD(E, inward_mean, "Its mean."),
    {"inward_position", "Where it is largest, (x, y, z).",
     [](const E &e) { return position(e.inward_position); }},
    VBM_FIELD(E, inward_points, "Points looked at."),
};
#undef VBM_FIELD

// The named tuple's class, kept for as long as the process lives. Asking the module by its name
// would fail where it was imported under another, as from within a package.
template <class Report> py::handle &class_of() {
  static py::handle type;
  return type;
}

template <class Report, std::size_t N>
void bind(py::module_ &module, const char *name, const char *doc,
          const Field<Report> (&fields)[N]) {
  py::list names;
  for (const Field<Report> &field : fields) names.append(field.name);
  const py::object type =
      py::module_::import("collections").attr("namedtuple")(name, names, py::arg("module") = "vbm");
  type.attr("__doc__") = doc;
  for (const Field<Report> &field : fields) type.attr(field.name).attr("__doc__") = field.doc;
  module.add_object(name, type);
  class_of<Report>() = py::object(type).release();
}

template <class Report, std::size_t N>
py::object make(const Report &report, const Field<Report> (&fields)[N]) {
  py::tuple values(N);
  for (std::size_t i = 0; i < N; ++i) values[i] = fields[i].get(report);
  return class_of<Report>()(*values);
}

} // namespace

void bind_reports(py::module_ &module) {
  bind(module, "ModelReport", "What was found and done while a model was built; a named tuple.",
       kModelFields);
  bind(module, "SurfaceReport", "Counts and measures of a surface; a named tuple.", kSurfaceFields);
  bind(module, "AxisReport", "Counts of a medial axis; a named tuple.", kAxisFields);
  bind(module, "MedialMeshReport", "Counts and errors of a medial mesh; a named tuple.",
       kMedialMeshFields);
  bind(module, "ClustersReport", "Counts and errors of clusters; a named tuple.", kClustersFields);
  bind(module, "ClusterError",
       "Distances between the boundaries of the given balls' union and of the clusters' balls'; a "
       "named tuple.",
       kClusterErrorFields);
}

py::object to_python(const vbm_model_report &report) { return make(report, kModelFields); }
py::object to_python(const vbm_surface_report &report) { return make(report, kSurfaceFields); }
py::object to_python(const vbm_axis_report &report) { return make(report, kAxisFields); }
py::object to_python(const vbm_clusters_report &report) { return make(report, kClustersFields); }
py::object to_python(const vbm_cluster_error &error) { return make(error, kClusterErrorFields); }

py::object to_python(const vbm_medial_mesh_report &report) {
  return make(report, kMedialMeshFields);
}

py::list lines_of(const std::string &text) {
  py::list list;
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos;
       begin = end + 1)
    list.append(text.substr(begin, end - begin));
  return list;
}

std::string counted(uint64_t count, const char *singular, const char *plural) {
  return std::to_string(count) + " " + (count == 1 ? singular : plural);
}

} // namespace vbm::python
