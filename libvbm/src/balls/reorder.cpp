// SPDX-License-Identifier: GPL-3.0-or-later
// The input's order may jump about in space (a mesh subdivided level by level), and then every pass
// over the tetrahedra waits for memory: on half a million samples labelling took twice as long.
#include "balls/reorder.h"

#include <algorithm>

namespace vbm::impl {

namespace {

template <class T>
void gather(std::vector<T> &v, const std::vector<int32_t> &order, Progress &progress) {
  progress.tick_slow(0, 1);
  if (v.empty()) return;
  std::vector<T> out(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) out[i] = i < order.size() ? v[order[i]] : v[i];
  v.swap(out);
}

template <class T>
void scatter(std::vector<T> &v, const std::vector<int32_t> &order, Progress &progress) {
  progress.tick_slow(0, 1);
  if (v.empty()) return;
  std::vector<T> out(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) out[i < order.size() ? order[i] : i] = v[i];
  v.swap(out);
}

} // namespace

void reorder(Samples &samples, const std::vector<int32_t> &order, Progress &progress) {
  gather(samples.position, order, progress);
  gather(samples.normal, order, progress);
  gather(samples.input, order, progress);
  gather(samples.input_position, order, progress);
  std::vector<int32_t> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = int32_t(i);
  for (int32_t &s : samples.input_sample)
    if (s >= 0) s = rank[s];
}

void restore_order(Model &model, const std::vector<int32_t> &order, Progress &progress) {
  const auto renumber = [&](int32_t s) { return s < int32_t(order.size()) ? order[s] : s; };
  scatter(model.samples.position, order, progress);
  scatter(model.samples.normal, order, progress);
  scatter(model.samples.input, order, progress);
  scatter(model.samples.input_position, order, progress);
  scatter(model.inner_pole, order, progress);
  scatter(model.outer_pole, order, progress);
  for (int32_t &s : model.samples.input_sample)
    if (s >= 0) s = renumber(s);
  for (auto &cell : model.cells.vertex) {
    progress.tick(0, 1);
    for (int32_t &v : cell)
      if (v < model.cells.samples) v = renumber(v);
  }
  Incidence &touched = model.ball_samples;
  for (int32_t &s : touched.index) s = renumber(s);
  for (std::size_t b = 0; b + 1 < touched.offset.size(); ++b) {
    progress.tick(0, 1);
    std::sort(touched.index.begin() + touched.offset[b],
              touched.index.begin() + touched.offset[b + 1]);
  }
  for (int32_t &s : model.undersampled) s = renumber(s);
  std::sort(model.undersampled.begin(), model.undersampled.end());
}

} // namespace vbm::impl
