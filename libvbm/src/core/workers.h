// SPDX-License-Identifier: GPL-3.0-or-later
// Several threads for one call.
#pragma once

#include <cstddef>
#include <functional>

namespace vbm::impl {

class Progress;

/// What threads write to is to be so far apart, in bytes, or each waits for the other's writes: two
/// cache lines, as processors fetch them in pairs.
inline constexpr std::size_t kApart = 128;

/// Runs work(part, progress) once for every part from 0 to parts - 1, on as many threads as there
/// are processors and the call may use (Progress::threads()). What a part does must not depend on
/// which thread does it, nor when. The calling thread is one of them, and the only one that
/// reports: the others' progress reports nothing, and throws when the work is to end.
///
/// Should any part throw, no more are begun, those at work are told to end, and when all have, what
/// was thrown first is thrown again.
void run_parts(int parts, Progress &progress, const std::function<void(int, Progress &)> &work);

} // namespace vbm::impl
