// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

namespace bench {

Mesh read_obj(const std::string &path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path + " cannot be read");
  Mesh mesh;
  mesh.name = "mesh";
  mesh.source = path;
  std::vector<std::array<double, 3>> points;
  std::map<std::array<double, 3>, int32_t> place; // of points that faces use
  std::string line, word;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    words >> word;
    if (word == "v") {
      points.emplace_back();
      for (double &x : points.back()) words >> x;
    } else if (word == "f") {
      std::vector<int32_t> corners;
      while (words >> word) {
        const long i = std::strtol(word.c_str(), nullptr, 10); // "7/1/2" is vertex 7
        const long index = i < 0 ? i + long(points.size()) : i - 1;
        if (index < 0 || index >= long(points.size()))
          throw std::runtime_error(path + ": no vertex " + word);
        const auto [at, added] = place.try_emplace(points[index], int32_t(place.size()));
        if (added) mesh.points.insert(mesh.points.end(), at->first.begin(), at->first.end());
        corners.push_back(at->second);
      }
      for (std::size_t k = 2; k < corners.size(); ++k)
        mesh.triangles.insert(mesh.triangles.end(), {corners[0], corners[k - 1], corners[k]});
    }
    word.clear();
  }
  if (mesh.triangles.empty()) throw std::runtime_error(path + " has no faces");
  return mesh;
}

Mesh generated(int rings) {
  const double pi = std::acos(-1.);
  const int around = 2 * rings;
  Mesh mesh;
  mesh.source = "generated";
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < rings; ++j) {
      const double u = 2 * pi * (i + 0.5 * (j % 2)) / around, v = 2 * pi * j / rings;
      const double tube =
          0.35 + 0.05 * std::sin(7 * u) * std::cos(3 * v) + 0.02 * std::sin(23 * u + 5 * v);
      const double r = 1 + tube * std::cos(v);
      mesh.points.insert(mesh.points.end(), {r * std::cos(u), r * std::sin(u), tube * std::sin(v)});
    }
  const auto at = [&](int i, int j) { return int32_t(i % around * rings + j % rings); };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < rings; ++j) {
      mesh.triangles.insert(mesh.triangles.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.insert(mesh.triangles.end(), {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

// Of the folder that VBM_SHARED names, else of Debian's package glmark2-data, else a torus instead.
Mesh bunny() {
  const char *shared = std::getenv("VBM_SHARED");
  const std::string data = shared ? shared : VBM_SOURCE_DIR "/../shared";
  Mesh mesh;
  for (const std::string &path : {data + "/data/meshes/stanford-bunny.obj",
                                  std::string("/usr/share/glmark2/models/bunny.obj")})
    if (mesh.triangles.empty() && std::ifstream(path)) mesh = read_obj(path);
  if (mesh.triangles.empty()) mesh = generated(132);
  mesh.name = mesh.source == "generated" ? "torus" : "bunny";
  return mesh;
}

Mesh subdivide(const Mesh &mesh) {
  Mesh out = mesh;
  out.triangles.clear();
  out.triangles.reserve(4 * mesh.triangles.size());
  std::unordered_map<uint64_t, int32_t> middles;
  middles.reserve(3 * mesh.triangle_count() / 2);
  const auto middle = [&](int32_t a, int32_t b) {
    if (a > b) std::swap(a, b);
    const auto [at, added] =
        middles.try_emplace(uint64_t(a) << 32 | uint32_t(b), int32_t(out.point_count()));
    if (added)
      for (int k = 0; k < 3; ++k)
        out.points.push_back((mesh.points[3 * a + k] + mesh.points[3 * b + k]) / 2);
    return at->second;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const int32_t a = mesh.triangles[t], b = mesh.triangles[t + 1], c = mesh.triangles[t + 2];
    const int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (int32_t v : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca}) out.triangles.push_back(v);
  }
  return out;
}

} // namespace bench
