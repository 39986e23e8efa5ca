// SPDX-License-Identifier: GPL-3.0-or-later
// A sample outside the envelope is as far from it as from the nearest primitive. One inside is as
// far from the boundary as it is deep in the primitive it is deepest in, if the point of that
// primitive's boundary it is nearest to is bare. If another primitive covers that point, points
// spread over the envelope tell: the nearest of them, or the first bare point straight outwards,
// whichever is nearer.
#include "medial/mesh_errors.h"

#include "core/progress.h"
#include "medial/envelope_samples.h"
#include "surface/boundary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vbm::impl {
namespace {

/// Share of the diagonal: how far apart points on the envelope are. About 60,000 points on a ball.
constexpr double kEnvelopeSpacing = 1.0 / 256;

/// Unit lengths. Points deeper than this are covered: more than rounding.
constexpr double kCovered = 1e-9;

/// Steps outwards until a bare point is found; every one of them leaves the primitive it is in.
constexpr int kMostSteps = 64;

double diagonal_of(const Model &model) {
  return model.samples.frame.length_to_unit(model.report.diagonal);
}

/// How far it is from p straight along n until no primitive covers the point.
double way_out(const Envelope &envelope, const Vec3 &p, const Vec3 &n, double start) {
  double way = start;
  for (int i = 0; i < kMostSteps; ++i) {
    const EnvelopeHit hit = envelope.nearest(p + n * way);
    if (hit.distance >= -kCovered) return way;
    // From inside a primitive, straight on to its boundary.
    const Ball ball = envelope.at(hit);
    const Vec3 q = p + n * way - ball.center;
    const double along = dot(q, n);
    const double root = along * along - dot(q, q) + ball.radius * ball.radius;
    way += std::max(-hit.distance, std::sqrt(std::max(0.0, root)) - along);
  }
  return way;
}

} // namespace

Shape shape_of(const Model &model, Progress &progress) {
  const Boundary boundary = find_boundary(model.cells, model.inside, progress);
  Shape out;
  out.sample = boundary.sample;
  std::sort(out.sample.begin(), out.sample.end());
  out.sample.erase(std::unique(out.sample.begin(), out.sample.end()), out.sample.end());
  const std::vector<Vec3> &at = model.samples.position;
  out.triangle.resize(boundary.triangle.size());
  for (std::size_t t = 0; t < out.triangle.size(); ++t) {
    Triangle &v = out.triangle[t];
    for (int i = 0; i < 3; ++i) v[i] = boundary.sample[boundary.triangle[t][i]];
    out.area += length(cross(at[v[1]] - at[v[0]], at[v[2]] - at[v[0]])) / 2;
  }
  out.tree = TriangleTree(at, out.triangle, {}, progress);
  return out;
}

MeshErrors mesh_errors(const BallComplex &complex, const Shape &shape, const Model &model,
                       Progress &progress) {
  MeshErrors out;
  if (complex.ball.empty() || shape.sample.empty()) return out;
  const Envelope envelope(complex, progress);
  const EnvelopeSamples points =
      sample_envelope(complex, envelope, kEnvelopeSpacing * diagonal_of(model), progress);

  double sum = 0, weight = 0;
  for (std::size_t i = 0; i < points.point.size(); ++i) {
    progress.tick(i, points.point.size());
    TriangleTree::Nearest found;
    found.distance = std::numeric_limits<double>::infinity();
    if (!shape.tree.nearest(points.point[i], found)) continue;
    out.envelope_max = std::max(out.envelope_max, found.distance);
    sum += found.distance * points.area[i];
    weight += points.area[i];
  }
  out.envelope_mean = weight > 0 ? sum / weight : 0;

  BallComplex cloud; // of the points
  for (const Vec3 &p : points.point) cloud.ball.push_back({p, 0});
  const Envelope nearest(cloud, progress);
  sum = 0;
  for (std::size_t i = 0; i < shape.sample.size(); ++i) {
    progress.tick(i, shape.sample.size());
    const Vec3 &p = model.samples.position[shape.sample[i]];
    const EnvelopeHit hit = envelope.nearest(p);
    double d = std::fabs(hit.distance);
    if (hit.distance < 0) {
      const Ball ball = envelope.at(hit);
      const Vec3 n = unit(p - ball.center);
      if (envelope.covers(ball.center + n * ball.radius, kCovered)) {
        d = way_out(envelope, p, n, d);
        if (!cloud.ball.empty()) d = std::min(d, nearest.nearest(p).distance);
      }
    }
    out.sample_max = std::max(out.sample_max, d);
    sum += d;
  }
  out.sample_mean = sum / double(shape.sample.size());
  return out;
}

} // namespace vbm::impl
