// SPDX-License-Identifier: GPL-3.0-or-later
#include "bare.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>

namespace bench {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel>;
using Regular = CGAL::Regular_triangulation_3<Kernel>;

std::size_t bare_delaunay(const std::vector<double> &points) {
  std::vector<Kernel::Point_3> input;
  input.reserve(points.size() / 3);
  for (std::size_t i = 0; i < points.size(); i += 3)
    input.emplace_back(points[i], points[i + 1], points[i + 2]);
  return Delaunay(input.begin(), input.end()).number_of_finite_cells();
}

std::size_t bare_regular(const std::vector<double> &centers, const std::vector<double> &radii) {
  std::vector<Kernel::Weighted_point_3> input;
  input.reserve(radii.size());
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double *c = &centers[3 * i];
    input.emplace_back(Kernel::Point_3(c[0], c[1], c[2]), radii[i] * radii[i]);
  }
  return Regular(input.begin(), input.end()).number_of_finite_cells();
}

} // namespace bench
