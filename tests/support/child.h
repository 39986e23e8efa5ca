// SPDX-License-Identifier: GPL-3.0-or-later
// Running a piece of a test where it can do no harm.
#pragma once

#include <functional>
#include <string>

/// Whether the tests themselves were built with a sanitizer (address or thread).
bool sanitized();

/// Run `body` in a child process under limits of processor time and memory (no memory limit under
/// sanitizers, which map terabytes), and say how it ended: "" if body returned true and leaked
/// nothing a leak checker sees, else what happened ("killed by signal 11", "out of its 20 s").
std::string run_in_child(unsigned seconds, std::size_t megabytes,
                         const std::function<bool()> &body);
