// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/faces.h"

#include "core/error.h"
#include "core/progress.h"
#include "sampling/checks.h"
#include "sampling/merge.h"
#include "sampling/polygon.h"
#include "sampling/tolerances.h"

#include <algorithm>

namespace vbm::impl {
namespace {

/// Call visit(face, first corner, end) for every face.
template <class Visit>
void for_each_face(const FaceArrays &faces, Progress &progress, Visit visit) {
  const int32_t *corner = faces.corners;
  for (std::size_t f = 0; f < faces.face_count; ++f) {
    if ((f & 255) == 0) progress.tick(0, 1);
    const std::size_t size = faces.face_sizes ? faces.face_sizes[f] : 3;
    visit(f, corner, corner + size);
    corner += size;
  }
}

void check_arrays(const FaceArrays &faces) {
  const auto refuse = [](std::string message) {
    throw Error(VBM_ERROR_ARGUMENT, std::move(message));
  };
  if (faces.corner_count > 0 && faces.corners == nullptr) refuse("the array of corners is NULL");
  if (faces.corner_count > kMostIndices || faces.face_count > kMostIndices)
    throw Error(VBM_ERROR_LIMIT, counted(faces.face_count, "face", "faces") + " with " +
                                     counted(faces.corner_count, "corner", "corners") +
                                     " are more than can be numbered");
  uint64_t sum = 3 * uint64_t(faces.face_count);
  if (faces.face_sizes) {
    sum = 0;
    for (std::size_t f = 0; f < faces.face_count; ++f) sum += faces.face_sizes[f];
  }
  if (sum != faces.corner_count)
    refuse("the " + counted(faces.face_count, "face", "faces") + " have " + std::to_string(sum) +
           " corners together, but " + std::to_string(faces.corner_count) + " are given");
}

void check_corners(const FaceArrays &faces, Progress &progress) {
  Offenders bad;
  int32_t first = 0;
  for_each_face(faces, progress, [&](std::size_t f, const int32_t *c, const int32_t *end) {
    c = std::find_if(c, end, [&](int32_t v) {
      return v < 0 || static_cast<std::size_t>(v) >= faces.vertex_count;
    });
    if (c == end) return;
    if (bad.total == 0) first = *c;
    bad.add(f);
  });
  if (bad.total == 0) return;
  const std::string there =
      faces.vertex_count == 1
          ? "there is only 1 vertex"
          : "there are only " + std::to_string(faces.vertex_count) + " vertices";
  throw_offenders(bad, "face", "faces", "uses vertex " + std::to_string(first) + ", but " + there);
}

bool has_three_different(const int32_t *c, const int32_t *end) {
  if (end - c < 3) return false;
  const int32_t a = *c;
  const int32_t *second = std::find_if(c, end, [a](int32_t v) { return v != a; });
  if (second == end) return false;
  const int32_t b = *second;
  return std::any_of(second, end, [a, b](int32_t v) { return v != a && v != b; });
}

/// One byte per vertex: 1 if a usable face uses it. Counts faces that use a vertex of `keep` 0.
std::vector<uint8_t> vertices_in_use(const FaceArrays &faces, const std::vector<uint8_t> &keep,
                                     std::size_t &invalid_faces, Progress &progress) {
  std::vector<uint8_t> used(faces.vertex_count, 0);
  for_each_face(faces, progress, [&](std::size_t, const int32_t *c, const int32_t *end) {
    if (!has_three_different(c, end)) return;
    if (!keep.empty() && std::any_of(c, end, [&](int32_t v) { return !keep[v]; })) {
      ++invalid_faces;
      return;
    }
    for (; c != end; ++c) used[*c] = 1;
  });
  return used;
}

std::vector<Triangle> triangulate(const FaceArrays &faces, Samples &samples, Progress &progress) {
  std::vector<Triangle> triangles;
  triangles.reserve(faces.corner_count - std::min(faces.corner_count, 2 * faces.face_count));
  std::vector<int32_t> polygon;
  for_each_face(faces, progress, [&](std::size_t, const int32_t *c, const int32_t *end) {
    if (!has_three_different(c, end)) {
      ++samples.skipped_faces;
      return;
    }
    polygon.clear();
    for (; c != end; ++c) {
      const int32_t s = samples.input_sample[*c];
      if (s < 0) return; // uses a vertex that is not finite
      if (polygon.empty() || polygon.back() != s) polygon.push_back(s);
    }
    while (polygon.size() > 1 && polygon.back() == polygon.front()) polygon.pop_back();
    if (!has_three_different(polygon.data(), polygon.data() + polygon.size()))
      ++samples.skipped_faces;
    else if (polygon.size() == 3)
      triangles.push_back({polygon[0], polygon[1], polygon[2]});
    else
      triangulate_polygon(polygon, samples.position, triangles, progress);
  });
  // A corner passed twice can give a triangle with two corners at one vertex.
  const auto flat = [](const Triangle &t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), flat), triangles.end());
  return triangles;
}

