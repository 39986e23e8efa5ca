// SPDX-License-Identifier: GPL-3.0-or-later
// Klincsek, "Minimal triangulations of polygonal domains" (1980), with the worst triangle's shape
// in the place of the sum of lengths. Large polygons are halved first. It differs in minding the
// other polygons: where two share vertices that are no edge's ends, both could be cut there, and
// one of them must not.
#include "surface/triangulate.h"

#include "core/progress.h"

#include <algorithm>
#include <limits>

namespace vbm::impl {
namespace {

constexpr std::size_t kSmall =
    16; // corners up to which the best of all triangulations is looked for
constexpr double kNever = -std::numeric_limits<double>::infinity();

class Cutting {
public:
  Cutting(const std::vector<Vec3> &position, const Incidence &polygons, Progress &progress)
      : position_(position), polygons_(polygons), progress_(progress) {
    list_edges();
  }

  Triangles run() {
    const std::size_t count = polygons_.offset.size() - 1;
    result_.corners.reserve(polygons_.index.size() - 2 * count);
    result_.polygon.reserve(polygons_.index.size() - 2 * count);
    for (std::size_t p = 0; p < count; ++p) {
      progress_.tick(p, count);
      corner_ = polygons_.index.data() + polygons_.offset[p];
      const std::size_t size = polygons_.offset[p + 1] - polygons_.offset[p];
      const std::size_t first = result_.corners.size(), diagonals = diagonal_.size();
      bool whole = true;
      if (size == 3) {
        add(0, 1, 2);
      } else {
        normal_ = newell(size);
        index_.resize(size);
        for (std::size_t i = 0; i < size; ++i) index_[i] = int32_t(i);
        whole = cut(0, size);
      }
      if (!whole) {
        result_.corners.resize(first);
        diagonal_.resize(diagonals);
        result_.cut.push_back(int32_t(p));
      }
      for (std::size_t i = diagonals; i < diagonal_.size(); ++i) diagonal_[i].polygon = int32_t(p);
      result_.polygon.resize(result_.corners.size(), int32_t(p));
    }
    find_shared_diagonals();
    if (!result_.cut.empty()) insert_middles();
    return std::move(result_);
  }

private:
  struct Diagonal {
    int32_t low, high, polygon;
  };

  /// Where the edges from each vertex lead.
  void list_edges() {
    first_.assign(position_.size() + 1, 0);
    for (int32_t v : polygons_.index) ++first_[v + 1];
    for (std::size_t v = 0; v < position_.size(); ++v) first_[v + 1] += first_[v];
    head_.resize(polygons_.index.size());
    std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t p = 0; p + 1 < polygons_.offset.size(); ++p) {
      progress_.tick(0, 1);
      int32_t tail = polygons_.index[polygons_.offset[p + 1] - 1];
      for (uint64_t i = polygons_.offset[p]; i < polygons_.offset[p + 1]; ++i) {
        head_[next[tail]++] = polygons_.index[i];
        tail = polygons_.index[i];
      }
    }
  }

  bool is_edge(int32_t a, int32_t b) const {
    for (uint32_t i = first_[a]; i < first_[a + 1]; ++i)
      if (head_[i] == b) return true;
    return false;
  }

  Vec3 newell(std::size_t size) const {
    Vec3 normal;
    const Vec3 origin = position_[corner_[0]];
    for (std::size_t i = 2; i < size; ++i)
      normal += cross(position_[corner_[i - 1]] - origin, position_[corner_[i]] - origin);
    return unit(normal);
  }

  /// Area by squared edge lengths, negative for triangles that face backwards.
  double shape(std::size_t i, std::size_t j, std::size_t k) const {
    const Vec3 &a = position_[corner_[i]], &b = position_[corner_[j]], &c = position_[corner_[k]];
    const Vec3 u = b - a, v = c - a, w = c - b;
    const double size = dot(u, u) + dot(v, v) + dot(w, w);
    return size > 0 ? dot(cross(u, v), normal_) / size : 0;
  }

  void add(std::size_t i, std::size_t j, std::size_t k) {
    result_.corners.push_back({corner_[i], corner_[j], corner_[k]});
  }

  void add_diagonal(std::size_t i, std::size_t j) {
    diagonal_.push_back({std::min(corner_[i], corner_[j]), std::max(corner_[i], corner_[j]), -1});
  }

  /// Cut the part of the polygon whose corners are index_[begin] .. index_[end - 1].
  bool cut(std::size_t begin, std::size_t end) {
    const std::size_t size = end - begin;
    if (size <= kSmall) return cut_best(begin, size);
    for (std::size_t half = size / 2, step = 0; step < size / 4; ++step)
      for (std::size_t m : {half - step, half + step}) {
        if (is_edge(corner_[index_[begin]], corner_[index_[begin + m]])) continue;
        add_diagonal(index_[begin], index_[begin + m]);
        // The second half is moved behind the first, with the two corners they share in both.
        std::vector<int32_t> second(index_.begin() + begin + m, index_.begin() + end);
        second.push_back(index_[begin]);
        if (!cut(begin, begin + m + 1)) return false;
        std::copy(second.begin(), second.end(), index_.begin() + begin);
        return cut(begin, begin + second.size());
      }
    return false;
  }

