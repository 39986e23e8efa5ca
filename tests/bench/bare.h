// SPDX-License-Identifier: GPL-3.0-or-later
// What the library is measured against: CGAL's triangulations as its manual's first example builds
// them, with everything known beforehand and nothing done with the result.
#pragma once

#include <cstddef>
#include <vector>

namespace bench {

/// The Delaunay triangulation of n x 3 coordinates. Returns its number of tetrahedra.
std::size_t bare_delaunay(const std::vector<double> &points);

/// The regular triangulation of balls (n x 3 centres, n radii). Returns its number of tetrahedra.
std::size_t bare_regular(const std::vector<double> &centers, const std::vector<double> &radii);

} // namespace bench
