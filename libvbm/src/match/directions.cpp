// SPDX-License-Identifier: GPL-3.0-or-later
#include "match/directions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace vbm::impl {
namespace {

using Triangle = std::array<int32_t, 3>;

int32_t middle(std::vector<Vec3> &list, std::map<std::pair<int32_t, int32_t>, int32_t> &known,
               int32_t a, int32_t b) {
  const auto [entry, added] = known.insert({std::minmax(a, b), int32_t(list.size())});
  if (added) list.push_back(unit(list[a] + list[b]));
  return entry->second;
}

/// Radians from the corners of a spherical triangle to the point farthest from them all: acute
/// triangles all, so that it is the centre of the circle through them.
double covering(const Vec3 &a, const Vec3 &b, const Vec3 &c) {
  return std::acos(std::min(1.0, std::fabs(dot(unit(cross(b - a, c - a)), a))));
}

} // namespace

Directions icosahedral_directions(int cuts) {
  const double g = (1 + std::sqrt(5.0)) / 2; // golden ratio
  Directions out;
  for (const Vec3 &v : {Vec3{-1, g, 0}, Vec3{1, g, 0}, Vec3{-1, -g, 0}, Vec3{1, -g, 0},
                        Vec3{0, -1, g}, Vec3{0, 1, g}, Vec3{0, -1, -g}, Vec3{0, 1, -g},
                        Vec3{g, 0, -1}, Vec3{g, 0, 1}, Vec3{-g, 0, -1}, Vec3{-g, 0, 1}})
    out.list.push_back(unit(v));
  std::vector<Triangle> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int cut = 0; cut < cuts; ++cut) {
    std::map<std::pair<int32_t, int32_t>, int32_t> known;
    std::vector<Triangle> next;
    for (const auto &[a, b, c] : triangles) {
      const int32_t ab = middle(out.list, known, a, b), bc = middle(out.list, known, b, c),
                    ca = middle(out.list, known, c, a);
      for (const Triangle &t :
           {Triangle{a, ab, ca}, Triangle{b, bc, ab}, Triangle{c, ca, bc}, Triangle{ab, bc, ca}})
        next.push_back(t);
    }
    triangles.swap(next);
  }
  for (const auto &[a, b, c] : triangles)
    out.angle = std::max(out.angle, covering(out.list[a], out.list[b], out.list[c]));
  return out;
}

} // namespace vbm::impl
