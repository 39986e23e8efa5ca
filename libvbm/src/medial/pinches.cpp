// SPDX-License-Identifier: GPL-3.0-or-later
// The inside tetrahedra at a sample, seen from it, are a part of the sphere of directions.
// Collapsed as far as it goes, each connected piece of it is a point, or the rings that are looked
// for.
#include "medial/pinches.h"

#include "balls/stars.h"
#include "core/progress.h"

#include <algorithm>
#include <map>

namespace vbm::impl {
namespace {

/// Cells, the facets between them and the Delaunay edges all round which they are: a complex that
/// is small, so that it is looked through again and again.
class Link {
public:
  Link(const Model &model, const Star &star, int32_t sample) : sample_(sample) {
    const Cells &cells = model.cells;
    std::map<int32_t, std::array<int32_t, 2>> around; // other end: cells, facets
    for (int32_t c : star.cells()) {
      if (!model.inside[c]) continue;
      for (int i = 0; i < 4; ++i) {
        if (cells.vertex[c][i] != sample) ++around[cells.vertex[c][i]][0];
        const int32_t n = cells.neighbor[c][i];
        if (cells.vertex[c][i] == sample || n < c || !model.inside[n]) continue;
        Facet f;
        f.cells = {c, n};
        f.place = i;
        for (int k = 0; k < 4; ++k)
          if (k != i && cells.vertex[c][k] != sample) {
            f.ends[f.ends[0] < 0 ? 0 : 1] = cells.vertex[c][k];
            ++around[cells.vertex[c][k]][1];
          }
        facets_.push_back(f);
      }
    }
    for (const auto &[end, count] : around)
      if (count[0] == count[1]) full_.push_back(end);
  }

  Pinch rings() {
    while (collapse_faces()) {
    }
    while (cut_ends()) {
    }
    Pinch out;
    out.sample = sample_;
    for (const Facet &f : facets_)
      if (f.left) out.facets.push_back({f.cells[0], f.place});
    return out;
  }

private:
  struct Facet {
    std::array<int32_t, 2> cells{};
    int32_t place = 0;
    std::array<int32_t, 2> ends{-1, -1}; // of its Delaunay edges at the sample
    bool left = true;
  };

  bool is_full(int32_t end) const {
    return std::find(full_.begin(), full_.end(), end) != full_.end();
  }

  /// A facet with one full edge goes together with that.
  bool collapse_faces() {
    for (Facet &f : facets_) {
      if (!f.left || is_full(f.ends[0]) == is_full(f.ends[1])) continue;
      const int32_t end = is_full(f.ends[0]) ? f.ends[0] : f.ends[1];
      f.left = false;
      full_.erase(std::find(full_.begin(), full_.end(), end));
      return true;
    }
    return false;
  }

  /// A facet goes together with a cell that has no other.
  bool cut_ends() {
    std::map<int32_t, int> degree;
    for (const Facet &f : facets_)
      if (f.left)
        for (int32_t c : f.cells) ++degree[c];
    for (Facet &f : facets_)
      if (f.left && (degree[f.cells[0]] == 1 || degree[f.cells[1]] == 1)) {
        f.left = false;
        return true;
      }
    return false;
  }

  int32_t sample_;
  std::vector<Facet> facets_;
  std::vector<int32_t> full_; // ends of Delaunay edges with inside all round
};

} // namespace

std::vector<Pinch> find_pinches(const Model &model, Progress &progress) {
  std::vector<Pinch> out;
  const std::vector<Sheets> sheets = find_sheets(model.cells, model.inside, progress);
  if (std::find(sheets.begin(), sheets.end(), Sheets::several) == sheets.end()) return out;
  Star star(model.cells);
  for (int32_t s = 0; s < model.cells.samples; ++s) {
    progress.tick(s, sheets.size());
    if (sheets[s] != Sheets::several) continue;
    star.go_to(s);
    Pinch pinch = Link(model, star, s).rings();
    if (!pinch.facets.empty()) out.push_back(std::move(pinch));
  }
  return out;
}

} // namespace vbm::impl
