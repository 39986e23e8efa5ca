// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/arrange_cells.h"

#include "core/progress.h"

#include <algorithm>

namespace vbm::impl {

LargeList<PowerDiagram::Cell> arranged(const LargeList<PowerDiagram::Cell> &cells,
                                       std::size_t balls, Progress &progress) {
  const std::size_t keys = balls + 4; // far corners, too
  std::vector<uint32_t> first(keys + 2, 0), number(cells.size());
  const auto key = [&](const PowerDiagram::Cell &c) {
    return c.ball[0] < 0 ? keys : std::size_t(*std::min_element(c.ball.begin(), c.ball.end()));
  };
  for (const PowerDiagram::Cell &c : cells) {
    progress.tick(0, 1);
    ++first[key(c) + 1];
  }
  for (std::size_t k = 0; k <= keys; ++k) first[k + 1] += first[k];
  const std::size_t count = first[keys];
  for (std::size_t c = 0; c < cells.size(); ++c) {
    progress.tick(0, 1);
    number[c] = first[key(cells[c])]++;
  }
  LargeList<PowerDiagram::Cell> out(count);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    progress.tick(0, 1);
    if (number[c] >= count) continue;
    PowerDiagram::Cell &to = out[number[c]];
    to = cells[c];
    for (int32_t &n : to.neighbor)
      if (n >= 0) n = int32_t(4 * number[n >> 2]) + (n & 3);
  }
  return out;
}

} // namespace vbm::impl
