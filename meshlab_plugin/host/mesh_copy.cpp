// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_copy.h"

#include <cmath>

namespace vbm_meshlab {

using vbm_filters::NewLayer;
using vbm_filters::Ramp;
using vbm_filters::VertexValues;

namespace {

// MeshLab cuts a layer's name at its last dot when it looks for a free one and when it saves.
QString plain_name(const QString &label) {
  const int dot = label.lastIndexOf('.');
  QString name = dot > 0 ? label.left(dot) : label;
  return name.replace('.', '_');
}

vcg::Color4b host_color(const vbm_filters::Color &c) { return vcg::Color4b(c.r, c.g, c.b, c.a); }

vcg::Color4b ramp_color(const Ramp &ramp, double value) {
  vcg::Color4b color;
  // Equal balls everywhere are no reason to call them all small.
  if (!(ramp.high > ramp.low)) return vcg::Color4b(vcg::Color4b::Green);
  color.SetColorRamp(float(0), float(1), float((value - ramp.low) / (ramp.high - ramp.low)));
  return color;
}

// A vertex with nothing but needles round it has no normal of its own: it takes its neighbours',
// ring by ring, so that it does not show as a black speck.
void mend_normals(CMeshO &mesh) {
  const auto unknown = [](const CVertexO &vertex) { return !(vertex.cN().SquaredNorm() > 0.25); };
  for (int ring = 0; ring < 8; ++ring) {
    std::vector<std::pair<CVertexO *, Point3m>> found;
    for (CFaceO &face : mesh.face)
      for (int k = 0; k < 3; ++k)
        if (unknown(*face.V(k)))
          for (int other = 1; other < 3; ++other)
            if (!unknown(*face.V((k + other) % 3)))
              found.emplace_back(face.V(k), face.V((k + other) % 3)->cN());
    if (found.empty()) return;
    for (auto &[vertex, normal] : found) vertex->N() = Point3m(0, 0, 0);
    for (auto &[vertex, normal] : found) vertex->N() += normal;
    for (auto &[vertex, normal] : found) vertex->N().Normalize();
  }
}

} // namespace

Source copy_out(MeshModel &model) {
  Source source;
  const CMeshO &mesh = model.cm;
  source.id = model.id();
  source.layer.name = plain_name(model.label()).toStdString();
  source.matrix = mesh.Tr;
  source.places = mesh.vert.size();
  Matrix44m identity;
  identity.SetIdentity();
  source.layer.transformed = !(source.matrix == identity);

  const bool colored = model.hasDataMask(MeshModel::MM_VERTCOLOR);
  const bool balls = model.hasDataMask(MeshModel::MM_VERTRADIUS);
  constexpr std::int32_t kDeleted = -1;
  std::vector<std::int32_t> index(mesh.vert.size(), kDeleted);
  auto &layer = source.layer;
  for (std::size_t i = 0; i < mesh.vert.size(); ++i) {
    const CVertexO &vertex = mesh.vert[i];
    if (vertex.IsD()) continue;
    index[i] = static_cast<std::int32_t>(source.place.size());
    source.place.push_back(i);
    for (int k = 0; k < 3; ++k) {
      layer.points.push_back(vertex.cP()[k]);
      layer.normals.push_back(vertex.cN()[k]);
    }
    if (colored) {
      const vcg::Color4b c = vertex.cC();
      layer.colors.push_back({c[0], c[1], c[2], c[3]});
    }
    if (balls) layer.radius.push_back(vertex.cR());
    layer.selected_vertices.push_back(vertex.IsS());
  }
  layer.renumbered = source.place.size() != mesh.vert.size();
  for (const CFaceO &face : mesh.face) {
    if (face.IsD()) continue;
    layer.selected_triangles.push_back(face.IsS());
    for (int k = 0; k < 3; ++k)
      layer.triangles.push_back(index[static_cast<std::size_t>(face.cV(k) - &mesh.vert[0])]);
  }
  return source;
}

void fill(MeshModel &model, const NewLayer &result) {
  CMeshO &mesh = model.cm;
  int mask = MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTRADIUS;
  if (!result.colors.empty() || result.ramp.wanted) mask |= MeshModel::MM_VERTCOLOR;
  if (!result.inner_edge.empty()) mask |= MeshModel::MM_POLYGONAL;
  if (!result.triangle_colors.empty()) mask |= MeshModel::MM_FACECOLOR;
  if (!result.triangle_quality.empty()) mask |= MeshModel::MM_FACEQUALITY;
  model.updateDataMask(mask);

  const std::size_t vertices = result.points.size() / 3, faces = result.triangles.size() / 3;
  vcg::tri::Allocator<CMeshO>::AddVertices(mesh, vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    CVertexO &vertex = mesh.vert[i];
    const double *p = &result.points[3 * i];
    vertex.P() = Point3m(Scalarm(p[0]), Scalarm(p[1]), Scalarm(p[2]));
    vertex.N() = Point3m(0, 0, 0);
    vertex.Q() = static_cast<float>(result.quality[i]);
    vertex.R() = static_cast<Scalarm>(result.radius[i]);
    if (!result.selected.empty() && result.selected[i]) vertex.SetS();
    if (!result.colors.empty()) {
      vertex.C() = host_color(result.colors[i]);
    } else if (result.ramp.wanted) {
      vertex.C() = ramp_color(result.ramp, result.quality[i]);
    }
  }
  vcg::tri::Allocator<CMeshO>::AddFaces(mesh, faces);
  for (std::size_t i = 0; i < faces; ++i) {
    CFaceO &face = mesh.face[i];
    for (int k = 0; k < 3; ++k) {
      face.V(k) = &mesh.vert[static_cast<std::size_t>(result.triangles[3 * i + k])];
      if (!result.inner_edge.empty() && result.inner_edge[3 * i + k]) face.SetF(k);
    }
    if (!result.triangle_colors.empty()) face.C() = host_color(result.triangle_colors[i]);
    if (!result.triangle_quality.empty()) face.Q() = static_cast<float>(result.triangle_quality[i]);
  }
  vcg::tri::UpdateBounding<CMeshO>::Box(mesh);
  if (!faces) {
    // Without normals MeshLab draws points in their own colours, instead of lighting them.
    model.clearDataMask(MeshModel::MM_VERTNORMAL);
  } else {
    vcg::tri::UpdateNormal<CMeshO>::PerFaceNormalized(mesh);
    vcg::tri::UpdateNormal<CMeshO>::PerVertexAngleWeighted(mesh);
    vcg::tri::UpdateNormal<CMeshO>::NormalizePerVertex(mesh);
    mend_normals(mesh);
  }
}

void select(MeshModel &model, const Source &source, const std::vector<std::uint8_t> &chosen) {
  for (CVertexO &vertex : model.cm.vert) vertex.ClearS();
  for (std::size_t i = 0; i < source.place.size(); ++i)
    if (chosen[i]) model.cm.vert[source.place[i]].SetS();
}

void write(MeshModel &model, const Source &source, const VertexValues &values) {
  int mask = MeshModel::MM_VERTQUALITY;
  if (!values.radius.empty()) mask |= MeshModel::MM_VERTRADIUS;
  if (!values.colors.empty() || values.ramp.wanted) mask |= MeshModel::MM_VERTCOLOR;
  model.updateDataMask(mask);
  const auto number = [](double value) { return std::isnan(value) ? 0.0 : value; };
  for (std::size_t i = 0; i < source.place.size(); ++i) {
    CVertexO &vertex = model.cm.vert[source.place[i]];
    vertex.Q() = static_cast<float>(number(values.quality[i]));
    if (!values.radius.empty()) vertex.R() = static_cast<Scalarm>(number(values.radius[i]));
    if (!values.colors.empty()) {
      vertex.C() = host_color(values.colors[i]);
      continue;
    }
    if (!values.ramp.wanted) continue;
    vertex.C() = std::isnan(values.quality[i]) ? vcg::Color4b(vcg::Color4b::Gray)
                                               : ramp_color(values.ramp, values.quality[i]);
  }
}

} // namespace vbm_meshlab
