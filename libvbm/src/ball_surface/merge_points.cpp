// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 7.4 and 8.3.3: where four balls or more meet in one point, several triangles give the same
// singular point, and they are told to be the same by incidence: their balls touch one sample. Of
// bare lists of balls nothing is known but their numbers; there an arc that is shorter than what
// the balls' changed radii can have moved its ends by is one point.
//
// It differs in that nothing is merged that would change the surface: arcs are contracted one by
// one, none that ends where it begins, so that the surface stays what it is; a disk with one arc
// round it is contracted, and one with two is closed like a mouth. What stands at one place and
// hangs together in no such way are two vertices: that is how places where the surface touches
// itself are kept apart.
#include "ball_surface/merge_points.h"

#include "core/progress.h"
#include "dual/orthospheres.h"

#include <algorithm>

namespace vbm::impl {

int32_t TouchedSamples::common(const DualShape &shape, int32_t code) const {
  if (!lists) return -1;
  const DualShape::Triangle &t = shape.triangles[code / 2];
  const int32_t *at[3], *end[3];
  for (int i = 0; i < 3; ++i) {
    const int32_t b = (*ball)[t.ball[i]];
    at[i] = lists->index.data() + lists->offset[b];
    end[i] = lists->index.data() + lists->offset[b + 1];
  }
  while (at[0] != end[0] && at[1] != end[1] && at[2] != end[2]) {
    const int32_t most = std::max({*at[0], *at[1], *at[2]});
    if (*at[0] == most && *at[1] == most && *at[2] == most) {
      const Vec3 a = center_of(shape.site[t.ball[0]]), b = center_of(shape.site[t.ball[1]]),
                 c = center_of(shape.site[t.ball[2]]);
      const double over = dot(cross(b - a, c - a), (*position)[most] - a);
      if (code & 1 ? over >= 0 : over <= 0) return most;
      ++at[0];
      continue;
    }
    for (int i = 0; i < 3; ++i)
      while (at[i] != end[i] && *at[i] < most) ++at[i];
  }
  return -1;
}

std::vector<int32_t> TouchedSamples::of(const PatchComplex &complex, const DualShape &shape,
                                        Progress &progress) const {
  std::vector<int32_t> sample(complex.position.size(), -1);
  if (!lists) return sample;
  for (std::size_t v = 0; v < complex.singular_points; ++v) {
    progress.tick(v, complex.singular_points);
    sample[v] = common(shape, complex.code[v]);
  }
  return sample;
}

std::size_t merge_points(ComplexEditor &editor, const std::vector<int32_t> &sample,
                         const PatchOptions &options, Progress &progress) {
  const PatchComplex &c = editor.complex;
  std::size_t merged = 0;
  // Whether an arc is nothing but two names for its place.
  const auto is_null = [&](const PatchComplex::Dart &d) {
    const int32_t u = d.from, v = c.darts[d.twin].from;
    if (std::size_t(u) >= c.singular_points || std::size_t(v) >= c.singular_points) return false;
    if (sample[u] >= 0 && sample[v] >= 0) return sample[u] == sample[v];
    return distance(c.position[u], c.position[v]) <= c.blur[u] + c.blur[v];
  };
  for (std::size_t d = 0; d < c.darts.size(); d += 2) {
    progress.tick(d, c.darts.size());
    if (is_null(c.darts[d])) merged += editor.contract(int32_t(d));
  }
  for (std::size_t p = 0; p < c.patches.size(); ++p) editor.look_at(int32_t(p));
  editor.close(options.bulge, progress);
  return merged;
}

} // namespace vbm::impl
