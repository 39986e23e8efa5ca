// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball_parts.h"

#include <map>

namespace vbm_filters {

std::vector<std::int32_t> ball_parts(const vbm::Model &model, const vbm::Axis &axis) {
  const std::size_t inner = model.inner_count();
  const vbm::Lists of_part = axis.part_balls();
  std::vector<std::int32_t> part(inner, kNoPart);
  for (std::size_t p = 0; p < of_part.size(); ++p)
    for (std::int32_t ball : of_part[p]) part[ball] = static_cast<std::int32_t>(p);

  // Ring by ring, all of a ring at once, so that no order of the balls shows.
  const vbm::Lists neighbors = model.ball_neighbors();
  std::vector<std::int32_t> front, waiting;
  for (std::size_t b = 0; b < inner; ++b)
    if (part[b] == kNoPart) waiting.push_back(static_cast<std::int32_t>(b));
  std::vector<std::uint8_t> queued(inner, 0);
  const auto has_known = [&](std::int32_t b) {
    for (std::int32_t other : neighbors[b])
      if (part[other] != kNoPart) return true;
    return false;
  };
  for (std::int32_t b : waiting)
    if (has_known(b)) {
      front.push_back(b);
      queued[b] = 1;
    }
  while (!front.empty()) {
    std::vector<std::int32_t> found;
    found.reserve(front.size());
    for (std::int32_t b : front) {
      std::map<std::int32_t, int> votes;
      for (std::int32_t other : neighbors[b])
        if (part[other] != kNoPart) ++votes[part[other]];
      auto best = votes.begin();
      for (auto vote = votes.begin(); vote != votes.end(); ++vote)
        if (vote->second > best->second) best = vote;
      found.push_back(best->first);
    }
    std::vector<std::int32_t> next;
    for (std::size_t i = 0; i < front.size(); ++i) part[front[i]] = found[i];
    for (std::int32_t b : front)
      for (std::int32_t other : neighbors[b])
        if (part[other] == kNoPart && !queued[other]) {
          queued[other] = 1;
          next.push_back(other);
        }
    front = std::move(next);
  }
  return part;
}

std::vector<std::int32_t> input_parts(const vbm::Model &model,
                                      const std::vector<std::int32_t> &ball_part) {
  const auto radii = model.radii();
  const vbm::Lists samples = model.ball_samples();
  std::vector<std::int32_t> pole(model.samples().size, -1);
  for (std::size_t b = 0; b < ball_part.size(); ++b)
    for (std::int32_t s : samples[b])
      if (pole[s] < 0 || radii[b] > radii[pole[s]]) pole[s] = static_cast<std::int32_t>(b);

  const auto sample = model.input_sample();
  std::vector<std::int32_t> part(sample.size, kNoPart);
  for (std::size_t i = 0; i < sample.size; ++i)
    if (sample[i] >= 0 && pole[sample[i]] >= 0) part[i] = ball_part[pole[sample[i]]];
  return part;
}

} // namespace vbm_filters
