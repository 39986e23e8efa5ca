// SPDX-License-Identifier: GPL-3.0-or-later
// Normals of the faces, edges and vertices of a mesh.
#pragma once

#include "sampling/triangle_mesh.h"

namespace vbm::impl {

inline constexpr double kPi = 3.14159265358979323846;

/// The unit normal of every triangle; zero where it has no area.
std::vector<Vec3> face_normals(const std::vector<Triangle> &triangles,
                               const std::vector<Vec3> &position, Progress &progress);

/// Unit pseudo-normals of the vertices: faces weighted by their angle there. Zero where they
/// cancel.
std::vector<Vec3> vertex_normals(const std::vector<Triangle> &triangles,
                                 const std::vector<Vec3> &position,
                                 const std::vector<Vec3> &face_normal, Progress &progress);

/// Unit pseudo-normal of an edge: the sum of its faces' normals.
Vec3 edge_normal(const TriangleMesh &mesh, const Edge &edge, const std::vector<Vec3> &face_normal);

/// The angle at corner c of a triangle, in radians.
double corner_angle(const Triangle &triangle, int c, const std::vector<Vec3> &position);

} // namespace vbm::impl
