// SPDX-License-Identifier: GPL-3.0-or-later
// Amenta, Choi, Rote, "Incremental constructions con BRIO" (2003). It differs in that the rounds
// come from a fixed hash of the point's index, so that the order, and all that follows, is the same
// each time.
#include "surface/insertion_order.h"

#include "core/hash.h"
#include "core/progress.h"

#include <algorithm>
#include <limits>

namespace vbm::impl {
namespace {

constexpr int kBits = 19;           // of each coordinate in the key
constexpr int kRounds = 16;         // the key's bits above that
constexpr int kMostBucketBits = 12; // of the curve's bits, to sort by first

/// Each bit three times as far from the lowest.
uint64_t spread(uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

/// Index along a Hilbert curve of 2^(3 bits) cells: Skilling, "Programming the Hilbert curve"
/// (2004).
uint64_t hilbert_index(uint32_t x[3]) {
  for (uint32_t q = 1u << (kBits - 1); q > 1; q >>= 1) {
    const uint32_t p = q - 1;
    for (int i = 0; i < 3; ++i) { // as good as random, so nothing is branched on it
      const uint32_t set = 0u - uint32_t((x[i] & q) != 0), t = (x[0] ^ x[i]) & p & ~set;
      x[0] ^= t | (p & set);
      x[i] ^= t;
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  uint32_t t = 0;
  for (uint32_t q = 1u << (kBits - 1); q > 1; q >>= 1)
    if (x[2] & q) t ^= q - 1;
  return spread(x[0] ^ t) << 2 | spread(x[1] ^ t) << 1 | spread(x[2] ^ t);
}

} // namespace

std::vector<int32_t> insertion_order(const std::vector<Vec3> &points, Progress &progress) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Vec3 low{inf, inf, inf}, high{-inf, -inf, -inf};
  for (const Vec3 &p : points)
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  double side = 0;
  for (int a = 0; a < 3; ++a) side = std::max(side, high[a] - low[a]);
  const double scale = side > 0 ? ((1 << kBits) - 1) / side : 0;

  // Seven of eight points come in the last round, seven of eight of the others in the one before,
  // and so on: fewer jumps back to the curve's beginning than with halves, and as few detours.
  struct Key {
    uint64_t place; // on the curve, below the round
    int32_t point;
  };
  std::vector<Key> key(points.size()), sorted(points.size());
  // Buckets of some ten points in the last round.
  int bucket_bits = 0;
  while (bucket_bits < kMostBucketBits && points.size() >> (bucket_bits + 4)) ++bucket_bits;
  const int bucket_shift = 3 * kBits - bucket_bits;
  std::vector<uint32_t> first((std::size_t(kRounds) << bucket_bits) + 1, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    progress.tick(i, points.size());
    uint32_t cell[3];
    for (int a = 0; a < 3; ++a) cell[a] = uint32_t((points[i][a] - low[a]) * scale);
    uint64_t round = kRounds - 1;
    for (uint64_t h = hash_index(i); (h & 7) == 0 && round > 0; h >>= 3) --round;
    key[i] = {round << (3 * kBits) | hilbert_index(cell), int32_t(i)};
    ++first[(key[i].place >> bucket_shift) + 1];
  }
  progress.tick_slow(1, 1);
  // Pieces of the curve, then each piece.
  for (std::size_t b = 1; b < first.size(); ++b) first[b] += first[b - 1];
  std::vector<uint32_t> next(first.begin(), first.end() - 1);
  for (const Key &k : key) sorted[next[k.place >> bucket_shift]++] = k;
  for (std::size_t b = 0; b + 1 < first.size(); ++b) {
    progress.tick(b, first.size());
    std::sort(sorted.begin() + first[b], sorted.begin() + first[b + 1],
              [](const Key &a, const Key &b) {
                return a.place != b.place ? a.place < b.place : a.point < b.point;
              });
  }
  std::vector<int32_t> order(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) order[i] = sorted[i].point;
  return order;
}

} // namespace vbm::impl
