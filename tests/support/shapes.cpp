// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shapes {

namespace {
const double kPi = std::acos(-1.0);
}

uint64_t Random::bits() { // splitmix64
  uint64_t z = state_ += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double distance(const Vec &a, const Vec &b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Shape sphere_points(std::size_t count, double radius, const Vec &center) {
  Shape shape;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1 - 2 * (double(i) + .5) / double(count), r = std::sqrt(1 - z * z);
    const double turn = kPi * (1 + std::sqrt(5.)) * (double(i) + .5);
    const Vec n = {r * std::cos(turn), r * std::sin(turn), z};
    shape.add({center[0] + radius * n[0], center[1] + radius * n[1], center[2] + radius * n[2]}, n);
  }
  return shape;
}

Shape sphere_mesh(int rings, int sectors, double radius, const Vec &center) {
  Shape shape;
  const auto put = [&](double x, double y, double z) {
    shape.add({center[0] + radius * x, center[1] + radius * y, center[2] + radius * z}, {x, y, z});
  };
  put(0, 0, 1);
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < sectors; ++j) {
      const double a = kPi * i / rings, b = 2 * kPi * j / sectors;
      put(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
    }
  put(0, 0, -1);
  const auto id = [&](int i, int j) { return 1 + (i - 1) * sectors + j % sectors; };
  const int last = int(shape.size()) - 1;
  const auto face = [&](int a, int b, int c) {
    shape.triangles.insert(shape.triangles.end(), {a, b, c});
  };
  for (int j = 0; j < sectors; ++j) {
    face(0, id(1, j), id(1, j + 1));
    for (int i = 1; i + 1 < rings; ++i) {
      face(id(i, j), id(i + 1, j), id(i + 1, j + 1));
      face(id(i, j), id(i + 1, j + 1), id(i, j + 1));
    }
    face(last, id(rings - 1, j + 1), id(rings - 1, j));
  }
  return shape;
}

Shape torus(int u, int v, double major, double minor, double jitter) {
  Shape shape;
  Random random(7);
  for (int i = 0; i < u; ++i)
    for (int j = 0; j < v; ++j) {
      const double a = 2 * kPi * (i + jitter * random.real(-1, 1)) / u;
      const double b = 2 * kPi * (j + jitter * random.real(-1, 1)) / v;
      const Vec n = {std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)};
      shape.add(
          {major * std::cos(a) + minor * n[0], major * std::sin(a) + minor * n[1], minor * n[2]},
          n);
      const int32_t p = i * v + j, q = i * v + (j + 1) % v, r = (i + 1) % u * v + j,
                    s = (i + 1) % u * v + (j + 1) % v;
      shape.triangles.insert(shape.triangles.end(), {p, r, s, p, s, q});
    }
  return shape;
}

Shape box(const Vec &sides, const Vec &origin) {
  Shape shape;
  for (int i = 0; i < 8; ++i)
    shape.add({origin[0] + (i & 4 ? sides[0] : 0), origin[1] + (i & 2 ? sides[1] : 0),
               origin[2] + (i & 1 ? sides[2] : 0)});
  shape.triangles = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                     2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};
  return shape;
}

Shape box_points(const Vec &sides, double spacing) {
  Shape shape;
  Random random(3);
  for (int axis = 0; axis < 3; ++axis) {
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    const int nb = int(std::ceil(sides[b] / spacing)), nc = int(std::ceil(sides[c] / spacing));
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i < nb; ++i)
        for (int j = 0; j < nc; ++j) { // away from the edges, which have two normals
          Vec p{}, n{};
          p[axis] = side ? sides[axis] : 0;
          n[axis] = side ? 1 : -1;
          p[b] = sides[b] * (i + .5 + .2 * random.real(-1, 1)) / nb;
          p[c] = sides[c] * (j + .5 + .2 * random.real(-1, 1)) / nc;
          shape.add(p, n);
        }
  }
  return shape;
}

Shape capsule_points(double length, double radius, double spacing) {
  // A spiral: rings along the outline, each turned by the golden angle against the one before.
  Shape shape;
  const double outline = kPi * radius + length;
  const int rings = int(std::ceil(outline / spacing));
  for (int i = 0; i < rings; ++i) {
    const double s = outline * (i + .5) / rings;
    double angle, x = 0;
    if (s < kPi * radius / 2) {
      angle = s / radius;
    } else if (s < kPi * radius / 2 + length) {
      angle = kPi / 2, x = s - kPi * radius / 2;
    } else {
      angle = (s - length) / radius, x = length;
    }
    const int sectors = std::max(1, int(std::ceil(2 * kPi * radius * std::sin(angle) / spacing)));
    for (int j = 0; j < sectors; ++j) {
      const double turn = 2 * kPi * (j + .6180339887 * i) / sectors;
      const Vec n = {-std::cos(angle), std::sin(angle) * std::cos(turn),
                     std::sin(angle) * std::sin(turn)};
      shape.add({x + radius * n[0], radius * n[1], radius * n[2]}, n);
    }
  }
  return shape;
}

Shape join(const Shape &a, const Shape &b) {
  Shape shape = a;
  shape.points.insert(shape.points.end(), b.points.begin(), b.points.end());
  shape.normals.insert(shape.normals.end(), b.normals.begin(), b.normals.end());
  if (shape.normals.size() != shape.points.size()) shape.normals.clear();
  for (int32_t v : b.triangles) shape.triangles.push_back(v + int32_t(a.size()));
  return shape;
}

Shape inside_out(Shape shape) {
  for (std::size_t f = 0; f < shape.faces(); ++f)
    std::swap(shape.triangles[3 * f + 1], shape.triangles[3 * f + 2]);
  for (double &x : shape.normals) x = -x;
  return shape;
}

Shape moved(Shape shape, const std::function<Vec(const Vec &)> &map) {
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Vec p = map(shape.at(i));
    std::copy(p.begin(), p.end(), shape.points.begin() + std::ptrdiff_t(3 * i));
  }
  return shape;
}

Shape permuted(const Shape &shape, const std::vector<std::size_t> &order) {
  Shape out;
  std::vector<int32_t> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    out.add(shape.at(order[i]));
    if (!shape.normals.empty())
      out.normals.insert(out.normals.end(), &shape.normals[3 * order[i]],
                         &shape.normals[3 * order[i]] + 3);
    rank[order[i]] = int32_t(i);
  }
  for (int32_t v : shape.triangles) out.triangles.push_back(rank[std::size_t(v)]);
  return out;
}

std::vector<std::size_t> shuffled(std::size_t count, uint64_t seed) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  Random random(seed);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.bits() % i]);
  return order;
}

} // namespace shapes
