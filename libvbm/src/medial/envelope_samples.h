// SPDX-License-Identifier: GPL-3.0-or-later
// Points spread over the boundary of an envelope.
#pragma once

#include "medial/envelope.h"

#include <vector>

namespace vbm::impl {

struct EnvelopeSamples {
  std::vector<Vec3> point;
  std::vector<double> area; // that each stands for
};

/// Points about `spacing` apart on the boundary of every primitive, those left out that another
/// primitive covers.
EnvelopeSamples sample_envelope(const BallComplex &complex, const Envelope &envelope,
                                double spacing, Progress &progress);

} // namespace vbm::impl
