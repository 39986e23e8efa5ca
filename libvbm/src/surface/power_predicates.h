// SPDX-License-Identifier: GPL-3.0-or-later
// The exact signs a power diagram is built on.
//
// Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates"
// (1997): doubles first, with a bound on their error, and more digits only where that bound says
// so. It differs in its stages (doubles, pairs of doubles, exact integers with an exponent) and in
// the lifted coordinate, which is written with radii instead of squared weights:
//
//   |c_i - c_p|^2 + (r_p - r_i)(r_p + r_i)
//
// Balls through one sample are close in centre and radius together, so this keeps the digits that
// r_p^2 - r_i^2 would lose: those are the tests a power diagram of polar balls consists of.
#pragma once

#include "core/two.h"

#include <cmath>

namespace vbm::impl {

/// A weighted point: a ball as the power diagram sees it. Multiples of kSiteGrid (core/grid.h).
struct alignas(32) Site {
  double x, y, z, r;
};

/// Bounds on the error of the sums of products below, as a factor on the sum of the products'
/// absolute values. One operation errs by 2^-53, or 2^-52 should the host have set another rounding
/// mode; no term passes through more than 20 operations.
inline constexpr double kSignError = 24 * 0x1p-52;
/// The same for pairs of doubles, whose operations err by less than 2^-102 of the result, or of the
/// terms where they cancel; in other rounding modes a few bits more.
inline constexpr double kPairError = 0x1p-92;
/// Below this a result may have lost digits to underflow.
inline constexpr double kTinyResult = 1e-200;

/// Sign of det(b - a, c - a, d - a), in more digits than doubles have.
int orientation_precise(const Site &a, const Site &b, const Site &c, const Site &d);
/// Sign of power_side(), in more digits than doubles have.
int power_side_precise(const Site &a, const Site &b, const Site &c, const Site &d, const Site &p);

/// The point that has the same power distance to four balls, in exact arithmetic rounded at the
/// end. False if the centres lie in one plane.
bool power_center_exact(const Site &a, const Site &b, const Site &c, const Site &d,
                        double center[3]);

/// 1 if a, b, c, d is a positively oriented tetrahedron, -1 if negatively, 0 if it is flat.
inline int orientation(const Site &a, const Site &b, const Site &c, const Site &d) {
  const double bx = b.x - a.x, by = b.y - a.y, bz = b.z - a.z;
  const double cx = c.x - a.x, cy = c.y - a.y, cz = c.z - a.z;
  const double dx = d.x - a.x, dy = d.y - a.y, dz = d.z - a.z;
  const double det = bx * (cy * dz - cz * dy) + by * (cz * dx - cx * dz) + bz * (cx * dy - cy * dx);
  const double size = (std::fabs(bx) + std::fabs(by) + std::fabs(bz)) *
                      (std::fabs(cx) + std::fabs(cy) + std::fabs(cz)) *
                      (std::fabs(dx) + std::fabs(dy) + std::fabs(dz));
  const double error = kSignError * size;
  if (std::fabs(det) > error && std::fabs(det) > kTinyResult) return det > 0 ? 1 : -1;
  return orientation_precise(a, b, c, d);
}

/// Two balls relative to a third.
struct TwoRows {
  Two x, y, z, lift;
  Two size, lift_size; // |x| + |y| + |z|, and the terms of lift without their signs

  TwoRows(const Site &a, const Site &b, const Site &p) {
    const Two axy = two(a.x, a.y), bxy = two(b.x, b.y), azr = two(a.z, a.r), bzr = two(b.z, b.r);
    const Two pr = two(p.r, p.r), r = seconds(azr, bzr);
    x = firsts(axy, bxy) - two(p.x, p.x);
    y = seconds(axy, bxy) - two(p.y, p.y);
    z = firsts(azr, bzr) - two(p.z, p.z);
    const Two square = x * x + y * y + z * z, weight = (pr - r) * (pr + r);
    lift = square + weight;
    size = magnitudes(x) + magnitudes(y) + magnitudes(z);
    lift_size = square + magnitudes(weight);
  }
};

/// For a positively oriented a, b, c, d: 1 if ball p is closer to the power centre of the four than
/// they are (in conflict with their cell), -1 if farther, 0 if as far.
inline int power_side(const Site &a, const Site &b, const Site &c, const Site &d, const Site &p) {
  // The determinant of the rows (x, y, z, lift) of a, b, c, d by Laplace's expansion: each minor of
  // columns x and y with the one of columns z and lift in the other two rows.
  const TwoRows ab(a, b, p), cd(c, d, p);
  const Two xs = swapped(cd.x), ys = swapped(cd.y), zs = swapped(cd.z), ls = swapped(cd.lift);
  const Two ac_bd = ab.x * cd.y - cd.x * ab.y, ad_bc = ab.x * ys - xs * ab.y;
  const Two ac_bd_lift = ab.z * cd.lift - cd.z * ab.lift, ad_bc_lift = ab.z * ls - zs * ab.lift;
  const Two ax = firsts(ab.x, cd.x), bx = seconds(ab.x, cd.x);
  const Two ay = firsts(ab.y, cd.y), by = seconds(ab.y, cd.y);
  const Two az = firsts(ab.z, cd.z), bz = seconds(ab.z, cd.z);
  const Two al = firsts(ab.lift, cd.lift), bl = seconds(ab.lift, cd.lift);
  const Two ab_cd = ax * by - bx * ay, ab_cd_lift = az * bl - bz * al;
  const Two sum =
      ac_bd * swapped(ac_bd_lift) - ab_cd * swapped(ab_cd_lift) - ad_bc * swapped(ad_bc_lift);
  const double side = sum[0] + sum[1];
  const Two mixed = ab.lift_size * swapped(ab.size), others = cd.lift_size * swapped(cd.size);
  const double size = (mixed[0] + mixed[1]) * (cd.size[0] * cd.size[1]) +
                      (others[0] + others[1]) * (ab.size[0] * ab.size[1]);
  const double error = kSignError * size;
  if (std::fabs(side) > error && std::fabs(side) > kTinyResult) return side > 0 ? 1 : -1;
  return power_side_precise(a, b, c, d, p);
}

} // namespace vbm::impl
