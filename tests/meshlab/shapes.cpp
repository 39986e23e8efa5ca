// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <vcg/complex/algorithms/clean.h>
#include <vcg/complex/algorithms/create/platonic.h>
#include <vcg/complex/algorithms/inertia.h>

#include <algorithm>
#include <cmath>
#include <random>

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

MeshModel *horned_sphere(MeshDocument &document) {
  MeshModel *model = host::add_layer(document, "horned.ply");
  vcg::tri::Sphere(model->cm, 5);
  for (auto &vertex : model->cm.vert) {
    vertex.P().Normalize();
    const double angle = std::acos(std::min(1.0, double(vertex.cP()[2])));
    vertex.P() *= Scalarm(2 + 1.5 * std::exp(-std::pow(angle / 0.2, 2)));
  }
  finish(*model);
  return model;
}

MeshModel *paddle(MeshDocument &document) {
  MeshModel *model = host::add_layer(document, "paddle.ply");
  const double turn = 2 * std::acos(-1.0), radius = 0.15, flat = 0.3;
  const auto add = [&](double x, double y, double z) {
    vcg::tri::Allocator<CMeshO>::AddVertex(model->cm, Point3m(Scalarm(x), Scalarm(y), Scalarm(z)));
  };
  const int blade = 3000, rings = 52, around = 12;
  for (int k = 0; k < blade; ++k) {
    const double z = 1 - 2 * (k + 0.5) / blade, r = std::sqrt(1 - z * z),
                 a = turn * k * 0.618033989;
    const double x = r * std::cos(a), y = r * std::sin(a);
    if (x < 0 || std::hypot(y, flat * z) > radius + 0.02) add(x, y, flat * z);
  }
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      const double x = 0.9 + 0.06 * i, a = turn * (j + 0.5 * (i % 2)) / around;
      const double y = radius * std::cos(a), z = radius * std::sin(a);
      if (x * x + y * y + z * z / (flat * flat) > 1.05) add(x, y, z);
    }
  add(0.9 + 0.06 * (rings - 1) + radius, 0, 0);
  vcg::tri::UpdateBounding<CMeshO>::Box(model->cm);
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

MeshModel *box(MeshDocument &document, double spacing) {
  MeshModel *model = host::add_layer(document, "box.ply");
  const double size[3] = {4, 2, 1};
  std::mt19937 random(1);
  const auto shake = [&] { return (random() / double(std::mt19937::max()) - 0.5) * 0.6; };
  int steps[3];
  for (int a = 0; a < 3; ++a) steps[a] = int(std::lround(size[a] / spacing));
  for (int i = 0; i <= steps[0]; ++i)
    for (int j = 0; j <= steps[1]; ++j)
      for (int k = 0; k <= steps[2]; ++k) {
        const int at[3] = {i, j, k};
        int walls = 0;
        for (int a = 0; a < 3; ++a) walls += at[a] == 0 || at[a] == steps[a];
        if (!walls) continue;
        double p[3];
        for (int a = 0; a < 3; ++a) {
          const bool wall = at[a] == 0 || at[a] == steps[a];
          p[a] = spacing * (at[a] + (walls == 1 && !wall ? shake() : 0));
        }
        vcg::tri::Allocator<CMeshO>::AddVertex(
            model->cm, Point3m(Scalarm(p[0]), Scalarm(p[1]), Scalarm(p[2])));
      }
  vcg::tri::UpdateBounding<CMeshO>::Box(model->cm);
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
