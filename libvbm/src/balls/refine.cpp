// SPDX-License-Identifier: GPL-3.0-or-later
// A maximal ball holds no piece of the surface; one that does was built from samples too far apart
// for the thinness of the shape there. Inserting the surface point nearest to its centre is Chew's
// and Boissonnat and Oudot's Delaunay refinement (2005) with circumscribed balls in place of
// surface balls. A new sample keeps a distance of (1 - kShallow) radii from all others, because the
// ball held none, so that refining ends.
#include "balls/refine.h"

#include "balls/stars.h"
#include "core/grid.h"
#include "sampling/add.h"
#include "surface/boundary.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace vbm::impl {

namespace {

/// Ratios to the ball's radius: the mesh must come this near to the centre, or only so near if it
/// shows the centre its other side than the ball's samples do.
constexpr double kDeep = 0.5, kShallow = 0.85;
/// Share of the votes: balls whose samples agree more than this are not looked at.
constexpr float kAgreement = 0.95f;
/// Ratio to the distance of a sample's nearest neighbour: new samples round it lie about this far
/// from it.
constexpr double kRound = 0.6;
/// Ratio to kSmallest: samples that lie nearer together get none round them.
constexpr double kDiskSmallest = 0.25;
/// Cosine: a facet whose normal makes more than 60 degrees with the mesh's normal at one of its
/// samples stands across it. At the corner of a cube the two differ by 55 degrees.
constexpr double kAcross = 0.5;
/// Ratio to a ball's radius or a facet's longest side: new samples keep this far from all others.
constexpr double kApart = 0.2;
/// Ratio to the spacing: smaller balls and facets are not looked at, so that a mesh that passes
/// through itself, where no sampling helps, is not refined without end.
constexpr double kSmallest = 0.1;
/// Samples added in all rounds together: at most this many, and this many times the mesh's
/// vertices. Samples that the spacing added do not count: what they do not resolve, such as spikes
/// without end, more will not either.
constexpr std::size_t kFloor = 20000, kFactor = 2;
class Refinement {
public:
  Refinement(Samples &samples, Delaunay &delaunay, const Round &round, uint64_t sample_limit,
             Progress &progress)
      : samples_(samples), delaunay_(delaunay), cells_(round.cells), balls_(round.balls),
        labels_(round.labels), progress_(progress), before_(samples.position.size()),
        smallest_(kSmallest * samples.gap) {
    limit_ = before_ - samples.refined + kFloor + kFactor * (before_ - samples.added);
    if (sample_limit) limit_ = std::min<std::size_t>(limit_, sample_limit);
  }

  bool run(std::size_t first) {
    look_into_balls(first);
    look_at_disks();
    if (!samples_.normal.empty()) look_at_facets();
    return samples_.position.size() > before_;
  }

private:
  void add(const Vec3 &place, const Vec3 &normal, double apart) {
    const Vec3 point = on_grid(place, kSampleGrid);
    if (samples_.position.size() >= limit_ || !delaunay_.insert_apart(point, apart)) return;
    add_sample(samples_, point, normal);
    ++samples_.refined;
  }

  bool nearest_on_mesh(const Vec3 &center, double radius, Vec3 &point, Vec3 &normal) const {
    if (!samples_.refiner->nearest(center, radius, point, normal)) return false;
    if (samples_.normals_turned) normal = -normal;
    return true;
  }

  /// Balls that touch a sample from number `first` on and that the mesh enters.
  void look_into_balls(std::size_t first) {
    std::vector<int32_t> order;
    std::vector<uint8_t> seen(balls_.ball.size(), 0);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const int32_t b = balls_.of_cell[c];
      if (seen[b]) continue;
      seen[b] = 1;
      bool fresh = false;
      for (int32_t v : cells_.vertex[c]) fresh |= v < cells_.samples && v >= int32_t(first);
      if (fresh && labels_.confidence[b] < kAgreement && balls_.ball[b].radius > smallest_ &&
          !cells_.has_corner(c))
        order.push_back(b);
    }
    std::sort(order.begin(), order.end(), [&](int32_t a, int32_t b) {
      const double ra = balls_.ball[a].radius, rb = balls_.ball[b].radius;
      return ra != rb ? ra > rb : a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
      progress_.tick_slow(i, order.size());
      const Ball &ball = balls_.ball[order[i]];
      Vec3 point, normal;
      if (!nearest_on_mesh(ball.center, ball.radius * kShallow, point, normal)) continue;
      const bool seen_inside = dot(ball.center - point, normal) < 0;
      if (seen_inside != bool(labels_.inside[order[i]]) ||
          distance(ball.center, point) < kDeep * ball.radius)
        add(point, normal, kApart * ball.radius);
    }
  }

