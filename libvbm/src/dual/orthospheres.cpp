// SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/orthospheres.h"

#include "core/double_double.h"
#include "core/tolerances.h"

#include <cmath>
#include <initializer_list>

namespace vbm::impl {
namespace {

template <class Number> struct Vector {
  Number x, y, z;
  double size = 0; // the coordinates' absolute values, summed before anything cancelled
};

template <class Number> Number dot(const Vector<Number> &a, const Vector<Number> &b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Number> Vector<Number> cross(const Vector<Number> &a, const Vector<Number> &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x, a.size * b.size};
}
template <class Number>
Vector<Number> scaled(const Vector<Number> &a, const Number &s, double size) {
  return {a.x * s, a.y * s, a.z * s, a.size * size};
}
template <class Number> Vector<Number> operator+(const Vector<Number> &a, const Vector<Number> &b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z, a.size + b.size};
}
template <class Number> Vector<Number> operator-(const Vector<Number> &a, const Vector<Number> &b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z, a.size + b.size};
}
template <class Number> double length_of(const Vector<Number> &a) {
  return std::fabs(double(a.x)) + std::fabs(double(a.y)) + std::fabs(double(a.z));
}

/// Ball q relative to ball a, and the lifted coordinate: |q - a|^2 + r_a^2 - r_q^2.
template <class Number> struct Row {
  Vector<Number> e;
  Number lift;
  double lift_size;

  Row(const Site &q, const Site &a)
      : e{Number(q.x) - Number(a.x), Number(q.y) - Number(a.y), Number(q.z) - Number(a.z)} {
    e.size = length_of(e);
    const Number square = dot(e, e);
    lift = square + (Number(a.r) - Number(q.r)) * (Number(a.r) + Number(q.r));
    lift_size = double(square) + std::fabs(a.r - q.r) * (a.r + q.r);
  }
};

template <class Number> constexpr double kUnitError = kSignError;
template <> constexpr double kUnitError<DoubleDouble> = kPairError;

/// A number and a bound on its error.
struct Value {
  double value, error;
  bool sure() const { return std::fabs(value) > error && std::fabs(value) > kTinyResult; }
};

/// |n|^2 - 4 r^2 |w|^2: the square of the orthogonal sphere's radius times 4 |w|^2.
template <class Number>
Value radius_sign(const Vector<Number> &n, const Vector<Number> &w, const Site &a) {
  const Number nn = dot(n, n), ww = dot(w, w), r(a.r);
  const Number far = Number(4.0) * (r * r) * ww;
  const double dn = kUnitError<Number> * n.size, dw = kUnitError<Number> * w.size;
  const double error = (2 * length_of(n) + dn) * dn +
                       4 * a.r * a.r * ((2 * length_of(w) + dw) * dw) +
                       kUnitError<Number> * (double(nn) + double(far));
  return {double(nn - far), error};
}

template <class Number> struct EdgeParts {
  Row<Number> b;
  EdgeParts(const Site &a, const Site &b) : b(b, a) {}
  Value radius(const Site &a) const {
    const Vector<Number> n{b.lift, Number(0.0), Number(0.0), b.lift_size};
    return radius_sign(n, b.e, a);
  }
  Value hides(const Site &a, const Site &p) const {
    const Row<Number> q(p, a);
    const Number ee = dot(b.e, b.e), pe = dot(q.e, b.e);
    return {double(q.lift * ee - b.lift * pe),
            kUnitError<Number> * b.e.size * (q.lift_size * b.e.size + b.lift_size * q.e.size)};
  }
};

template <class Number> struct TriangleParts {
  Row<Number> b, c;
  Vector<Number> w, u; // normal; lift_b c - lift_c b
  TriangleParts(const Site &a, const Site &b, const Site &c)
      : b(b, a), c(c, a), w(cross(this->b.e, this->c.e)),
        u(scaled(this->c.e, this->b.lift, this->b.lift_size) -
          scaled(this->b.e, this->c.lift, this->c.lift_size)) {}
  Value radius(const Site &a) const { return radius_sign(u, w, a); }
  Value hides(const Site &a, const Site &p) const {
    const Row<Number> q(p, a);
    const Vector<Number> y = cross(u, w);
    return {double(q.lift * dot(w, w) - dot(q.e, y)),
            kUnitError<Number> * w.size * (q.lift_size * w.size + q.e.size * u.size)};
  }
  /// The centre, and a bound on its error.
  Vec3 center(double &error) const {
    const Vector<Number> y = cross(u, w);
    const double ww = double(dot(w, w)), f = 0.5 / ww;
    const Vec3 x{double(y.x) * f, double(y.y) * f, double(y.z) * f};
    const double dw = kUnitError<Number> * w.size, du = kUnitError<Number> * u.size;
    error = ((length_of(u) + du) * dw + du * length_of(w) + 2 * length(x) * 2 * dw * length_of(w)) *
            f * 2;
    return x;
  }
};

