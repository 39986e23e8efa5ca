// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/fill.h"

#include "core/error.h"
#include "core/progress.h"
#include "sampling/add.h"
#include "sampling/checks.h"
#include "sampling/face_normals.h"
#include "sampling/lattice.h"
#include "sampling/point_table.h"
#include "sampling/spacing.h"
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

struct FacePoint {
  int32_t triangle;
  Vec3 point;
  double spacing;
};

/// The lattice's points; false, and no memory taken for more, if there are more than `most`.
bool collect(const Lattice &lattice, double most, std::vector<FacePoint> &points,
             Progress &progress) {
  double count = 0;
  points.clear();
  lattice.visit([&](int32_t t, const Vec3 &p, double spacing) {
    if ((std::size_t(++count) & 255) == 0) progress.tick(0, 1);
    if (count <= most) points.push_back({t, p, spacing});
  });
  return count <= most;
}

void add_on_edges(const TriangleMesh &mesh, const std::vector<Vec3> &face_normal,
                  const std::vector<double> &parts, const Lattice &lattice,
                  const SpacingField &field, PointTable &table, Samples &samples,
                  Progress &progress) {
  for (std::size_t i = 0; i < mesh.edge.size(); ++i) {
    if ((i & 1023) == 0) progress.tick(0, 1);
    const Edge &e = mesh.edge[i];
    if (lattice.within_patch(i) || parts[i] < 2) continue;
    const Vec3 a = samples.position[e.a], ab = samples.position[e.b] - a;
    const Vec3 normal = edge_normal(mesh, e, face_normal);
    cut_edge(a, a + ab, parts[i], field,
             [&](double share) { add_new_sample(samples, table, a + ab * share, normal); });
  }
}

class Filler {
public:
  Filler(const TriangleMesh &mesh, const std::vector<Vec3> &face_normal,
         const vbm_build_options &options, Samples &samples, Progress &progress)
      : mesh_(mesh), face_normal_(face_normal), options_(options), samples_(samples),
        progress_(progress), edge_length_(edge_lengths(mesh, samples.position)) {}

  void as_asked() {
    const double spacing = samples_.frame.length_to_unit(options_.spacing);
    samples_.gap = spacing;
    if (!(spacing > 0)) return check(HUGE_VAL, spacing); // 0 in doubles
    fill(SpacingField(spacing), spacing, HUGE_VAL);
  }

  void as_needed(const TriangleTree &tree, const BuriedTest *buried) {
    SpacingChoice choice({mesh_, face_normal_, edge_length_, tree, buried}, options_, samples_,
                         progress_);
    while (choice.get().top > 0 &&
           !fill(choice.get().field, choice.get().top, choice.most() * kMostOverEstimate))
      choice.coarsen();
    samples_.gap = choice.get().field.most();
    choice.note(samples_);
  }

private:
  void check(double needed, double spacing) const {
    check_sample_limit(needed, options_,
                       " for a spacing of " +
                           short_number(samples_.frame.length_to_input(spacing)));
  }

  /// False, with nothing added, if that would be more samples than `most`, of a spacing that
  /// varies.
  bool fill(const SpacingField &field, double top, double most) {
    const std::vector<double> parts =
        edge_parts(mesh_, samples_.position, edge_length_, field, progress_);
    if (std::none_of(parts.begin(), parts.end(), [](double p) { return p > 1; })) return true;
    const auto vertices = static_cast<double>(samples_.position.size());
    const Lattice lattice(mesh_, samples_.position, face_normal_, edge_length_, parts, field, top,
                          progress_);
    const double on_edges = lattice.samples_on_edges();
    std::vector<FacePoint> points;
    double on_faces = 0;
    if (field.constant()) {
      check(vertices + on_edges, top);
      // Margins leave out a part of the estimate, so only what is far too much is refused unseen.
      if (lattice.estimate() > 8.0 * static_cast<double>(sample_limit(options_)))
        check(vertices + on_edges + lattice.estimate(), top);
      lattice.visit([&](int32_t, const Vec3 &, double) {
        if ((std::size_t(++on_faces) & 255) == 0) progress_.tick(0, 1);
      });
      check(vertices + on_edges + on_faces, top);
    } else {
      if (!collect(lattice, most - on_edges, points, progress_)) return false;
      on_faces = static_cast<double>(points.size());
    }
    if (on_edges + on_faces == 0) return true;
    add(field, parts, lattice, points, static_cast<std::size_t>(on_edges + on_faces));
    if (!field.constant()) {
      top = 0;
      for (const FacePoint &p : points) top = std::max(top, p.spacing);
      for (std::size_t e = 0; e < parts.size(); ++e)
        if (parts[e] > 1 && !lattice.within_patch(e))
          top = std::max(top, edge_length_[e] / parts[e]);
    }
    samples_.spacing = samples_.added ? samples_.frame.length_to_input(top) : 0;
    return true;
  }

  void add(const SpacingField &field, const std::vector<double> &parts, const Lattice &lattice,
           const std::vector<FacePoint> &points, std::size_t count) {
    progress_.tick_slow(0, 1);
    const std::size_t vertices = samples_.position.size(); // more samples follow below
    PointTable table(vertices + count);
    for (std::size_t v = 0; v < vertices; ++v) {
      if ((v & 1023) == 0) progress_.tick(0, 1);
      table.find_or_add(samples_.position, samples_.position[v], static_cast<int32_t>(v));
    }
    reserve_more(samples_, count);
    add_on_edges(mesh_, face_normal_, parts, lattice, field, table, samples_, progress_);
    const auto put = [&](int32_t t, const Vec3 &p, double) {
      add_new_sample(samples_, table, p, face_normal_[t]);
      if ((samples_.position.size() & 255) == 0) progress_.tick(0, 1);
    };
    if (field.constant()) return lattice.visit(put);
    for (const FacePoint &p : points) put(p.triangle, p.point, p.spacing);
  }

  const TriangleMesh &mesh_;
  const std::vector<Vec3> &face_normal_;
  const vbm_build_options &options_;
  Samples &samples_;
  Progress &progress_;
  std::vector<double> edge_length_;
};

} // namespace

void fill_gaps(const TriangleMesh &mesh, const std::vector<Vec3> &face_normal,
               const TriangleTree &tree, const BuriedTest *buried, const vbm_build_options &options,
               Samples &samples, Progress &progress) {
  if (options.spacing < 0 || mesh.triangle.empty()) return;
  progress.tick_slow(0, 1);
  Filler filler(mesh, face_normal, options, samples, progress);
  options.spacing > 0 ? filler.as_asked() : filler.as_needed(tree, buried);
}

} // namespace vbm::impl