  bool inside(int32_t cell) const { return cell >= 0 && labels_.inside[balls_.of_cell[cell]]; }

  /// Samples at which the boundary between inside and outside is not a disk: the sampling is
  /// doubled round them. (Cheng, Dey, Ramos and Ray 2004 add the farthest point of such a star.)
  void look_at_disks() {
    std::vector<uint8_t> inside(cells_.size());
    for (std::size_t c = 0; c < cells_.size(); ++c) inside[c] = labels_.inside[balls_.of_cell[c]];
    const std::vector<Sheets> sheets = find_sheets(cells_, inside, progress_);
    Star star(cells_);
    for (int32_t s = 0; s < cells_.samples; ++s) {
      progress_.tick(s, cells_.samples);
      if (sheets[s] == Sheets::disk) continue;
      star.go_to(s);
      add_round(s, star);
    }
  }

  /// Points of the mesh half way from s to its nearest and its farthest surface neighbours.
  void add_round(int32_t s, const Star &star) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int32_t c : star.cells())
      for (int32_t v : cells_.vertex[c])
        if (v < cells_.samples && v != s)
          nearest = std::min(nearest, distance(samples_.position[v], samples_.position[s]));
    const double reach = nearest * kRound;
    if (reach < smallest_ * kDiskSmallest || !std::isfinite(reach)) return;
    for (int axis = 0; axis < 3; ++axis)
      for (double side : {-reach, reach}) {
        Vec3 probe = samples_.position[s], point, normal;
        probe[axis] += side;
        if (nearest_on_mesh(probe, reach, point, normal)) add(point, normal, kApart * reach);
      }
  }

  /// Facets between inside and outside that stand across the mesh, not along it: they bridge two
  /// sheets that their samples are too sparse to keep apart.
  void look_at_facets() {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      progress_.tick(c, cells_.size());
      if (!inside(int32_t(c))) continue;
      for (int i = 0; i < 4; ++i)
        if (!inside(cells_.neighbor[c][i])) look_at_facet(cells_.vertex[c], kFacet[i]);
    }
  }

  void look_at_facet(const std::array<int32_t, 4> &cell, const int (&facet)[3]) {
    const int32_t v[3] = {cell[facet[0]], cell[facet[1]], cell[facet[2]]};
    const Vec3 &a = samples_.position[v[0]], &b = samples_.position[v[1]],
               &c = samples_.position[v[2]];
    const Vec3 n = unit(cross(b - a, c - a));
    bool across = false;
    for (int32_t s : v) {
      const Vec3 &given = samples_.normal[s];
      across |= dot(given, given) > 0 && dot(n, given) < kAcross;
    }
    const double sides[3] = {distance(a, b), distance(b, c), distance(c, a)};
    const double side = std::max({sides[0], sides[1], sides[2]});
    if (!across || side < smallest_) return;
    // The middle of the longest side bridges the sheets; the mesh below it is where a sample lacks.
    const Vec3 middle = side == sides[0]   ? (a + b) * 0.5
                        : side == sides[1] ? (b + c) * 0.5
                                           : (c + a) * 0.5;
    Vec3 point, normal;
    if (!nearest_on_mesh(middle, side, point, normal)) return;
    add(point, normal, kApart * side);
  }

  Samples &samples_;
  Delaunay &delaunay_;
  const Cells &cells_;
  const BallSet &balls_;
  const Labels &labels_;
  Progress &progress_;
  std::size_t before_, limit_;
  double smallest_; // unit lengths
};

} // namespace

std::size_t count_faults(const Samples &samples, const Round &round, Progress &progress) {
  const Boundary boundary = find_boundary(round.cells, round.inside, progress);
  std::size_t faults = boundary.split;
  if (samples.components) { // else samples may rightly lie inside, where parts of the mesh overlap
    const std::size_t on_it = boundary.sample.size() - boundary.split;
    faults += std::size_t(round.cells.samples) - on_it;
    faults += kWrongTopology * std::size_t(std::llabs(boundary.euler() - samples.euler) +
                                           std::llabs(int64_t(boundary.components(progress)) -
                                                      int64_t(samples.components)));
  }
  return faults;
}

bool refine(Samples &samples, Delaunay &delaunay, const Round &round, uint64_t sample_limit,
            Progress &progress) {
  return Refinement(samples, delaunay, round, sample_limit, progress).run(round.fresh);
}

void remove_samples_from(Samples &samples, std::size_t count) {
  const std::size_t surplus = samples.position.size() - count;
  samples.position.resize(count);
  if (!samples.normal.empty()) samples.normal.resize(count);
  samples.input.resize(count);
  samples.input_position.resize(count);
  samples.added -= surplus;
  samples.refined -= surplus;
}

} // namespace vbm::impl