  bool cut_best(std::size_t begin, std::size_t n) {
    const int32_t *at = index_.data() + begin;
    double best[kSmall][kSmall]; // from corner to corner; what is read was written before
    uint8_t apex[kSmall][kSmall];
    best[0][n - 1] = kNever;
    for (std::size_t i = 0; i + 1 < n; ++i) best[i][i + 1] = std::numeric_limits<double>::max();
    for (std::size_t gap = 2; gap < n; ++gap)
      for (std::size_t i = 0, j = gap; j < n; ++i, ++j) {
        best[i][j] = kNever;
        apex[i][j] = uint8_t(i + 1);
        const bool outer = gap + 1 == n;
        if (!outer && is_edge(corner_[at[i]], corner_[at[j]])) continue;
        for (std::size_t k = i + 1; k < j; ++k) {
          double worst = std::min(best[i][k], best[k][j]);
          if (worst <= best[i][j]) continue;
          worst = std::min(worst, shape(at[i], at[k], at[j]));
          if (worst <= best[i][j]) continue;
          best[i][j] = worst;
          apex[i][j] = uint8_t(k);
        }
      }
    if (best[0][n - 1] == kNever) return false;
    emit(at, apex, 0, n - 1, true);
    return true;
  }

  void emit(const int32_t *at, const uint8_t (*apex)[kSmall], std::size_t i, std::size_t j,
            bool outer) {
    if (j - i < 2) return;
    const std::size_t k = apex[i][j];
    if (!outer) add_diagonal(at[i], at[j]);
    add(at[i], at[k], at[j]);
    emit(at, apex, i, k, false);
    emit(at, apex, k, j, false);
  }

  /// Polygons with a diagonal that an earlier one has, too.
  void find_shared_diagonals() {
    if (diagonal_.empty()) return;
    std::vector<uint32_t> first(position_.size() + 1, 0);
    for (const Diagonal &d : diagonal_) ++first[d.low + 1];
    for (std::size_t v = 0; v < position_.size(); ++v) first[v + 1] += first[v];
    std::vector<uint32_t> next(first.begin(), first.end() - 1), order(diagonal_.size());
    for (std::size_t i = 0; i < diagonal_.size(); ++i)
      order[next[diagonal_[i].low]++] = uint32_t(i);
    const std::size_t known = result_.cut.size();
    for (std::size_t v = 0; v < position_.size(); ++v) {
      progress_.tick(1, 1);
      const auto begin = order.begin() + first[v], end = order.begin() + first[v + 1];
      if (end - begin < 2) continue;
      std::sort(begin, end, [&](uint32_t a, uint32_t b) {
        return diagonal_[a].high != diagonal_[b].high ? diagonal_[a].high < diagonal_[b].high
                                                      : a < b;
      });
      for (auto i = begin; i < end; ++i)
        if (i != begin && diagonal_[*i].high == diagonal_[*(i - 1)].high)
          result_.cut.push_back(diagonal_[*i].polygon);
    }
    if (result_.cut.size() == known) return;
    std::sort(result_.cut.begin(), result_.cut.end());
    result_.cut.erase(std::unique(result_.cut.begin(), result_.cut.end()), result_.cut.end());
  }

  /// Triangles of polygons in `cut` run from each edge to a new vertex.
  void insert_middles() {
    Triangles old;
    std::swap(old, result_);
    result_.cut = std::move(old.cut);
    std::size_t t = 0;
    for (std::size_t i = 0; i <= result_.cut.size(); ++i) {
      const int32_t p =
          i < result_.cut.size() ? result_.cut[i] : std::numeric_limits<int32_t>::max();
      for (; t < old.corners.size() && old.polygon[t] < p; ++t) {
        result_.corners.push_back(old.corners[t]);
        result_.polygon.push_back(old.polygon[t]);
      }
      if (i == result_.cut.size()) break;
      while (t < old.corners.size() && old.polygon[t] == p) ++t;
      int32_t tail = polygons_.index[polygons_.offset[p + 1] - 1];
      for (uint64_t k = polygons_.offset[p]; k < polygons_.offset[p + 1]; ++k) {
        result_.corners.push_back({tail, polygons_.index[k], int32_t(position_.size() + i)});
        result_.polygon.push_back(p);
        tail = polygons_.index[k];
      }
    }
  }

  const std::vector<Vec3> &position_;
  const Incidence &polygons_;
  Progress &progress_;
  std::vector<uint32_t> first_;
  std::vector<int32_t> head_;
  const int32_t *corner_ = nullptr; // of the polygon at work
  Vec3 normal_;
  std::vector<int32_t> index_;
  std::vector<Diagonal> diagonal_;
  Triangles result_;
};

} // namespace

Triangles triangulate(const std::vector<Vec3> &position, const Incidence &polygons,
                      Progress &progress) {
  return Cutting(position, polygons, progress).run();
}

} // namespace vbm::impl
