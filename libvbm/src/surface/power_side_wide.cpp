// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/power_side_wide.h"

#ifdef VBM_FOUR_DOUBLES

#include <cstring>

namespace vbm::impl {

// What is computed, and in what order, is what power_side() does: its bound on the error holds. No
// two operations are made one (there is no FMA in this target). All is within one function, as no
// such vectors may be handed to one that is made for any processor.
__attribute__((target("avx2"))) int power_side_wide(const Site &a, const Site &b, const Site &c,
                                                    const Site &d, const Site &p) {
  using Four = double __attribute__((vector_size(32)));
  using Bits = long long __attribute__((vector_size(32)));
  constexpr long long kRest = 0x7fffffffffffffff;
  const Bits all_but_sign = {kRest, kRest, kRest, kRest};
  const Four origin = {p.x, p.y, p.z, 0};
  Four ra, rb, rc, rd;
  std::memcpy(&ra, &a, sizeof ra);
  std::memcpy(&rb, &b, sizeof rb);
  std::memcpy(&rc, &c, sizeof rc);
  std::memcpy(&rd, &d, sizeof rd);
  ra -= origin, rb -= origin, rc -= origin, rd -= origin;
  // Rows to columns.
  const Four xz_ab = __builtin_shufflevector(ra, rb, 0, 4, 2, 6),
             yr_ab = __builtin_shufflevector(ra, rb, 1, 5, 3, 7),
             xz_cd = __builtin_shufflevector(rc, rd, 0, 4, 2, 6),
             yr_cd = __builtin_shufflevector(rc, rd, 1, 5, 3, 7);
  const Four x = __builtin_shufflevector(xz_ab, xz_cd, 0, 1, 4, 5),
             y = __builtin_shufflevector(yr_ab, yr_cd, 0, 1, 4, 5),
             z = __builtin_shufflevector(xz_ab, xz_cd, 2, 3, 6, 7),
             r = __builtin_shufflevector(yr_ab, yr_cd, 2, 3, 6, 7);
  const Four square = x * x + y * y + z * z, weight = (p.r - r) * (p.r + r);
  const Four lift = square + weight;
  const Four size =
      Four(Bits(x) & all_but_sign) + Four(Bits(y) & all_but_sign) + Four(Bits(z) & all_but_sign);
  const Four lift_size = square + Four(Bits(weight) & all_but_sign);

  // Minors of columns x and y, then of z and lift: of rows a and c, b and d; a and d, b and c; a
  // and b, c and d.
  const Four xy_c = x * __builtin_shufflevector(y, y, 2, 3, 0, 1),
             xy_d = x * __builtin_shufflevector(y, y, 3, 2, 1, 0),
             xy_b = x * __builtin_shufflevector(y, y, 1, 0, 3, 2);
  const Four zl_c = z * __builtin_shufflevector(lift, lift, 2, 3, 0, 1),
             zl_d = z * __builtin_shufflevector(lift, lift, 3, 2, 1, 0),
             zl_b = z * __builtin_shufflevector(lift, lift, 1, 0, 3, 2);
  const Two ac_bd = __builtin_shufflevector(xy_c, xy_c, 0, 1) -
                    __builtin_shufflevector(xy_c, xy_c, 2, 3),
            ad_bc = __builtin_shufflevector(xy_d, xy_d, 0, 1) -
                    __builtin_shufflevector(xy_d, xy_d, 3, 2),
            ab_cd = __builtin_shufflevector(xy_b, xy_b, 0, 2) -
                    __builtin_shufflevector(xy_b, xy_b, 1, 3);
  const Two bd_ac_lift = __builtin_shufflevector(zl_c, zl_c, 1, 0) -
                         __builtin_shufflevector(zl_c, zl_c, 3, 2),
            bc_ad_lift = __builtin_shufflevector(zl_d, zl_d, 1, 0) -
                         __builtin_shufflevector(zl_d, zl_d, 2, 3),
            cd_ab_lift = __builtin_shufflevector(zl_b, zl_b, 2, 0) -
                         __builtin_shufflevector(zl_b, zl_b, 3, 1);
  const Two sum = ac_bd * bd_ac_lift - ab_cd * cd_ab_lift - ad_bc * bc_ad_lift;
  const double side = sum[0] + sum[1];
  const Four mixed = lift_size * __builtin_shufflevector(size, size, 1, 0, 3, 2);
  const double all =
      (mixed[0] + mixed[1]) * (size[2] * size[3]) + (mixed[2] + mixed[3]) * (size[0] * size[1]);
  const double error = kSignError * all;
  if (std::fabs(side) > error && std::fabs(side) > kTinyResult) return side > 0 ? 1 : -1;
  return power_side_precise(a, b, c, d, p);
}

} // namespace vbm::impl

#endif
