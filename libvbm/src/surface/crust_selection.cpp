// SPDX-License-Identifier: GPL-3.0-or-later
// Polar balls give a crust of the right topology where the sampling is dense enough (Amenta, Choi,
// Kolluri 2001). The power cells of *all* Voronoi balls are the Delaunay tetrahedra themselves,
// because two balls have the facet between them in their common radical plane; so every Voronoi
// ball added on both sides of the surface brings the crust nearer to the boundary of the inside
// tetrahedra.
#include "surface/crust_selection.h"

#include "balls/circumcenter.h"
#include "core/error.h"
#include "core/progress.h"

#include <algorithm>

namespace vbm::impl {

std::pair<const int32_t *, const int32_t *> Selection::samples_of(const Model &model,
                                                                  int32_t b) const {
  const std::size_t o = std::size_t(origin[b]);
  if (o >= model.balls.size()) {
    const auto &s = support_samples[o - model.balls.size()];
    return {s.data(), s.data() + 4};
  }
  const Incidence &lists = model.ball_samples;
  return {lists.index.data() + lists.offset[o], lists.index.data() + lists.offset[o + 1]};
}

int32_t Selection::model_ball(const Model &model, int32_t b) const {
  const std::size_t o = std::size_t(origin[b]);
  return o < model.balls.size() ? origin[b] : support_ball[o - model.balls.size()];
}

Selection select_balls(const Model &model, const uint8_t *keep, const uint8_t *keep_outer) {
  Selection s;
  s.balls.reserve(model.balls.size());
  s.origin.reserve(model.balls.size());
  for (std::size_t b = 0; b < model.balls.size(); ++b) {
    if (b < model.inner && keep && !keep[b]) continue;
    if (b >= model.inner && keep_outer && !keep_outer[b - model.inner]) continue;
    s.inner += b < model.inner;
    s.balls.push_back(model.balls[b]);
    s.origin.push_back(int32_t(b));
  }
  if (s.inner == 0)
    throw Error(VBM_ERROR_NO_INTERIOR, keep && model.inner
                                           ? "no inner ball is kept, so there is no surface"
                                           : "the model has no inner ball, so there is no surface");
  return s;
}

Selection select_with_support(const Model &model, Progress &progress) {
  const Cells &cells = model.cells;
  std::vector<uint8_t> thin(cells.samples, 0);
  for (int32_t s : model.undersampled) thin[s] = 1;
  std::vector<int32_t> wanted[2]; // cells outside, inside
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells.has_corner(c) || model.ball_of_cell[c] >= 0) continue;
    for (int32_t v : cells.vertex[c])
      if (thin[v]) {
        wanted[model.inside[c]].push_back(int32_t(c));
        break;
      }
  }
  Selection s;
  const auto add_model = [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      s.balls.push_back(model.balls[b]);
      s.origin.push_back(int32_t(b));
    }
  };
  const auto add_support = [&](int inside) {
    for (int32_t c : wanted[inside]) {
      progress.tick(s.balls.size(), cells.size());
      double condition;
      s.balls.push_back(circumball(cells, model.samples.position, std::size_t(c), &condition));
      s.origin.push_back(int32_t(model.balls.size() + s.support_ball.size()));
      std::array<int32_t, 4> touched = cells.vertex[c];
      std::sort(touched.begin(), touched.end());
      s.support_samples.push_back(touched);
      int32_t ball = -1;
      for (int32_t v : touched)
        if (inside && ball < 0) ball = model.inner_pole[v];
      s.support_ball.push_back(ball);
    }
  };
  add_model(0, model.inner);
  add_support(1);
  s.inner = s.balls.size();
  add_model(model.inner, model.balls.size());
  add_support(0);
  return s;
}

} // namespace vbm::impl
