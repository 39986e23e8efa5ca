// SPDX-License-Identifier: GPL-3.0-or-later
// Peak memory of one piece of work.
#pragma once

#include <functional>

namespace bench {

/// Megabytes (10^6 bytes) by which `work` raises the peak of resident memory over what was there
/// before, measured in a child process of its own. -1 if the child did not finish.
double peak_megabytes(const std::function<void()> &work);

} // namespace bench
