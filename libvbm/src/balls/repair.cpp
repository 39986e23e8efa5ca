// SPDX-License-Identifier: GPL-3.0-or-later
// Greedy descent on the number of surplus groups of tetrahedra round the samples (see
// Star::surplus).
#include "balls/repair.h"

#include "balls/stars.h"

#include <algorithm>

namespace vbm::impl {

namespace {

class Repair {
public:
  Repair(const Cells &cells, const std::vector<float> &confidence, std::vector<uint8_t> &inside,
         Progress &progress)
      : cells_(cells), confidence_(confidence), inside_(inside), progress_(progress), star_(cells) {
  }

  std::size_t run() {
    const std::vector<Sheets> sheets = find_sheets(cells_, inside_, progress_);
    std::vector<int32_t> bad;
    for (int32_t s = 0; s < cells_.samples; ++s)
      if (sheets[s] == Sheets::several) bad.push_back(s);
    std::size_t turned = 0;
    for (int pass = 0; pass < kPasses && !bad.empty(); ++pass) {
      std::vector<int32_t> again;
      std::size_t before = turned;
      for (int32_t s : bad) {
        progress_.tick(0, 1);
        while (surplus(s) > 0 && turn_one(s)) ++turned;
        if (surplus(s) > 0) again.push_back(s);
      }
      bad.swap(again);
      if (turned == before) break;
    }
    return turned;
  }

private:
  int surplus(int32_t s) {
    star_.go_to(s);
    return star_.surplus(inside_);
  }

  /// Turn the cell round s that lowers the surplus of its four samples, the least certain one among
  /// those that lower it. False if none does.
  bool turn_one(int32_t s) {
    std::vector<std::pair<float, int32_t>> candidates;
    star_.go_to(s);
    for (int32_t c : star_.cells())
      if (confidence_[c] < 1 && !cells_.has_corner(c)) candidates.push_back({confidence_[c], c});
    std::sort(candidates.begin(), candidates.end());
    for (const auto &[confidence, c] : candidates) {
      bool border = false;
      for (int32_t n : cells_.neighbor[c]) border |= n >= 0 && inside_[n] != inside_[c];
      if (border && turn(c)) return true;
    }
    return false;
  }

  /// Turn cell c if that lowers the surplus of its samples.
  bool turn(int32_t c) {
    int change = 0;
    for (int32_t v : cells_.vertex[c]) {
      if (v >= cells_.samples) continue;
      change -= surplus(v);
      inside_[c] ^= 1;
      change += star_.surplus(inside_);
      inside_[c] ^= 1;
    }
    if (change < 0) inside_[c] ^= 1;
    return change < 0;
  }

  static constexpr int kPasses = 8;

  const Cells &cells_;
  const std::vector<float> &confidence_;
  std::vector<uint8_t> &inside_;
  Progress &progress_;
  Star star_;
};

} // namespace

std::size_t repair_labels(const Cells &cells, const std::vector<float> &confidence,
                          std::vector<uint8_t> &inside, Progress &progress) {
  return Repair(cells, confidence, inside, progress).run();
}

} // namespace vbm::impl
