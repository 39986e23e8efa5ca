// SPDX-License-Identifier: GPL-3.0-or-later
// The meshes the benchmarks run on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

struct Mesh {
  std::string name, source;       // "bunny", and the file it is from or how it was made
  std::vector<double> points;     // n x 3, all of them used by a triangle
  std::vector<int32_t> triangles; // m x 3
  std::size_t point_count() const { return points.size() / 3; }
  std::size_t triangle_count() const { return triangles.size() / 3; }
};

/// Read a Wavefront file; polygons become fans, points at the same place one point, and points that
/// no face uses are left out. Throws std::runtime_error naming the file.
Mesh read_obj(const std::string &path);

/// The first there is of: the Stanford bunny beside the repository (see tests/CMakeLists.txt), the
/// bunny of Debian's glmark2-data, a generated knobbly torus of about as many points.
Mesh bunny();

/// A closed knobbly torus of rings * 2 * rings points.
Mesh generated(int rings);

/// Every triangle cut into four at the middles of its edges.
Mesh subdivide(const Mesh &mesh);

} // namespace bench
