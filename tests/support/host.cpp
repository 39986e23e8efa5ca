// SPDX-License-Identifier: GPL-3.0-or-later
#include "host.h"

#include <cfenv>
#include <clocale>
#include <cstdio>
#include <stdexcept>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace {

constexpr const char *kComma = "de_DE.UTF-8";

bool prints_comma() {
  char text[8];
  std::snprintf(text, sizeof text, "%.1f", 1.5);
  return std::string(text) == "1,5";
}

#ifdef __SSE2__
/// Flush results to zero, and take denormal operands as zero.
constexpr unsigned kFlush = 0x8040;
constexpr unsigned kExceptionFlags = 0x3f;
unsigned control() { return _mm_getcsr() & ~kExceptionFlags; }
#endif

} // namespace

bool have_comma_locale() {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const bool have = std::setlocale(LC_ALL, kComma) && prints_comma();
  std::setlocale(LC_ALL, before.c_str());
  return have;
}

std::string in_odd_host(const std::function<void()> &body) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (!std::setlocale(LC_ALL, kComma) || !prints_comma()) {
    std::setlocale(LC_ALL, before.c_str());
    throw std::runtime_error("no locale de_DE.UTF-8");
  }
  std::fenv_t environment;
  std::fegetenv(&environment);
  std::fesetround(FE_UPWARD);
#ifdef __SSE2__
  _mm_setcsr(_mm_getcsr() | kFlush);
  const unsigned set = control();
#endif
  body();
  std::string changed;
  if (std::fegetround() != FE_UPWARD) changed += "the rounding mode ";
#ifdef __SSE2__
  if (control() != set) changed += "the floating-point control word ";
#endif
  std::fesetenv(&environment);
  if (std::string(std::setlocale(LC_ALL, nullptr)) != kComma || !prints_comma())
    changed += "the locale";
  std::setlocale(LC_ALL, before.c_str());
  return changed;
}
