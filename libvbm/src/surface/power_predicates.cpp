// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/power_predicates.h"

#include "core/double_double.h"
#include "core/exact.h"

namespace vbm::impl {
namespace {

int sign_of(const Exact &value) { return int(CGAL::sign(value)); }

template <class Number> struct Row { Number x, y, z, lift; };

template <class Number> Number number(double x) { return Number(x); }
template <> Exact number<Exact>(double x) { return Exact(x * kSiteScale); }

template <class Number> Row<Number> row_of(const Site &q, const Site &base) {
  Row<Number> row{number<Number>(q.x) - number<Number>(base.x),
                  number<Number>(q.y) - number<Number>(base.y),
                  number<Number>(q.z) - number<Number>(base.z), Number(0.0)};
  const Number r = number<Number>(q.r), base_r = number<Number>(base.r);
  row.lift = row.x * row.x + row.y * row.y + row.z * row.z + (base_r - r) * (base_r + r);
  return row;
}

template <class Number>
Number det3(const Row<Number> &a, const Row<Number> &b, const Row<Number> &c) {
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
         a.z * (b.x * c.y - b.y * c.x);
}

template <class Number>
Number side_of(const Row<Number> &a, const Row<Number> &b, const Row<Number> &c,
               const Row<Number> &d) {
  const Number ab = a.x * b.y - b.x * a.y, bc = b.x * c.y - c.x * b.y;
  const Number cd = c.x * d.y - d.x * c.y, da = d.x * a.y - a.x * d.y;
  const Number ac = a.x * c.y - c.x * a.y, bd = b.x * d.y - d.x * b.y;
  const Number abc = a.z * bc - b.z * ac + c.z * ab, bcd = b.z * cd - c.z * bd + d.z * bc;
  const Number cda = c.z * da + d.z * ac + a.z * cd, dab = d.z * ab + a.z * bd + b.z * da;
  return (a.lift * bcd - b.lift * cda) + (c.lift * dab - d.lift * abc);
}

double size_of(const Row<DoubleDouble> &a) {
  return std::fabs(a.x.high) + std::fabs(a.y.high) + std::fabs(a.z.high);
}

/// What was summed up in the lifted coordinate, without the signs.
double lift_size(const Row<DoubleDouble> &a, const Site &q, const Site &base) {
  return a.x.high * a.x.high + a.y.high * a.y.high + a.z.high * a.z.high +
         std::fabs(base.r - q.r) * (base.r + q.r);
}

} // namespace

int orientation_precise(const Site &a, const Site &b, const Site &c, const Site &d) {
  const Row<DoubleDouble> pb = row_of<DoubleDouble>(b, a), pc = row_of<DoubleDouble>(c, a),
                          pd = row_of<DoubleDouble>(d, a);
  const double det = det3(pb, pc, pd).high;
  const double error = kPairError * size_of(pb) * size_of(pc) * size_of(pd);
  if (std::fabs(det) > error && std::fabs(det) > kTinyResult) return det > 0 ? 1 : -1;
  return sign_of(det3(row_of<Exact>(b, a), row_of<Exact>(c, a), row_of<Exact>(d, a)));
}

int power_side_precise(const Site &a, const Site &b, const Site &c, const Site &d, const Site &p) {
  const Row<DoubleDouble> pa = row_of<DoubleDouble>(a, p), pb = row_of<DoubleDouble>(b, p),
                          pc = row_of<DoubleDouble>(c, p), pd = row_of<DoubleDouble>(d, p);
  const double side = side_of(pa, pb, pc, pd).high;
  const double an = size_of(pa), bn = size_of(pb), cn = size_of(pc), dn = size_of(pd);
  const double size = (lift_size(pa, a, p) * bn + lift_size(pb, b, p) * an) * (cn * dn) +
                      (lift_size(pc, c, p) * dn + lift_size(pd, d, p) * cn) * (an * bn);
  if (std::fabs(side) > kPairError * size && std::fabs(side) > kTinyResult)
    return side > 0 ? 1 : -1;
  return sign_of(
      side_of(row_of<Exact>(a, p), row_of<Exact>(b, p), row_of<Exact>(c, p), row_of<Exact>(d, p)));
}

bool power_center_exact(const Site &a, const Site &b, const Site &c, const Site &d,
                        double center[3]) {
  // Rows about a: the power centre x solves 2 row . (x - a) = lift for each of the other three.
  const Row<Exact> rb = row_of<Exact>(b, a), rc = row_of<Exact>(c, a), rd = row_of<Exact>(d, a);
  const Exact det = det3(rb, rc, rd);
  if (sign_of(det) == 0) return false;
  const auto solve = [&](auto axis) {
    Row<Exact> b1 = rb, c1 = rc, d1 = rd;
    b1.*axis = rb.lift, c1.*axis = rc.lift, d1.*axis = rd.lift;
    return CGAL::to_double(det3(b1, c1, d1)) / (2 * kSiteScale * CGAL::to_double(det));
  };
  center[0] = a.x + solve(&Row<Exact>::x);
  center[1] = a.y + solve(&Row<Exact>::y);
  center[2] = a.z + solve(&Row<Exact>::z);
  return true;
}

} // namespace vbm::impl
