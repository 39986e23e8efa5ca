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
    take_samples();
    take_points();
    list_balls();
    triangulate();
    find_balls();
    label();
    return std::move(out_);
  }

private:
  std::vector<Vec3> &sites() { return out_.solid.samples.position; }

  void take_samples() {
    Samples &samples = out_.solid.samples;
    samples.frame = model_.samples.frame;
    samples.rule = VBM_LABELS_NORMALS;
    samples.position = model_.samples.position;
    for (std::size_t s = 0; s < sites().size(); ++s) {
      const int32_t inner = model_.inner_pole[s], outer = model_.outer_pole[s];
      samples.normal.push_back(inner < 0 || outer < 0
                                   ? Vec3{} // not on the surface
                                   : unit(sites()[s] - model_.balls[inner].center));
      out_.near_sample.push_back(int32_t(s));
      out_.next_sample.push_back(-1);
    }
  }

  /// Points that rounding cannot tell from a site are that site.
  void take_points() {
    NearTable table(sites().size() + shape_.points.size());
    std::vector<Vec3> placed;
    for (const Vec3 &p : sites()) {
      progress_.tick(0, 1);
      placed.push_back(p);
      table.add(placed);
    }
    for (std::size_t i = 0; i < shape_.points.size(); ++i) {
      progress_.tick(0, 1);
      const SingularPoint &point = shape_.points[i];
      if (point.sample >= 0 || !take_[i]) continue;
      const Vec3 at = on_grid(point.position, kSampleGrid);
      int32_t site = table.find(placed, at);
      if (site < 0) {
        site = int32_t(sites().size());
        placed.push_back(at);
        table.add(placed);
        sites().push_back(at);
        out_.solid.samples.normal.push_back(point.outward);
        out_.near_sample.push_back(point.near_sample);
        out_.next_sample.push_back(point.next_sample);
      }
      for (int32_t b : point.balls) touch_.push_back({site, b});
    }
  }

  /// For every site the balls it is on.
  void list_balls() {
    const Incidence &lists = model_.ball_samples;
    for (std::size_t b = 0; b + 1 < lists.offset.size(); ++b)
      for (uint64_t k = lists.offset[b]; k < lists.offset[b + 1]; ++k)
        touch_.push_back({lists.index[k], int32_t(b)});
    std::sort(touch_.begin(), touch_.end());
    touch_.erase(std::unique(touch_.begin(), touch_.end()), touch_.end());
    site_balls_.offset.assign(sites().size() + 1, 0);
    for (const auto &[site, ball] : touch_) ++site_balls_.offset[std::size_t(site) + 1];
    for (std::size_t s = 0; s < sites().size(); ++s)
      site_balls_.offset[s + 1] += site_balls_.offset[s];
    for (const auto &[site, ball] : touch_) site_balls_.index.push_back(ball);
    touch_ = {};
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

  /// What the model's tetrahedra are, by their samples in ascending order.
  void list_known() {
    for (std::size_t c = 0; c < model_.cells.size(); ++c) {
      progress_.tick(0, 1);
      if (model_.cells.has_corner(c)) continue;
      Known known{model_.cells.vertex[c], model_.inside[c]};
      std::sort(known.first.begin(), known.first.end());
      known_.push_back(known);
    }
    std::sort(known_.begin(), known_.end());
  }

  /// Whether a tetrahedron is one of the model's, and then whether it is inside.
  bool known_label(std::size_t c, uint8_t &inside) const {
    Known key{out_.solid.cells.vertex[c], 0};
    std::sort(key.first.begin(), key.first.end());
    const auto at = std::lower_bound(known_.begin(), known_.end(), key);
    if (at == known_.end() || at->first != key.first) return false;
    inside = at->second;
    return true;
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
      if (known_label(c, solid.inside[c])) confidence[c] = 1;
    }
    repair_labels(solid.cells, confidence, solid.inside, progress_);
    solid.inner = model_.inner;
    for (std::size_t c = 0; c < solid.cells.size(); ++c)
      if (!solid.inside[c] || std::size_t(solid.ball_of_cell[c]) >= model_.inner)
        solid.ball_of_cell[c] = -1;
  }

  using Known = std::pair<std::array<int32_t, 4>, uint8_t>;

  const Model &model_;
  const PowerShape &shape_;
  const std::vector<uint8_t> &take_;
  Progress &progress_;
  std::vector<std::array<int32_t, 2>> touch_; // site, ball
  Incidence site_balls_;
  std::vector<Known> known_;
  SingularVoronoi out_;
};

} // namespace

SingularVoronoi singular_voronoi(const Model &model, const PowerShape &shape,
                                 const std::vector<uint8_t> &take, Progress &progress) {
  return Builder(model, shape, take, progress).run();
}

} // namespace vbm::impl
