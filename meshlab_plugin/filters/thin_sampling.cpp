// SPDX-License-Identifier: GPL-3.0-or-later
#include "thin_sampling.h"

#include "nearest.h"

namespace vbm_filters {

std::vector<std::uint8_t> undersampled_vertices(const vbm::Model &model, const Layer &layer) {
  const auto thin = model.undersampled();
  const auto input = model.sample_input();
  std::vector<std::uint8_t> chosen(thin.empty() ? 0 : layer.vertex_count(), 0);
  std::vector<std::int32_t> added;
  for (std::int32_t sample : thin) {
    if (input[sample] >= 0)
      chosen[input[sample]] = 1;
    else
      added.push_back(sample);
  }
  if (added.empty()) return chosen;
  // Vertices that were left out may be anywhere, or nowhere.
  const auto sample_of = model.input_sample();
  std::vector<std::int32_t> taken;
  for (std::size_t v = 0; v < sample_of.size; ++v)
    if (sample_of[v] >= 0) taken.push_back(static_cast<std::int32_t>(v));
  const Nearest nearest(layer.points.data(), std::move(taken));
  const auto places = model.samples();
  for (std::int32_t sample : added)
    if (const std::int32_t vertex = nearest.find(places[sample]); vertex >= 0) chosen[vertex] = 1;
  return chosen;
}

std::vector<std::uint8_t> undersampled_vertices(const vbm::Model &model,
                                                const vbm::Surface &surface) {
  const auto thin = model.undersampled();
  if (thin.empty()) return {};
  std::vector<std::uint8_t> of_sample(model.samples().size, 0), chosen;
  for (std::int32_t sample : thin) of_sample[sample] = 1;
  const auto samples = surface.vertex_sample();
  chosen.reserve(samples.size);
  for (std::int32_t sample : samples) chosen.push_back(sample >= 0 ? of_sample[sample] : 0);
  return chosen;
}

} // namespace vbm_filters
