// SPDX-License-Identifier: GPL-3.0-or-later
// The poles of thesis 3.1.2 (Amenta, Bern, Kolluri): a sample's inner pole is the farthest of its
// Voronoi vertices that is inside, its outer pole the farthest outside. The labels decide the side,
// so the thesis's search for "the farthest at more than a right angle from the first pole" is not
// needed.
#include "balls/poles.h"

#include <algorithm>

namespace vbm::impl {

namespace {

/// Ball of each cell with its side, as 2 * ball + inside: the repair of labels may have put cells
/// of one ball on both sides, and then it counts on each.
std::size_t key(const Model &model, const BallSet &balls, std::size_t cell) {
  return 2 * std::size_t(balls.of_cell[cell]) + model.inside[cell];
}

/// Lists per element, each ascending and without repeats. visit(add) calls add(element, index) for
/// everything there is; it is called twice, to count and to fill.
template <class Visit> Incidence group(std::size_t elements, Progress &progress, Visit visit) {
  Incidence out;
  out.offset.assign(elements + 1, 0);
  visit([&](int32_t element, int32_t) { ++out.offset[element + 1]; });
  for (std::size_t e = 0; e < elements; ++e) out.offset[e + 1] += out.offset[e];
  std::vector<uint64_t> next(out.offset.begin(), out.offset.end() - 1);
  out.index.resize(out.offset.back());
  visit([&](int32_t element, int32_t index) { out.index[next[element]++] = index; });
  uint64_t kept = 0; // lists move down as they lose their repeats
  for (std::size_t e = 0; e < elements; ++e) {
    progress.tick(1, 1);
    const auto begin = out.index.begin() + int64_t(out.offset[e]);
    const auto end = out.index.begin() + int64_t(next[e]);
    std::sort(begin, end);
    out.offset[e] = kept;
    for (auto i = begin; i != end; ++i)
      if (i == begin || *i != out.index[kept - 1]) out.index[kept++] = *i;
  }
  out.offset[elements] = kept;
  out.index.resize(kept);
  out.index.shrink_to_fit();
  return out;
}

} // namespace

void collect_balls(Model &model, const BallSet &balls, vbm_balls which, Progress &progress) {
  const Cells &cells = model.cells;
  const int32_t samples = cells.samples;
  std::vector<int64_t> pole[2];
  std::vector<double> reach[2]; // the pole's radius
  for (int inside = 0; inside < 2; ++inside) {
    pole[inside].assign(samples, -1);
    reach[inside].assign(samples, -1);
  }
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const double radius = balls.ball[balls.of_cell[c]].radius;
    const int inside = model.inside[c];
    for (int32_t v : cells.vertex[c])
      if (v < samples && reach[inside][v] < radius) {
        reach[inside][v] = radius;
        pole[inside][v] = int64_t(key(model, balls, c));
      }
    progress.tick(c, cells.size());
  }

  constexpr int32_t kUnwanted = -1, kWanted = 0; // until they are numbered
  std::vector<int32_t> number(2 * balls.ball.size(), kUnwanted);
  for (const auto &poles : pole)
    for (int64_t p : poles)
      if (p >= 0) number[p] = kWanted;
  if (which == VBM_BALLS_VORONOI)
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (model.inside[c]) number[key(model, balls, c)] = kWanted;
  for (int inside = 1; inside >= 0; --inside) {
    for (std::size_t b = 0; b < balls.ball.size(); ++b) {
      progress.tick(1, 1);
      if (int32_t &n = number[2 * b + inside]; n == kWanted) {
        n = int32_t(model.balls.size());
        model.balls.push_back(balls.ball[b]);
      }
    }
    if (inside) model.inner = model.balls.size();
  }

  model.ball_of_cell.resize(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    progress.tick(1, 1);
    model.ball_of_cell[c] = number[key(model, balls, c)];
  }
  model.ball_samples = group(model.balls.size(), progress, [&](auto add) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      progress.tick(c, cells.size());
      if (model.ball_of_cell[c] < 0) continue;
      for (int32_t v : cells.vertex[c])
        if (v < samples) add(model.ball_of_cell[c], v);
    }
  });

  model.inner_pole.resize(samples);
  model.outer_pole.resize(samples);
  for (int32_t s = 0; s < samples; ++s) {
    model.inner_pole[s] = pole[1][s] < 0 ? -1 : number[pole[1][s]];
    model.outer_pole[s] = pole[0][s] < 0 ? -1 : number[pole[0][s]];
  }
}

void find_neighbors(Model &model, Progress &progress) {
  const std::size_t count = model.balls.size();
  const auto side = [&](int32_t b) { return std::size_t(b) < model.inner; };
  model.ball_neighbors = group(count, progress, [&](auto add) {
    const auto pair = [&](int32_t a, int32_t b) {
      if (a < 0 || b < 0 || a == b || side(a) != side(b)) return;
      add(a, b);
      add(b, a);
    };
    for (std::size_t c = 0; c < model.cells.size(); ++c) {
      progress.tick(c, model.cells.size());
      if (model.ball_of_cell[c] < 0) continue;
      for (int32_t n : model.cells.neighbor[c])
        if (n > int32_t(c)) pair(model.ball_of_cell[c], model.ball_of_cell[n]);
    }
    for (std::size_t b = 0; b < count; ++b) {
      progress.tick(b, count);
      for (uint64_t k = model.ball_samples.offset[b]; k < model.ball_samples.offset[b + 1]; ++k) {
        const int32_t s = model.ball_samples.index[k];
        pair(int32_t(b), b < model.inner ? model.inner_pole[s] : model.outer_pole[s]);
      }
    }
  });
}

} // namespace vbm::impl
