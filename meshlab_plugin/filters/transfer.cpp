// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer.h"

#include <array>

namespace vbm_filters {

std::vector<Color> transfer_colors(const std::vector<Color> &input_colors,
                                   const std::vector<std::int32_t> &vertex_input,
                                   const std::vector<std::int32_t> &triangles) {
  std::vector<Color> colors(vertex_input.size());
  std::vector<std::uint8_t> known(vertex_input.size(), 0);
  for (std::size_t v = 0; v < vertex_input.size(); ++v)
    if (vertex_input[v] >= 0 && static_cast<std::size_t>(vertex_input[v]) < input_colors.size()) {
      colors[v] = input_colors[vertex_input[v]];
      known[v] = 1;
    }

  // Ring by ring. Samples lie thick on the surface, so a few rings reach every vertex; the limit is
  // for surfaces on which hardly any vertex is an input vertex, which stay white far from those.
  constexpr int kRings = 64;
  for (int ring = 0; ring < kRings; ++ring) {
    std::vector<std::array<std::uint32_t, 5>> sums(colors.size(), {0, 0, 0, 0, 0});
    std::vector<std::int32_t> reached;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const std::size_t first = i - i % 3;
      const std::int32_t to = triangles[i];
      if (known[to]) continue;
      for (std::size_t k = first; k < first + 3; ++k) {
        const std::int32_t from = triangles[k];
        if (!known[from]) continue;
        auto &sum = sums[to];
        if (sum[4]++ == 0) reached.push_back(to);
        const Color &c = colors[from];
        const std::array<std::uint8_t, 4> parts = {c.r, c.g, c.b, c.a};
        for (int p = 0; p < 4; ++p) sum[p] += parts[p];
      }
    }
    if (reached.empty()) break;
    for (std::int32_t v : reached) {
      const auto &sum = sums[v];
      const auto mean = [&](int p) {
        return static_cast<std::uint8_t>((sum[p] + sum[4] / 2) / sum[4]);
      };
      colors[v] = {mean(0), mean(1), mean(2), mean(3)};
      known[v] = 1;
    }
  }
  return colors;
}

} // namespace vbm_filters
