// SPDX-License-Identifier: GPL-3.0-or-later
// Amenta, Kolluri, "The medial axis of a union of balls" (2001); thesis 7.3.1, 7.4. Within the
// power shape every point is nearest, of all of the union's boundary, to a singular point; so all
// inside vertices of their Voronoi diagram are in the power shape, and restricting the diagram to
// it is keeping what is inside. It differs in that
// - all samples are sites. Those that fewer than three balls touch are no singular points, but as
//   they are on the union's boundary they change nothing in the power shape, and hold the topology
//   where balls are few;
// - cospherical sites are found by incidence: all tetrahedra whose four sites are on one ball have
//   that ball, exactly, and are inside if it is an inner one. Rounding cannot take them apart;
// - a tetrahedron that is one of the model's is inside if that one is.
#include "medial/singular_voronoi.h"

#include "balls/circumcenter.h"
#include "balls/delaunay.h"
#include "balls/labels.h"
#include "balls/repair.h"
#include "core/grid.h"
#include "core/hash.h"
#include "core/progress.h"
#include "medial/cell_lists.h"
#include "sampling/near_table.h"

#include <algorithm>

namespace vbm::impl {
namespace {

/// Tetrahedra allowed for a site, and for any number of them, as when a model is built.
constexpr uint64_t kCellsPerSite = 40, kMostCells = 1000000;

class Builder {
public:
  Builder(const Model &model, const PowerShape &shape, const std::vector<uint8_t> &take,
          Progress &progress)
      : model_(model), shape_(shape), take_(take), progress_(progress) {}

  SingularVoronoi run() {
    NearTable table(model_.samples.position.size() + shape_.points.size());
    take_samples(table);
    take_points(table);
    list_balls();
    triangulate();
    find_balls();
    label();
    return std::move(out_);
  }

private:
  std::vector<Vec3> &sites() { return out_.solid.samples.position; }

  void take_samples(NearTable &table) {
    Samples &samples = out_.solid.samples;
    samples.frame = model_.samples.frame;
    samples.rule = VBM_LABELS_NORMALS;
    for (std::size_t s = 0; s < model_.samples.position.size(); ++s) {
      progress_.tick(0, 1);
      sites().push_back(model_.samples.position[s]);
      table.add(sites());
      const int32_t inner = model_.inner_pole[s], outer = model_.outer_pole[s];
      samples.normal.push_back(inner < 0 || outer < 0
                                   ? Vec3{} // not on the surface
                                   : unit(sites()[s] - model_.balls[inner].center));
      out_.near_sample.push_back(int32_t(s));
      out_.next_sample.push_back(-1);
    }
  }

  /// Points that rounding cannot tell from a site are that site.
  void take_points(NearTable &table) {
    site_of_point_.assign(shape_.points.size(), -1);
    for (std::size_t i = 0; i < shape_.points.size(); ++i) {
      progress_.tick(0, 1);
      const SingularPoint &point = shape_.points[i];
      if (point.sample >= 0 || !take_[i]) continue;
      const Vec3 at = on_grid(point.position, kSampleGrid);
      int32_t &site = site_of_point_[i];
      site = table.find(sites(), at);
      if (site >= 0) continue;
      site = int32_t(sites().size());
      sites().push_back(at);
      table.add(sites());
      out_.solid.samples.normal.push_back(point.outward);
      out_.near_sample.push_back(point.near_sample);
      out_.next_sample.push_back(point.next_sample);
    }
  }

  /// For every site the balls it is on, in ascending order; some may be there more than once.
  void list_balls() {
    const Incidence &lists = model_.ball_samples;
    const auto visit = [&](auto &&call) { // call(site, ball)
      for (std::size_t b = 0; b + 1 < lists.offset.size(); ++b) {
        progress_.tick(0, 1);
        for (uint64_t k = lists.offset[b]; k < lists.offset[b + 1]; ++k)
          call(lists.index[k], int32_t(b));
      }
      for (std::size_t i = 0; i < site_of_point_.size(); ++i) {
        progress_.tick(0, 1);
        if (site_of_point_[i] >= 0)
          for (int32_t b : shape_.points[i].balls) call(site_of_point_[i], b);
      }
    };
    std::vector<uint64_t> &offset = site_balls_.offset;
    offset.assign(sites().size() + 1, 0);
    visit([&](int32_t site, int32_t) { ++offset[std::size_t(site) + 1]; });
    for (std::size_t s = 0; s < sites().size(); ++s) offset[s + 1] += offset[s];
    site_balls_.index.resize(offset.back());
    std::vector<uint64_t> next(offset.begin(), offset.end() - 1);
    visit([&](int32_t site, int32_t ball) { site_balls_.index[next[site]++] = ball; });
    for (std::size_t s = 0; s < sites().size(); ++s) {
      progress_.tick(0, 1);
      std::sort(site_balls_.index.begin() + int64_t(offset[s]),
                site_balls_.index.begin() + int64_t(offset[s + 1]));
    }
  }

  void triangulate() {
    const std::vector<int32_t> order = spatial_order(sites(), progress_);
    std::vector<Vec3> points;
    for (int32_t s : order) points.push_back(sites()[s]);
    Delaunay delaunay;
    delaunay.insert(points, kMostCells + kCellsPerSite * points.size(), progress_);
    out_.solid.cells = delaunay.cells(progress_);
    for (auto &cell : out_.solid.cells.vertex)
      for (int32_t &v : cell)
        if (v < out_.solid.cells.samples) v = order[v];
  }