/// Leave out the samples no triangle uses any more.
void drop_unused(std::vector<Triangle> &triangles, Samples &samples) {
  std::vector<int32_t> name(samples.position.size(), -1);
  for (const Triangle &t : triangles)
    for (int32_t v : t) name[v] = 0;
  int32_t to = 0;
  for (std::size_t s = 0; s < name.size(); ++s) {
    if (name[s] < 0) continue;
    samples.position[to] = samples.position[s];
    samples.input[to] = samples.input[s];
    samples.input_position[to] = samples.input_position[s];
    name[s] = to++;
  }
  if (static_cast<std::size_t>(to) == name.size()) return;
  samples.position.resize(to);
  samples.input.resize(to);
  samples.input_position.resize(to);
  samples.dropped = 0;
  for (int32_t &s : samples.input_sample) {
    s = s < 0 ? -1 : name[s];
    samples.dropped += s < 0;
  }
  samples.merged = samples.input_points - samples.dropped - samples.position.size();
  for (Triangle &t : triangles)
    for (int32_t &v : t) v = name[v];
}

} // namespace

std::vector<Triangle> read_faces(const FaceArrays &faces, const vbm_build_options &options,
                                 Samples &samples, Progress &progress) {
  check_count(faces.vertices, faces.vertex_count, options);
  check_arrays(faces);
  check_corners(faces, progress);
  std::vector<uint8_t> keep;
  const std::size_t bad = check_finite(faces.vertices, faces.vertex_count, "vertex", "vertices",
                                       options.drop_invalid != 0, keep, progress);
  std::size_t invalid_faces = 0;
  keep = vertices_in_use(faces, keep, invalid_faces, progress);
  merge_points(faces.vertices, faces.vertex_count, keep, samples, progress);
  const std::size_t unused = samples.dropped - bad;

  std::vector<Triangle> triangles = triangulate(faces, samples, progress);
  if (triangles.size() > kMostIndices / 3)
    throw Error(VBM_ERROR_LIMIT, counted(triangles.size(), "triangle", "triangles") +
                                     " are more than can be numbered");

  if (bad)
    samples.notes.push_back(counted(bad, "vertex is", "vertices are") +
                            " not finite: left out, and " +
                            counted(invalid_faces, "face", "faces") + " with them");
  if (unused)
    samples.notes.push_back(counted(unused, "vertex is", "vertices are") +
                            " used by no face and left out");
  if (samples.skipped_faces)
    samples.notes.push_back(counted(samples.skipped_faces, "face has", "faces have") +
                            " fewer than three different corners and were skipped");
  return triangles;
}

void drop_double_faces(std::vector<Triangle> &triangles, Samples &samples) {
  const DoubleFaces found = remove_double_faces(triangles, samples.position.size());
  drop_unused(triangles, samples);
  if (found.repeated)
    samples.notes.push_back(counted(found.repeated, "triangle repeats another and was",
                                    "triangles repeat others and were") +
                            " left out");
  if (found.sheet)
    samples.notes.push_back("the mesh is a sheet without thickness, seen from both sides");
  else if (found.cancelled)
    samples.notes.push_back(
        std::to_string(found.cancelled) +
        " triangles lie back to back on each other, as sheets without thickness or walls between "
        "solids, and were left out");
}

} // namespace vbm::impl
