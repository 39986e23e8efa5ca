// SPDX-License-Identifier: GPL-3.0-or-later
// Exact sums and products of doubles that take no memory.
//
// CGAL's number type for exact predicates keeps up to eight 64-bit digits in itself and calls for
// memory beyond; if there is none, its destructor frees what it never got. So coordinates lie on a
// grid (core/grid.h) and are scaled so that each is one digit; polynomials of degree 5 fit. (GMP's
// own types end the process when memory runs out.)
#pragma once

#include <CGAL/Number_types/internal/Exact_type_selector.h>

namespace vbm::impl {

using Exact = CGAL::internal::Exact_ring_selector<double>::Type;

/// Factors that make multiples of kSampleGrid and kSiteGrid numbers of one digit.
inline constexpr double kSampleScale = 0x1p-4, kSiteScale = 0x1p-10;

} // namespace vbm::impl
