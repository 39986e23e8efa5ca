// SPDX-License-Identifier: GPL-3.0-or-later
// What a host program may have done to its process before it calls a library.
#pragma once

#include <functional>
#include <string>

/// Run `body` in the decimal-comma locale de_DE.UTF-8, rounding upward, with denormals flushed to
/// zero where the machine can; then put everything back. Returns "" if body left all of it as it
/// found it, else what it changed. Throws std::runtime_error if there is no such locale.
std::string in_odd_host(const std::function<void()> &body);

/// Whether setlocale() knows de_DE.UTF-8 and a comma comes out of printf() there.
bool have_comma_locale();