template <class Number> struct TetrahedronParts {
  Row<Number> b, c, d;
  Vector<Number> n;   // the power centre times 2 det
  Vector<Number> det; // in x
  TetrahedronParts(const Site &a, const Site &b, const Site &c, const Site &d)
      : b(b, a), c(c, a), d(d, a) {
    const Vector<Number> bc = cross(this->b.e, this->c.e), cd = cross(this->c.e, this->d.e),
                         db = cross(this->d.e, this->b.e);
    n = scaled(cd, this->b.lift, this->b.lift_size) + scaled(db, this->c.lift, this->c.lift_size) +
        scaled(bc, this->d.lift, this->d.lift_size);
    det = {dot(this->b.e, cd), Number(0.0), Number(0.0),
           this->b.e.size * this->c.e.size * this->d.e.size};
  }
  Value radius(const Site &a) const { return radius_sign(n, det, a); }
  Vec3 center(double &error) const {
    const double f = 0.5 / double(det.x);
    const Vec3 x{double(n.x) * f, double(n.y) * f, double(n.z) * f};
    error = kUnitError<Number> * (n.size + 2 * length(x) * det.size) * std::fabs(f);
    return x;
  }
};

template <template <class> class Parts, class... Sites>
bool meets(const Site &a, const Sites &...s) {
  const Value v = Parts<double>(a, s...).radius(a);
  if (v.sure()) return v.value < 0;
  return Parts<DoubleDouble>(a, s...).radius(a).value <= 0;
}

template <template <class> class Parts, class... Sites>
bool hides(const Site &p, const Site &a, const Sites &...s) {
  const Value v = Parts<double>(a, s...).hides(a, p);
  if (v.sure()) return v.value < 0;
  return Parts<DoubleDouble>(a, s...).hides(a, p).value < 0;
}

template <template <class> class Parts, class... Sites>
Vec3 center(const Site &a, const Sites &...s) {
  double error;
  const Vec3 x = Parts<double>(a, s...).center(error);
  if (error < kOrthocenterError) return x;
  return Parts<DoubleDouble>(a, s...).center(error);
}

} // namespace

bool edge_meets(const Site &a, const Site &b) { return meets<EdgeParts>(a, b); }
bool triangle_meets(const Site &a, const Site &b, const Site &c) {
  return meets<TriangleParts>(a, b, c);
}
bool tetrahedron_meets(const Site &a, const Site &b, const Site &c, const Site &d) {
  return meets<TetrahedronParts>(a, b, c, d);
}

bool hides_vertex(const Site &a, const Site &p) {
  const Row<double> q(p, a);
  if (std::fabs(q.lift) > kSignError * q.lift_size) return q.lift < 0;
  return double(Row<DoubleDouble>(p, a).lift) < 0;
}
bool hides_edge(const Site &a, const Site &b, const Site &p) { return hides<EdgeParts>(p, a, b); }
bool hides_triangle(const Site &a, const Site &b, const Site &c, const Site &p) {
  return hides<TriangleParts>(p, a, b, c);
}

bool triangle_alone_meets(const Site &a, const Site &b, const Site &c, const Site *p,
                          const Site *q) {
  const TriangleParts<double> parts(a, b, c);
  const Value meets = parts.radius(a);
  if (meets.sure() ? meets.value >= 0 : !triangle_meets(a, b, c)) return false;
  for (const Site *other : {p, q}) {
    if (!other) continue;
    const Value hides = parts.hides(a, *other);
    if (hides.sure() ? hides.value < 0 : hides_triangle(a, b, c, *other)) return false;
  }
  return true;
}

Vec3 edge_center(const Site &a, const Site &b) {
  const Row<double> row(b, a);
  const Vec3 e{row.e.x, row.e.y, row.e.z};
  return e * (row.lift / (2 * dot(row.e, row.e)));
}
Vec3 triangle_center(const Site &a, const Site &b, const Site &c) {
  return center<TriangleParts>(a, b, c);
}
Vec3 tetrahedron_center(const Site &a, const Site &b, const Site &c, const Site &d) {
  return center<TetrahedronParts>(a, b, c, d);
}

} // namespace vbm::impl