  /// The least ball, inner ones first, that all four sites of a tetrahedron are on, or -1.
  int32_t common_ball(std::size_t c) const {
    const auto &v = out_.solid.cells.vertex[c];
    if (out_.solid.cells.has_corner(c)) return -1;
    const auto begin = [&](int i) { return site_balls_.index.data() + site_balls_.offset[v[i]]; };
    const auto end = [&](int i) { return site_balls_.index.data() + site_balls_.offset[v[i] + 1]; };
    for (const int32_t *b = begin(0); b != end(0); ++b) {
      bool all = true;
      for (int i = 1; i < 4 && all; ++i) all = std::binary_search(begin(i), end(i), *b);
      if (all) return *b;
    }
    return -1;
  }

  void find_balls() {
    const Cells &cells = out_.solid.cells;
    std::vector<int32_t> &known = out_.solid.ball_of_cell;
    std::vector<uint8_t> only(cells.size());
    known.resize(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      progress_.tick(0, 1);
      known[c] = common_ball(c);
      only[c] = known[c] < 0;
    }
    out_.balls = merge_cospherical(cells, sites(), circumscribe(cells, sites(), progress_, &only),
                                   progress_, &only);
    std::vector<int32_t> number(model_.balls.size(), -1);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (known[c] < 0) continue;
      int32_t &n = number[known[c]];
      if (n < 0) {
        n = int32_t(out_.balls.ball.size());
        out_.balls.ball.push_back(model_.balls[known[c]]);
      }
      out_.balls.of_cell[c] = n;
    }
  }

  using Quad = std::array<int32_t, 4>;

  Quad sorted(const Quad &quad) const {
    Quad out = quad;
    std::sort(out.begin(), out.end());
    return out;
  }

  /// The model's tetrahedra by their least sample, and within that by their samples.
  void list_known() {
    const Cells &cells = model_.cells;
    known_ = lists_of(std::size_t(cells.samples), cells.size(), [&](std::size_t c, auto &&call) {
      progress_.tick(0, 1);
      if (!cells.has_corner(c)) call(sorted(cells.vertex[c])[0]);
    });
    for (std::size_t s = 0; s + 1 < known_.offset.size(); ++s) {
      progress_.tick(0, 1);
      std::sort(known_.index.begin() + int64_t(known_.offset[s]),
                known_.index.begin() + int64_t(known_.offset[s + 1]), [&](int32_t a, int32_t b) {
                  return sorted(cells.vertex[a]) < sorted(cells.vertex[b]);
                });
    }
  }

  /// The model's tetrahedron with these samples, or -1.
  int32_t find_known(const Quad &vertices) const {
    const Quad key = sorted(vertices);
    if (key[3] >= model_.cells.samples) return -1;
    const auto end = known_.index.begin() + int64_t(known_.offset[std::size_t(key[0]) + 1]);
    const auto at = std::lower_bound(
        known_.index.begin() + int64_t(known_.offset[key[0]]), end, key,
        [&](int32_t c, const Quad &quad) { return sorted(model_.cells.vertex[c]) < quad; });
    return at != end && sorted(model_.cells.vertex[*at]) == key ? *at : -1;
  }

  void label() {
    list_known();
    Model &solid = out_.solid;
    const Labels labels = label_balls(solid.samples, solid.cells, out_.balls, progress_);
    std::vector<float> confidence(solid.cells.size());
    solid.inside.resize(solid.cells.size());
    for (std::size_t c = 0; c < solid.cells.size(); ++c) {
      progress_.tick(0, 1);
      const int32_t b = out_.balls.of_cell[c], known = solid.ball_of_cell[c];
      solid.inside[c] = known < 0 ? labels.inside[b] : std::size_t(known) < model_.inner;
      confidence[c] = known < 0 ? std::min(labels.confidence[b], 0.99f) : 1;
      if (solid.cells.has_corner(c)) solid.inside[c] = 0, confidence[c] = 1;
      if (const int32_t same = find_known(solid.cells.vertex[c]); same >= 0) {
        solid.inside[c] = model_.inside[same];
        confidence[c] = 1;
      }
    }
    repair_labels(solid.cells, confidence, solid.inside, progress_);
    solid.inner = model_.inner;
    for (std::size_t c = 0; c < solid.cells.size(); ++c)
      if (!solid.inside[c] || std::size_t(solid.ball_of_cell[c]) >= model_.inner)
        solid.ball_of_cell[c] = -1;
  }

  const Model &model_;
  const PowerShape &shape_;
  const std::vector<uint8_t> &take_;
  Progress &progress_;
  std::vector<int32_t> site_of_point_; // -1: a sample, or not taken
  Incidence site_balls_;
  Incidence known_; // per sample: tetrahedra of the model
  SingularVoronoi out_;
};

} // namespace

SingularVoronoi singular_voronoi(const Model &model, const PowerShape &shape,
                                 const std::vector<uint8_t> &take, Progress &progress) {
  return Builder(model, shape, take, progress).run();
}

} // namespace vbm::impl
