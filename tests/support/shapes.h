// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes whose balls and surfaces are known, for tests.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace shapes {

using Vec = std::array<double, 3>;

/// Points or a triangle mesh; `normals` empty or one outward unit normal a point.
struct Shape {
  std::vector<double> points, normals;
  std::vector<int32_t> triangles;

  std::size_t size() const { return points.size() / 3; }
  std::size_t faces() const { return triangles.size() / 3; }
  Vec at(std::size_t i) const { return {points[3 * i], points[3 * i + 1], points[3 * i + 2]}; }
  void add(const Vec &p) { points.insert(points.end(), p.begin(), p.end()); }
  void add(const Vec &p, const Vec &n) {
    add(p);
    normals.insert(normals.end(), n.begin(), n.end());
  }
};

/// The same numbers on every machine: not those of the standard library's distributions.
class Random {
public:
  explicit Random(uint64_t seed) : state_(seed * 2 + 1) {}
  uint64_t bits();
  /// In [0, 1).
  double real() { return double(bits() >> 11) * 0x1p-53; }
  double real(double low, double high) { return low + (high - low) * real(); }

private:
  uint64_t state_;
};

/// Points spread over a sphere along Fibonacci's spiral, with normals.
Shape sphere_points(std::size_t count, double radius = 1, const Vec &center = {0, 0, 0});
/// A sphere of latitudes and longitudes.
Shape sphere_mesh(int rings, int sectors, double radius = 1, const Vec &center = {0, 0, 0});
/// A torus round the z axis: `u` times `v` vertices moved within the surface by up to `jitter` of
/// their distance, with normals and triangles.
Shape torus(int u, int v, double major, double minor, double jitter = 0);
/// A box from 0 to `sides` of twelve triangles.
Shape box(const Vec &sides, const Vec &origin = {0, 0, 0});
/// Points on a box's surface, at most `spacing` apart along its sides and moved within the faces,
/// with normals.
Shape box_points(const Vec &sides, double spacing);
/// Points on a capsule round the x axis, its straight part from 0 to `length`, with normals.
Shape capsule_points(double length, double radius, double spacing);

/// One after the other, as one shape.
Shape join(const Shape &a, const Shape &b);
/// Every triangle's corners in the opposite order, and normals inward.
Shape inside_out(Shape shape);
Shape moved(Shape shape, const std::function<Vec(const Vec &)> &map);
/// The same shape with its points in another order; new point i is old point order[i].
Shape permuted(const Shape &shape, const std::vector<std::size_t> &order);
std::vector<std::size_t> shuffled(std::size_t count, uint64_t seed);

double distance(const Vec &a, const Vec &b);

} // namespace shapes
