// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball_surface/union_input.h"

#include "core/error.h"
#include "core/progress.h"
#include "sampling/checks.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {

void check_any(const UnionInput &set) {
  if (set.balls.empty())
    throw Error(
        VBM_ERROR_NO_INTERIOR,
        set.points
            ? "all balls have a radius of 0, or next to 0 beside the extent of all: there is "
              "nothing to make a surface of"
            : "there are no balls to make a surface of");
}

std::string note_on_points(const UnionInput &set) {
  if (!set.points) return "";
  return counted(set.points, "ball has", "balls have") +
         " no radius to speak of and bound nothing: left out.\n";
}

void fill_gaps(Surface &surface, const UnionInput &set, Progress &progress) {
  double most = 0, sum = 0, area = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    progress.tick(t, surface.triangles.size());
    const int32_t b = surface.polygon_ball[surface.triangle_polygon[t]];
    if (b < 0) continue;
    Vec3 p[3];
    for (int i = 0; i < 3; ++i) p[i] = set.frame.to_unit(surface.vertices[surface.triangles[t][i]]);
    const Ball &ball = set.balls[b];
    const double gap =
        std::fabs(distance((p[0] + p[1] + p[2]) * (1.0 / 3), ball.center) - ball.radius);
    const double weight = length(cross(p[1] - p[0], p[2] - p[0]));
    most = std::max(most, gap);
    sum += weight * gap;
    area += weight;
  }
  surface.report.gap_max = set.frame.length_to_input(most);
  surface.report.gap_mean = set.frame.length_to_input(area > 0 ? sum / area : 0);
}

} // namespace vbm::impl
