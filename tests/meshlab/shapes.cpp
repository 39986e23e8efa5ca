// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <vcg/complex/algorithms/clean.h>
#include <vcg/complex/algorithms/create/platonic.h>
#include <vcg/complex/algorithms/inertia.h>

#include <cmath>

namespace shapes {

using Clean = vcg::tri::Clean<CMeshO>;

void finish(MeshModel &model) {
  vcg::tri::UpdateBounding<CMeshO>::Box(model.cm);
  vcg::tri::UpdateNormal<CMeshO>::PerFaceNormalized(model.cm);
  vcg::tri::UpdateNormal<CMeshO>::PerVertexAngleWeighted(model.cm);
  vcg::tri::UpdateNormal<CMeshO>::NormalizePerVertex(model.cm);
}

MeshModel *sphere(MeshDocument &document, double radius) {
  MeshModel *model = host::add_layer(document, "my.ball.ply");
  vcg::tri::Sphere(model->cm, 4);
  for (auto &vertex : model->cm.vert) {
    vertex.P().Normalize();
    vertex.P() *= Scalarm(radius);
  }
  finish(*model);
  return model;
}

MeshModel *torus(MeshDocument &document, double ring, double tube) {
  MeshModel *model = host::add_layer(document, "torus.ply");
  const int n = 96, m = 48;
  const double turn = 2 * std::acos(-1.0);
  std::vector<Point3m> points;
  std::vector<vcg::Point3i> faces;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double u = turn * i / n, v = turn * (j + 0.5 * (i % 2)) / m;
      const double r = ring + tube * std::cos(v);
      points.emplace_back(Scalarm(r * std::cos(u)), Scalarm(r * std::sin(u)),
                          Scalarm(tube * std::sin(v)));
      const int a = i * m + j, b = i * m + (j + 1) % m;
      const int c = (i + 1) % n * m + j, d = (i + 1) % n * m + (j + 1) % m;
      faces.emplace_back(a, c, b);
      faces.emplace_back(b, c, d);
    }
  vcg::tri::BuildMeshFromCoordVectorIndexVector(model->cm, points, faces);
  finish(*model);
  return model;
}

void forget_faces(MeshModel &model) {
  for (auto &face : model.cm.face)
    if (!face.IsD()) vcg::tri::Allocator<CMeshO>::DeleteFace(model.cm, face);
  vcg::tri::Allocator<CMeshO>::CompactFaceVector(model.cm);
}

Check check(MeshModel &model) {
  Check result;
  CMeshO &mesh = model.cm;
  model.updateDataMask(MeshModel::MM_FACEFACETOPO);
  vcg::tri::UpdateTopology<CMeshO>::FaceFace(mesh);
  result.vertices = mesh.VN();
  result.faces = mesh.FN();
  int edges = 0;
  Clean::CountEdgeNum(mesh, edges, result.border_edges, result.bad_edges);
  result.bad_vertices = Clean::CountNonManifoldVertexFF(mesh, false);
  if (result.bad_edges) return result; // what follows asserts that there are none
  result.holes = Clean::CountHoles(mesh);
  result.components = Clean::CountConnectedComponents(mesh);
  result.genus = Clean::MeshGenus(mesh.VN(), edges, mesh.FN(), result.holes, result.components);
  result.oriented = Clean::IsCoherentlyOrientedMesh(mesh);
  vcg::tri::Inertia<CMeshO> inertia(mesh);
  result.volume = inertia.Mass();
  return result;
}

} // namespace shapes
