// SPDX-License-Identifier: GPL-3.0-or-later
// Two doubles computed with at once: vector registers where the compiler offers them.
#pragma once

#include <cmath>

namespace vbm::impl {

#if defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12)

using Two = double __attribute__((vector_size(16)));

/// The first, and the second, of a and b.
inline Two firsts(Two a, Two b) { return __builtin_shufflevector(a, b, 0, 2); }
inline Two seconds(Two a, Two b) { return __builtin_shufflevector(a, b, 1, 3); }
inline Two swapped(Two a) { return __builtin_shufflevector(a, a, 1, 0); }
inline Two magnitudes(Two a) {
  using Bits = long long __attribute__((vector_size(16)));
  const Bits all_but_sign = {0x7fffffffffffffff, 0x7fffffffffffffff};
  return Two(Bits(a) & all_but_sign);
}

#else

struct Two {
  double v[2];
  double operator[](int i) const { return v[i]; }
};

inline Two operator+(Two a, Two b) { return {{a[0] + b[0], a[1] + b[1]}}; }
inline Two operator-(Two a, Two b) { return {{a[0] - b[0], a[1] - b[1]}}; }
inline Two operator*(Two a, Two b) { return {{a[0] * b[0], a[1] * b[1]}}; }
inline Two firsts(Two a, Two b) { return {{a[0], b[0]}}; }
inline Two seconds(Two a, Two b) { return {{a[1], b[1]}}; }
inline Two swapped(Two a) { return {{a[1], a[0]}}; }
inline Two magnitudes(Two a) { return {{std::fabs(a[0]), std::fabs(a[1])}}; }

#endif

inline Two two(double a, double b) { return Two{a, b}; }

} // namespace vbm::impl
