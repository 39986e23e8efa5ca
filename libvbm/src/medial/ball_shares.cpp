// SPDX-License-Identifier: GPL-3.0-or-later
#include "medial/ball_shares.h"

#include "measure/union_measures.h"

namespace vbm::impl {

std::vector<double> sum_by_part(const AxisParts &parts, const std::vector<double> &per_vertex) {
  std::vector<double> out(parts.list.size(), 0);
  for (std::size_t v = 0; v < per_vertex.size(); ++v)
    if (parts.of_vertex[v] >= 0) out[parts.of_vertex[v]] += per_vertex[v];
  return out;
}

const std::vector<double> &BallShares::per_ball(const Model &model, Progress &progress) {
  return per_ball_.get([&] {
    const std::vector<Ball> balls(model.balls.begin(), model.balls.begin() + int64_t(model.inner));
    UnionMeasures measures = union_measures(balls, 0, progress);
    for (double &volume : measures.ball_volume) volume /= measures.volume;
    return std::move(measures.ball_volume);
  });
}

const std::vector<double> &BallShares::get(const Model &model, const AxisCells &cells,
                                           Progress &progress) {
  return per_vertex_.get([&] {
    const std::vector<double> &share = per_ball(model, progress);
    std::vector<double> out(cells.ball.size(), 0);
    for (std::size_t b = 0; b < share.size(); ++b)
      if (cells.vertex_of_ball[b] >= 0) out[cells.vertex_of_ball[b]] += share[b];
    return out;
  });
}

} // namespace vbm::impl
