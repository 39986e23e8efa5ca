// SPDX-License-Identifier: GPL-3.0-or-later
// Which voxels of a volume are inside, a bit each.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vbm::impl {

/// Bits of an nx x ny x nz grid; all around it is outside.
class VoxelLabels {
public:
  VoxelLabels(std::size_t nx, std::size_t ny, std::size_t nz)
      : n_{nx, ny, nz}, words_(nz / 64 + 1), bits_(nx * ny * words_, 0) {}

  std::size_t n(int axis) const { return n_[axis]; }
  void set_inside(std::size_t i, std::size_t j, std::size_t k) {
    bits_[(i * n_[1] + j) * words_ + k / 64] |= uint64_t(1) << (k % 64);
  }
  /// For any indices, also those beyond the grid.
  bool inside(double i, double j, double k) const {
    const double at[3] = {i, j, k};
    for (int a = 0; a < 3; ++a)
      if (!(at[a] >= 0 && at[a] < static_cast<double>(n_[a]))) return false;
    const std::size_t z = static_cast<std::size_t>(k);
    return row(static_cast<std::size_t>(i), static_cast<std::size_t>(j))[z / 64] >> (z % 64) & 1;
  }

  /// Call visit(i, j, k, axis, step) for every pair of a voxel in the grid and its neighbour along
  /// the axis (step 1; or -1, only from the grid's first voxels to beyond it) of which one is
  /// inside; and tick() once a row.
  template <class Visit, class Tick> void for_each_crossing(Visit visit, Tick tick) const {
    for (std::size_t i = 0; i < n_[0]; ++i)
      for (std::size_t j = 0; j < n_[1]; ++j) {
        tick(i * n_[1] + j, n_[0] * n_[1]);
        const uint64_t *here = row(i, j);
        const uint64_t *next_i = i + 1 < n_[0] ? row(i + 1, j) : nullptr;
        const uint64_t *next_j = j + 1 < n_[1] ? row(i, j + 1) : nullptr;
        for (std::size_t w = 0; w < words_; ++w) {
          const uint64_t word = here[w];
          const uint64_t next_k = word >> 1 | (w + 1 < words_ ? here[w + 1] << 63 : 0);
          const auto each = [&](uint64_t bits, int axis, int step) {
            for (; bits; bits &= bits - 1) visit(i, j, w * 64 + lowest(bits), axis, step);
          };
          if (i == 0) each(word, 0, -1);
          if (j == 0) each(word, 1, -1);
          if (w == 0) each(word & 1, 2, -1);
          each(word ^ (next_i ? next_i[w] : 0), 0, 1);
          each(word ^ (next_j ? next_j[w] : 0), 1, 1);
          // The last bit of all words but the row's last is compared with the next word's first.
          each(word ^ next_k, 2, 1);
        }
      }
  }

private:
  static std::size_t lowest(uint64_t bits) {
    return static_cast<std::size_t>(std::ilogb(static_cast<double>(bits & (~bits + 1))));
  }
  const uint64_t *row(std::size_t i, std::size_t j) const {
    return bits_.data() + (i * n_[1] + j) * words_;
  }

  std::size_t n_[3], words_;
  std::vector<uint64_t> bits_;
};

} // namespace vbm::impl
