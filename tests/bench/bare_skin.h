// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's own skin surface (Kruithof's Skin_surface_3), which the library's is measured against.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

struct SkinSize {
  std::size_t vertices = 0, triangles = 0, components = 0;
  int64_t euler() const { return int64_t(vertices) - int64_t(triangles) / 2; }
  int64_t genus() const { return int64_t(components) - euler() / 2; }
};

/// Of balls (n x 3 centres, n radii), grown as CGAL does by default.
SkinSize bare_skin(const std::vector<double> &centers, const std::vector<double> &radii,
                   double shrink);

} // namespace bench
