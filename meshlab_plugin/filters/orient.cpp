// SPDX-License-Identifier: GPL-3.0-or-later
#include "orient.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace vbm_filters {
namespace {

struct Edge {
  std::int32_t low, high;
  std::size_t corner; // the edge runs from it to the next one of its triangle
  bool same(const Edge &o) const { return low == o.low && high == o.high; }
  bool operator<(const Edge &o) const {
    return std::tie(low, high, corner) < std::tie(o.low, o.high, o.corner);
  }
};

// The z component of a triangle's area vector.
double facing(const std::int32_t *t, const std::vector<double> &points) {
  const double *a = &points[3 * t[0]], *b = &points[3 * t[1]], *c = &points[3 * t[2]];
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

} // namespace

void orient_sheets(std::vector<std::int32_t> &triangles, const std::vector<double> &points) {
  std::vector<Edge> edges(triangles.size());
  for (std::size_t c = 0; c < triangles.size(); ++c) {
    const std::int32_t a = triangles[c], b = triangles[c % 3 == 2 ? c - 2 : c + 1];
    edges[c] = {std::min(a, b), std::max(a, b), c};
  }
  std::sort(edges.begin(), edges.end());
  // Corner by corner, the corner at which the sheet goes on across the edge.
  constexpr std::size_t kNone = std::size_t(-1);
  std::vector<std::size_t> across(triangles.size(), kNone);
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    for (j = i + 1; j < edges.size() && edges[j].same(edges[i]);) ++j;
    if (j - i != 2) continue;
    across[edges[i].corner] = edges[i + 1].corner;
    across[edges[i + 1].corner] = edges[i].corner;
  }

  std::vector<std::uint8_t> seen(triangles.size() / 3, 0), turned(seen.size(), 0);
  std::vector<std::size_t> sheet;
  for (std::size_t first = 0; first < seen.size(); ++first) {
    if (seen[first]) continue;
    seen[first] = 1;
    sheet.assign(1, first);
    double sum = 0;
    for (std::size_t next = 0; next < sheet.size(); ++next) {
      const std::size_t t = sheet[next];
      const double z = facing(&triangles[3 * t], points);
      sum += turned[t] ? -z : z;
      for (std::size_t c = 3 * t; c < 3 * t + 3; ++c) {
        const std::size_t o = across[c];
        if (o == kNone || seen[o / 3]) continue;
        seen[o / 3] = 1;
        // Two triangles that face the same way run along their edge in opposite directions.
        turned[o / 3] = turned[t] != (triangles[c] == triangles[o]);
        sheet.push_back(o / 3);
      }
    }
    if (sum < 0)
      for (std::size_t t : sheet) turned[t] = !turned[t];
  }
  for (std::size_t t = 0; t < turned.size(); ++t)
    if (turned[t]) std::swap(triangles[3 * t + 1], triangles[3 * t + 2]);
}

} // namespace vbm_filters
