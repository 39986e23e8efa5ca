// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of about 106 bits: unevaluated sums of two doubles.
//
// Dekker, "A floating-point technique for extending the available precision" (1971), with the sum
// that keeps its relative error under cancellation (Hida, Li, Bailey 2001). Products are split
// instead of fused, so that machines with and without a fused multiply-add give the same bits.
#pragma once

namespace vbm::impl {

struct DoubleDouble {
  double high = 0, low = 0;

  DoubleDouble() = default;
  explicit DoubleDouble(double value) : high(value) {}
  DoubleDouble(double high, double low) : high(high), low(low) {}

  explicit operator double() const { return high; }
};

namespace pair_arithmetic {

/// a + b exactly, for |a| >= |b|.
inline DoubleDouble quick_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// a + b exactly.
inline DoubleDouble sum(double a, double b) {
  const double s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

/// a * b exactly, short of underflow.
inline DoubleDouble product(double a, double b) {
  constexpr double splitter = 134217729; // 2^27 + 1
  const double ta = splitter * a, tb = splitter * b;
  const double ah = ta - (ta - a), bh = tb - (tb - b);
  const double al = a - ah, bl = b - bh, p = a * b;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

} // namespace pair_arithmetic

inline DoubleDouble operator+(const DoubleDouble &a, const DoubleDouble &b) {
  using namespace pair_arithmetic;
  DoubleDouble s = sum(a.high, b.high), t = sum(a.low, b.low);
  s = quick_sum(s.high, s.low + t.high);
  return quick_sum(s.high, s.low + t.low);
}
inline DoubleDouble operator-(const DoubleDouble &a) { return {-a.high, -a.low}; }
inline DoubleDouble operator-(const DoubleDouble &a, const DoubleDouble &b) { return a + -b; }
inline DoubleDouble operator*(const DoubleDouble &a, const DoubleDouble &b) {
  using namespace pair_arithmetic;
  const DoubleDouble p = product(a.high, b.high);
  return quick_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

} // namespace vbm::impl
