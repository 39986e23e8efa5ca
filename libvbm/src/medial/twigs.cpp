// SPDX-License-Identifier: GPL-3.0-or-later
// In the thesis every inner pole is on the axis, and a bump's poles make a part of a few triangles
// that pruning takes away (7.7). Here such branches were collapsed before there were parts, so
// pruning has to weigh them too, or the bumps would stay however much of the axis goes.
#include "medial/twigs.h"

#include "core/progress.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

/// Ratio to a ball's radius: the chord of 90 degrees. Samples of a ball that far apart are on
/// different sides of the shape.
constexpr double kAcross = 1.414;

/// Share of the volume. Along sharp edges and at bumps there always is some that is too near to the
/// surface for an axis.
constexpr double kThinVolume = 0.15;

/// Every ball that is below others after all that are above it.
std::vector<int32_t> from_the_tips(const std::vector<Twig> &twigs) {
  std::vector<int32_t> above(twigs.size(), 0), order;
  order.reserve(twigs.size());
  for (const Twig &twig : twigs)
    if (twig.below >= 0) ++above[twig.below];
  for (std::size_t b = 0; b < twigs.size(); ++b)
    if (above[b] == 0) order.push_back(int32_t(b));
  for (std::size_t k = 0; k < order.size(); ++k)
    if (const int32_t b = twigs[order[k]].below; b >= 0 && --above[b] == 0) order.push_back(b);
  return order;
}

/// The distance of the two samples of a tetrahedron that are farthest apart.
double widest(const std::vector<Vec3> &at, const std::array<int32_t, 4> &k) {
  double most = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const Vec3 between = at[k[i]] - at[k[j]];
      most = std::max(most, dot(between, between));
    }
  return std::sqrt(most);
}

/// Whether the tetrahedron reaches from one side of the shape to another, but not much farther than
/// its samples lie apart: then the axis was not found there.
bool lies_across(const std::vector<Vec3> &at, const std::vector<double> &spacing,
                 const std::array<int32_t, 4> &k, double radius) {
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const double width = distance(at[k[i]], at[k[j]]);
      if (width >= kAcross * radius && width < kResolved * std::max(spacing[k[i]], spacing[k[j]]))
        return true;
    }
  return false;
}

void add(Twig &to, const Twig &twig) {
  to.cells += twig.cells;
  to.volume += twig.volume;
  to.width = std::max(to.width, twig.width);
  to.angle = std::max(to.angle, twig.angle);
  to.thin |= twig.thin;
}

/// The ball that each collapsed vertex goes with: its own, or else the next one on its way to the
/// axis; -1 if there is none. Sets `below` of the twigs. A ball of several vertices hangs where the
/// first of them does, seen from the axis, and what hangs on any of them hangs on it: as that
/// vertex comes after the first one of the ball below, there are no loops. If one is on the axis,
/// the ball is, and has no twig.
std::vector<int32_t> find_owners(const DualComplex &complex, const Collapsed &left,
                                 const Model &model, std::vector<Twig> &twigs) {
  std::vector<int32_t> owner(complex.ball.size(), -1);
  std::vector<uint8_t> placed(twigs.size(), 0); // it has a vertex that was looked at
  const auto each_ball = [&](const auto &visit) {
    for (std::size_t c = 0; c < model.cells.size(); ++c) {
      const int32_t v = complex.vertex_of_cell[c], b = model.ball_of_cell[c];
      if (v >= 0 && b >= 0 && std::size_t(b) < twigs.size()) visit(v, b);
    }
  };
  each_ball([&](int32_t v, int32_t b) {
    if (left.vertex[v]) placed[b] = 1;
  });
  each_ball([&](int32_t v, int32_t b) {
    if (!placed[b]) owner[v] = b;
  });
  for (std::size_t i = left.gone.size(); i-- > 0;) {
    const int32_t v = left.gone[i], below = owner[left.parent[v]];
    if (owner[v] < 0) {
      owner[v] = below;
    } else if (!placed[owner[v]]) {
      placed[owner[v]] = 1;
      twigs[owner[v]].below = below;
    }
  }
  return owner;
}

} // namespace

bool ThinShare::counts() const { return volume > kThinVolume; }

std::string thin_text(const ThinShare &thin) {
  if (!thin.counts()) return "";
  return std::to_string(std::lround(100 * thin.volume)) +
         " % of the volume has no sheet of its own: the sampling is too thin at " +
         std::to_string(thin.samples) + (thin.samples == 1 ? " sample\n" : " samples\n");
}

std::vector<Twig> find_twigs(const DualComplex &complex, const Collapsed &left, const Model &model,
                             ThinShare &thin, Progress &progress) {
  const Cells &cells = model.cells;
  const std::vector<Vec3> &at = model.samples.position;
  std::vector<Twig> out(model.inner);
  const std::vector<int32_t> owner = find_owners(complex, left, model, out);
  const std::vector<double> spacing = sample_spacing(model, progress);
  std::vector<uint8_t> at_thin(at.size(), 0);
  double whole = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    progress.tick(0, 1);
    const int32_t v = complex.vertex_of_cell[c];
    if (v < 0) continue;
    const auto &k = cells.vertex[c];
    const double volume =
        std::fabs(dot(cross(at[k[1]] - at[k[0]], at[k[2]] - at[k[0]]), at[k[3]] - at[k[0]]));
    whole += volume;
    const bool across = !left.vertex[v] && lies_across(at, spacing, k, complex.ball[v].radius);
    if (across) {
      thin.volume += volume;
      for (int32_t s : k) at_thin[s] = 1;
    }
    if (owner[v] < 0) continue;
    const double width = widest(at, k);
    add(out[owner[v]],
        {-1, 1, volume, float(width), float(width / (2 * complex.ball[v].radius)), across});
  }
  if (whole > 0) thin.volume /= whole;
  thin.samples = std::size_t(std::count(at_thin.begin(), at_thin.end(), 1));
  for (int32_t b : from_the_tips(out))
    if (out[b].below >= 0) add(out[out[b].below], out[b]);
  for (Twig &twig : out) {
    if (whole > 0) twig.volume /= whole;
    twig.angle = float(std::asin(std::min(1.0, double(twig.angle))) * (360 / std::acos(-1.0)));
  }
  return out;
}

std::vector<double> sum_over_twigs(const std::vector<Twig> &twigs, std::vector<double> per_ball) {
  for (int32_t b : from_the_tips(twigs))
    if (twigs[b].below >= 0) per_ball[twigs[b].below] += per_ball[b];
  return per_ball;
}

} // namespace vbm::impl
