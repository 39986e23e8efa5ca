// SPDX-License-Identifier: GPL-3.0-or-later
// Where the sampling is too thin to trust a surface, as a selection of a layer's vertices.
#pragma once

#include "layer.h"

#include <vbm/vbm.hpp>

#include <cstdint>
#include <vector>

namespace vbm_filters {

// Per vertex of the layer that the model was built from, 1 where it is an undersampled sample or
// the vertex nearest to one that was added on a face; empty if there are none.
std::vector<std::uint8_t> undersampled_vertices(const vbm::Model &model, const Layer &layer);

// The same per vertex of a surface of the model.
std::vector<std::uint8_t> undersampled_vertices(const vbm::Model &model,
                                                const vbm::Surface &surface);

} // namespace vbm_filters
