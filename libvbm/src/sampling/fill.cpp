// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/fill.h"

#include "core/error.h"
#include "core/progress.h"
#include "sampling/add.h"
#include "sampling/checks.h"
#include "sampling/face_normals.h"
#include "sampling/lattice.h"
#include "sampling/point_table.h"
#include "sampling/tolerances.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

std::vector<double> edge_lengths(const TriangleMesh &mesh, const std::vector<Vec3> &position) {
  std::vector<double> lengths;
  lengths.reserve(mesh.edge.size());
  for (const Edge &e : mesh.edge) lengths.push_back(distance(position[e.a], position[e.b]));
  return lengths;
}

/// The parts an edge is cut into; a double, as it may be more than any integer.
double parts_of(double length, double spacing) {
  return length > spacing ? std::ceil(length / spacing) : 1;
}

double samples_on_edges(const std::vector<double> &edge_length, const Lattice &lattice,
                        double spacing) {
  double sum = 0;
  for (std::size_t e = 0; e < edge_length.size(); ++e)
    if (!lattice.within_patch(e)) sum += parts_of(edge_length[e], spacing) - 1;
  return sum;
}

/// The longest side of the typical triangle: half the area is in triangles with longer ones.
double typical_side(const TriangleMesh &mesh, const std::vector<Vec3> &position,
                    Progress &progress) {
  struct Weighted {
    double side, area;
  };
  std::vector<Weighted> sides;
  sides.reserve(mesh.triangle.size());
  double all = 0, below = 0;
  for (const Triangle &t : mesh.triangle) {
    const Vec3 a = position[t[0]], b = position[t[1]], c = position[t[2]];
    const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
    sides.push_back({longest, length(cross(b - a, c - a))});
    all += sides.back().area;
  }
  progress.tick_slow(0, 1);
  // Quickselect by weight.
  std::size_t begin = 0, end = sides.size();
  while (end - begin > 1) {
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(sides.begin() + begin, sides.begin() + middle, sides.begin() + end,
                     [](const Weighted &p, const Weighted &q) { return p.side < q.side; });
    double left = 0;
    for (std::size_t i = begin; i < middle; ++i) left += sides[i].area;
    if (below + left > all / 2)
      end = middle;
    else
      below += left, begin = middle;
  }
  return sides.empty() ? 0 : std::sqrt(sides[begin].side);
}

double diagonal_of(const std::vector<Vec3> &position) {
  if (position.empty()) return 0;
  Vec3 low = position[0], high = position[0];
  for (const Vec3 &p : position)
    for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
  return distance(low, high);
}

/// Whether the mesh's edges bend gently nearly everywhere: it then stands for a curved shape, whose
/// vertices lie on it and whose faces do not.
bool is_smooth(const TriangleMesh &mesh, const std::vector<Vec3> &face_normal,
               const std::vector<double> &edge_length) {
  double bent = 0, gentle = 0;
  for (std::size_t i = 0; i < mesh.edge.size(); ++i) {
    const Edge &e = mesh.edge[i];
    if (e.faces() != 2) continue;
    const double cosine =
        dot(face_normal[mesh.side[e.begin] / 3], face_normal[mesh.side[e.begin + 1] / 3]);
    if (cosine > kSamePlane) continue;
    bent += edge_length[i];
    if (cosine > kGentle) gentle += edge_length[i];
  }
  return gentle > kSmoothShare * bent;
}

/// The spacing where the options leave it open, in unit frame lengths; 0: nothing to add.
double choose_spacing(const TriangleMesh &mesh, const std::vector<Vec3> &face_normal,
                      const std::vector<double> &edge_length, const vbm_build_options &options,
                      Samples &samples, Progress &progress) {
  const double vertices = static_cast<double>(samples.position.size());
  const double most = std::min(std::max(kMostAdded, kMostAddedPerVertex * vertices),
                               static_cast<double>(sample_limit(options)) - vertices);
  double wanted = kTypicalSides * typical_side(mesh, samples.position, progress);
  if (!is_smooth(mesh, face_normal, edge_length))
    wanted = std::min(wanted, diagonal_of(samples.position) / kSpacingsAcross);
  if (!(wanted > 0)) return 0;
  double spacing = wanted;
  for (;;) {
    const Lattice lattice(mesh, samples.position, face_normal, edge_length, spacing, progress);
    const double count = samples_on_edges(edge_length, lattice, spacing) + lattice.estimate();
    if (count <= most) break;
    spacing *= std::max(kSpacingStep, std::sqrt(count / most)); // counts go with at most h^-2
  }
  if (spacing > wanted && std::isfinite(spacing))
    samples.notes.push_back("the mesh would need very many samples at a spacing of " +
                            short_number(samples.frame.length_to_input(wanted)) +
                            ", so it was sampled at " +
                            short_number(samples.frame.length_to_input(spacing)));
  return spacing;
}

