// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes that the tests make, and MeshLab's own word on whether a surface is closed.
#pragma once

#include "host.h"

namespace shapes {

// A sphere of this radius about the origin, 2562 vertices, faces outwards.
MeshModel *sphere(MeshDocument &document, double radius);
// A torus round the z axis, 96 x 48 vertices.
MeshModel *torus(MeshDocument &document, double ring, double tube);
// Bare points on a box of 4 x 2 x 1 with a corner at the origin: on its edges and corners, and
// shaken within its faces, the same ones every time.
MeshModel *box(MeshDocument &document, double spacing);
// A sphere of radius 2 about the origin with a horn of length 1.5 in the direction z, 10242
// vertices.
MeshModel *horned_sphere(MeshDocument &document);
// Bare points on a paddle: an ellipsoid of 1, 1 and 0.3 about the origin with a round stick of radius
// 0.15 in the direction x, to x = 4.
MeshModel *paddle(MeshDocument &document);
void forget_faces(MeshModel &model);
void finish(MeshModel &model); // its box and normals

// Found with vcglib's algorithms, which know nothing of libvbm.
struct Check {
  int vertices = 0, faces = 0, border_edges = 0, bad_edges = 0, bad_vertices = 0, holes = 0;
  int components = 0, genus = 0;
  bool oriented = false;
  double volume = 0; // negative if inside out
};
Check check(MeshModel &model);

} // namespace shapes
