// SPDX-License-Identifier: GPL-3.0-or-later
// The r-sample condition of Amenta and Bern (thesis 3.2.2), tested with what the samples know: the
// medial radii of the poles stand for the local feature size, and the circumradius of a surface
// triangle for the distance from the surface to its nearest sample. Compare Dey and Giesen,
// "Detecting undersampling in surface reconstruction" (2001), who compare a Voronoi cell's width
// and height: the same two lengths.
#include "balls/undersampling.h"

#include <algorithm>
#include <limits>

namespace vbm::impl {

namespace {

double circumradius(const Vec3 &a, const Vec3 &b, const Vec3 &c) {
  const double area2 = length(cross(b - a, c - a));
  const double product = distance(a, b) * distance(b, c) * distance(c, a);
  return area2 > 0 ? product / (2 * area2) : std::numeric_limits<double>::infinity();
}

} // namespace

void find_undersampled(Model &model, double ratio, Progress &progress) {
  const Cells &cells = model.cells;
  const auto &position = model.samples.position;
  std::vector<double> reach(cells.samples, -1); // largest circumradius of the triangles at a sample
  for (std::size_t c = 0; c < cells.size(); ++c) {
    progress.tick(c, cells.size());
    if (!model.inside[c]) continue;
    for (int i = 0; i < 4; ++i) {
      const int32_t n = cells.neighbor[c][i];
      if (n >= 0 && model.inside[n]) continue;
      int32_t v[3];
      for (int k = 0; k < 3; ++k) v[k] = cells.vertex[c][kFacet[i][k]];
      const double r = circumradius(position[v[0]], position[v[1]], position[v[2]]);
      for (int32_t s : v) reach[s] = std::max(reach[s], r);
    }
  }
  for (int32_t s = 0; s < cells.samples; ++s) {
    bool thin = reach[s] < 0;
    model.report.unused_samples += thin;
    for (int32_t b : {model.inner_pole[s], model.outer_pole[s]})
      thin |= b < 0 || reach[s] > ratio * model.balls[b].radius;
    if (thin) model.undersampled.push_back(s);
  }
}

} // namespace vbm::impl
