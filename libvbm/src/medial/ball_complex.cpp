// SPDX-License-Identifier: GPL-3.0-or-later
#include "medial/ball_complex.h"

#include <algorithm>

namespace vbm::impl {

BallComplex complex_of(const AxisCells &cells, const AxisState &state,
                       std::vector<int32_t> *number) {
  BallComplex out;
  std::vector<int32_t> own;
  std::vector<int32_t> &of = number ? *number : own;
  of.assign(cells.ball.size(), -1);
  for (std::size_t v = 0; v < of.size(); ++v) {
    if (!state.vertex[v]) continue;
    of[v] = int32_t(out.ball.size());
    out.ball.push_back(cells.ball[v]);
  }
  std::vector<uint8_t> curve = state.edge;
  for (std::size_t t = 0; t < cells.triangle.size(); ++t) {
    if (!state.triangle[t]) continue;
    const auto &v = cells.triangle[t];
    out.triangle.push_back({of[v[0]], of[v[1]], of[v[2]]});
    for (int32_t e : cells.triangle_edges[t]) curve[e] = 0;
  }
  for (std::size_t e = 0; e < curve.size(); ++e)
    if (curve[e]) out.edge.push_back({of[cells.edge[e][0]], of[cells.edge[e][1]]});
  return out;
}

std::vector<std::array<int32_t, 2>> all_edges(const BallComplex &complex) {
  std::vector<std::array<int32_t, 2>> out = complex.edge;
  for (const auto &t : complex.triangle)
    for (int i = 0; i < 3; ++i) out.push_back({t[i], t[(i + 1) % 3]});
  for (auto &e : out)
    if (e[0] > e[1]) std::swap(e[0], e[1]);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

} // namespace vbm::impl
