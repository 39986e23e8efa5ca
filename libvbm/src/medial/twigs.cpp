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

/// Every element that is below another (below[i] >= 0) after all that are above it.
std::vector<int32_t> from_the_tips(const std::vector<int32_t> &below) {
  std::vector<int32_t> above(below.size(), 0), order;
  order.reserve(below.size());
  for (int32_t b : below)
    if (b >= 0) ++above[b];
  for (std::size_t i = 0; i < below.size(); ++i)
    if (above[i] == 0) order.push_back(int32_t(i));
  for (std::size_t k = 0; k < order.size(); ++k)
    if (const int32_t b = below[order[k]]; b >= 0 && --above[b] == 0) order.push_back(b);
  return order;
}

/// The distance of the two samples of a tetrahedron that are farthest apart.
double widest(const std::vector<Vec3> &at, const std::array<int32_t, 4> &k) {
  double most = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) most = std::max(most, distance(at[k[i]], at[k[j]]));
  return most;
}

void add(Twig &to, const Twig &twig) {
  to.cells += twig.cells;
  to.volume += twig.volume;
  to.width = std::max(to.width, twig.width);
  to.angle = std::max(to.angle, twig.angle);
}

} // namespace

std::vector<Twig> find_twigs(const DualComplex &complex, const Collapsed &left, const Model &model,
                             Progress &progress) {
  const Cells &cells = model.cells;
  const std::vector<Vec3> &at = model.samples.position;
  const std::size_t count = complex.ball.size();
  std::vector<Twig> of_vertex(count);
  std::vector<int32_t> ball_of_vertex(count, -1);
  double whole = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    progress.tick(0, 1);
    const int32_t v = complex.vertex_of_cell[c];
    if (v < 0) continue;
    const auto &k = cells.vertex[c];
    const double volume =
        std::fabs(dot(cross(at[k[1]] - at[k[0]], at[k[2]] - at[k[0]]), at[k[3]] - at[k[0]]));
    whole += volume;
    if (left.vertex[v]) continue;
    const double width = widest(at, k), sine = std::min(1.0, width / (2 * complex.ball[v].radius));
    add(of_vertex[v],
        {-1, 1, volume, float(width), float(std::asin(sine) * (360 / std::acos(-1.0)))});
    const int32_t b = model.ball_of_cell[c];
    if (b >= 0 && std::size_t(b) < model.inner) ball_of_vertex[v] = b;
  }

  std::vector<int32_t> below(count, -1);
  for (std::size_t v = 0; v < count; ++v)
    if (!left.vertex[v] && !left.vertex[left.parent[v]]) below[v] = left.parent[v];
  const std::vector<int32_t> order = from_the_tips(below);
  for (int32_t v : order)
    if (below[v] >= 0) add(of_vertex[below[v]], of_vertex[v]);
  std::vector<Twig> out(model.inner);
  std::vector<int32_t> ball_below(count, -1); // the first ball on the way to the axis
  for (std::size_t k = order.size(); k-- > 0;) {
    const int32_t v = order[k], w = below[v];
    if (w >= 0) ball_below[v] = ball_of_vertex[w] >= 0 ? ball_of_vertex[w] : ball_below[w];
    const int32_t b = ball_of_vertex[v];
    if (b < 0) continue;
    out[b] = of_vertex[v];
    out[b].below = ball_below[v];
    if (whole > 0) out[b].volume /= whole;
  }
  return out;
}

std::vector<double> sum_over_twigs(const std::vector<Twig> &twigs, std::vector<double> per_ball) {
  std::vector<int32_t> below(twigs.size());
  for (std::size_t b = 0; b < twigs.size(); ++b) below[b] = twigs[b].below;
  for (int32_t b : from_the_tips(below))
    if (below[b] >= 0) per_ball[below[b]] += per_ball[b];
  return per_ball;
}

} // namespace vbm::impl