void add_on_edges(const TriangleMesh &mesh, const std::vector<Vec3> &face_normal,
                  const std::vector<double> &edge_length, const Lattice &lattice, double spacing,
                  PointTable &table, Samples &samples, Progress &progress) {
  for (std::size_t i = 0; i < mesh.edge.size(); ++i) {
    if ((i & 1023) == 0) progress.tick(0, 1);
    const Edge &e = mesh.edge[i];
    if (lattice.within_patch(i)) continue;
    const int64_t parts = std::llround(parts_of(edge_length[i], spacing));
    if (parts < 2) continue;
    const Vec3 a = samples.position[e.a], ab = samples.position[e.b] - a;
    const Vec3 normal = edge_normal(mesh, e, face_normal);
    for (int64_t k = 1; k < parts; ++k)
      add_new_sample(samples, table, a + ab * (double(k) / double(parts)), normal);
  }
}

} // namespace

void fill_gaps(const TriangleMesh &mesh, const std::vector<Vec3> &face_normal,
               const vbm_build_options &options, Samples &samples, Progress &progress) {
  if (options.spacing < 0 || mesh.triangle.empty()) return;
  const bool asked = options.spacing > 0;
  progress.tick_slow(0, 1);
  const std::vector<double> edge_length = edge_lengths(mesh, samples.position);
  const double spacing =
      asked ? samples.frame.length_to_unit(options.spacing)
            : choose_spacing(mesh, face_normal, edge_length, options, samples, progress);
  const auto too_many = [&](double needed) {
    check_sample_limit(needed, options,
                       " for a spacing of " + short_number(samples.frame.length_to_input(spacing)));
  };
  samples.gap = spacing;
  if (!(spacing > 0)) return asked ? too_many(HUGE_VAL) : void(); // asked for 0 in doubles

  if (std::none_of(edge_length.begin(), edge_length.end(), [&](double l) { return l > spacing; }))
    return;
  const std::size_t vertices = samples.position.size(); // more samples follow below
  const Lattice lattice(mesh, samples.position, face_normal, edge_length, spacing, progress);
  const double on_edges = samples_on_edges(edge_length, lattice, spacing);
  too_many(static_cast<double>(vertices) + on_edges);
  // Margins leave out a part of the estimate, so only what is far too much is refused unseen.
  if (lattice.estimate() > 8.0 * static_cast<double>(sample_limit(options)))
    too_many(static_cast<double>(vertices) + on_edges + lattice.estimate());
  std::size_t on_faces = 0;
  lattice.visit([&](int32_t, const Vec3 &) {
    if ((++on_faces & 255) == 0) progress.tick(0, 1);
  });
  const double needed = static_cast<double>(vertices) + on_edges + static_cast<double>(on_faces);
  too_many(needed);
  if (on_edges + static_cast<double>(on_faces) == 0) return;

  progress.tick_slow(0, 1);
  PointTable table(static_cast<std::size_t>(needed));
  for (std::size_t v = 0; v < vertices; ++v) {
    if ((v & 1023) == 0) progress.tick(0, 1);
    table.find_or_add(samples.position, samples.position[v], static_cast<int32_t>(v));
  }
  reserve_more(samples, static_cast<std::size_t>(on_edges) + on_faces);
  add_on_edges(mesh, face_normal, edge_length, lattice, spacing, table, samples, progress);
  lattice.visit([&](int32_t t, const Vec3 &p) {
    add_new_sample(samples, table, p, face_normal[t]);
    if ((samples.position.size() & 255) == 0) progress.tick(0, 1);
  });
  samples.spacing = samples.added ? samples.frame.length_to_input(spacing) : 0;
}

} // namespace vbm::impl
