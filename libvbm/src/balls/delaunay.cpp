// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's Delaunay triangulation (Jamin, Pion, Teillaud), driven by our own loop over the points in
// CGAL's biased randomised order so that progress, cancelling and the cell limit act between
// points.
#include "balls/delaunay.h"

#include "balls/block_allocator.h"
#include "core/tolerances.h"

#define CGAL_ALLOCATOR(T) vbm::impl::BlockAllocator<T>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include "core/error.h"
#include "core/exact.h"

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>

namespace vbm::impl {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<int32_t, Kernel>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<int32_t, Kernel,
                                              CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_3<VertexBase, CellBase>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, Structure>;

/// Reads point i of a Vec3 array as a CGAL point: lets spatial_sort order indices without a copy,
/// and, as it has no progress of its own, be cancelled all the same.
struct PointOf {
  using key_type = std::size_t;
  using value_type = Point;
  using reference = Point;
  using category = boost::readable_property_map_tag;
  const Vec3 *points;
  Progress *progress;
  friend Point get(const PointOf &map, std::size_t i) {
    map.progress->tick(0, 1);
    return {map.points[i].x, map.points[i].y, map.points[i].z};
  }
};

/// A finite cell's least vertex (samples before box corners); samples + 8 for an infinite cell.
int32_t group_of(const Triangulation &triangulation, Triangulation::Cell_handle c,
                 int32_t samples) {
  int32_t least = samples + 8;
  for (int i = 0; i < 4; ++i) {
    if (c->vertex(i) == triangulation.infinite_vertex()) return samples + 8;
    const int32_t v = c->vertex(i)->info();
    least = std::min(least, v >= 0 ? v : samples + (-1 - v));
  }
  return least;
}

/// The triangulation's points are scaled, so that exact predicates take no memory.
Point to_point(const Vec3 &p) {
  return {p.x * kSampleScale, p.y * kSampleScale, p.z * kSampleScale};
}
Vec3 to_vec(const Point &p) {
  return {p.x() / kSampleScale, p.y() / kSampleScale, p.z() / kSampleScale};
}

} // namespace

struct Delaunay::Impl {
  Blocks blocks; // outlives the triangulation
  Triangulation triangulation = make(blocks);
  std::array<Vec3, 8> corner;
  int32_t samples = 0;
  Triangulation::Cell_handle last; // where to look for the next point

  static Triangulation make(Blocks &blocks) {
    const Blocks::Scope scope(blocks);
    return Triangulation();
  }

  /// While CGAL fills a hole of up to 128 facets it keeps a table that belongs to the thread, not
  /// to the triangulation. Out of memory in its midst, it would leave the table in disorder for the
  /// thread's next triangulation; so the new cells must be there before.
  Triangulation::Vertex_handle insert(const Vec3 &point, Triangulation::Cell_handle hint) {
    constexpr std::size_t kHole = 128;
    auto &cells = triangulation.tds().cells();
    // One block at a time: a second one that fails would leave the first half made.
    while (cells.capacity() < cells.size() + kHole) cells.reserve(cells.capacity() + 1);
    return triangulation.insert(to_point(point), hint);
  }

  /// The vertex nearest to a point, by distances in doubles. CGAL's nearest_vertex() compares them
  /// in GMP's fractions where they are close, and GMP ends the process when it runs out of memory.
  Triangulation::Vertex_handle nearest(const Vec3 &point) const {
    const Triangulation::Cell_handle cell = triangulation.locate(to_point(point), last);
    Triangulation::Vertex_handle best;
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](Triangulation::Vertex_handle v) {
      if (triangulation.is_infinite(v)) return false;
      const double d = distance(to_vec(v->point()), point);
      if (!(d < least)) return false;
      least = d;
      best = v;
      return true;
    };
    for (int i = 0; i < 4; ++i) consider(cell->vertex(i));
    // A vertex without a nearer one among its neighbours is the nearest in a Delaunay
    // triangulation.
    std::vector<Triangulation::Vertex_handle> around;
    for (bool nearer = true; nearer;) {
      nearer = false;
      around.clear();
      triangulation.finite_adjacent_vertices(best, std::back_inserter(around));
      for (const auto v : around) nearer |= consider(v);
    }
    return best;
  }
};

/// Biased randomised insertion order (Amenta, Choi, Rote 2003) of points first .. count - 1 that
/// lie along a space-filling curve: each of ever larger rounds goes along the curve once. A point's
/// round comes from a hash of its number, so that one round holds seven eighths of all points, the
/// one before it seven eighths of the rest, and so on.
static std::vector<int32_t> insertion_order(std::size_t count) {
  constexpr int kRounds = 8;
  const auto round_of = [](std::size_t i) {
    uint64_t h = (uint64_t(i) + 1) * 0x9E3779B97F4A7C15u;
    h = (h ^ (h >> 29)) * 0xBF58476D1CE4E5B9u;
    h ^= h >> 32;
    int round = kRounds - 1;
    for (; round > 0 && (h & 7) == 0; h >>= 3) --round;
    return round;
  };
  std::vector<int32_t> order;
  order.reserve(count);
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < count; ++i)
      if (round_of(i) == round) order.push_back(int32_t(i));
  return order;
}

void check_three_dimensional(const std::vector<Vec3> &points, uint64_t given) {
  const auto fail = [&](const char *what) {
    std::string message = std::to_string(given) + (given == 1 ? " point" : " points");
    if (points.size() < given) message += " (" + std::to_string(points.size()) + " different)";
    throw Error(VBM_ERROR_DEGENERATE,
                message + " " + what + "; at least 4 that span three dimensions are needed");
  };
  if (points.size() < 4) fail("are too few: not 3-dimensional");
  // A spread-out basis: the point farthest from the first, then from their line, then from the
  // plane.
  const Vec3 o = points[0];
  std::size_t a = 0, b = 0, c = 0;
  double best = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const double d = distance(points[i], o); d > best) best = d, a = i;
  const Vec3 u = unit(points[a] - o);
  best = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const double d = length(cross(points[i] - o, u)); d > best) best = d, b = i;
  if (best < kFlat) fail("lie on one line: 1-dimensional, not 3-dimensional");
  const Vec3 n = unit(cross(u, points[b] - o));
  best = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const double d = std::fabs(dot(points[i] - o, n)); d > best) best = d, c = i;
  if (best < kFlat ||
      CGAL::coplanar(to_point(o), to_point(points[a]), to_point(points[b]), to_point(points[c])))
    fail("lie in one plane: 2-dimensional, not 3-dimensional");
}

std::vector<int32_t> spatial_order(const std::vector<Vec3> &points, Progress &progress) {
  std::vector<std::size_t> order(boost::counting_iterator<std::size_t>(0),
                                 boost::counting_iterator<std::size_t>(points.size()));
  CGAL::hilbert_sort(
      order.begin(), order.end(),
      CGAL::Spatial_sort_traits_adapter_3<Kernel, PointOf>(PointOf{points.data(), &progress}));
  return std::vector<int32_t>(order.begin(), order.end());
}

Delaunay::Delaunay() : impl_(new Impl) {
  // Slightly uneven, so that the corners are not cospherical with each other.
  for (int i = 0; i < 8; ++i) {
    const double h = kBoxHalfSide * (1 + i / 1024.);
    impl_->corner[i] = {i & 1 ? h : -h, i & 2 ? h : -h, i & 4 ? h : -h};
    impl_->insert(impl_->corner[i], {})->info() = -1 - i;
  }
}

Delaunay::~Delaunay() = default;

void Delaunay::insert(const std::vector<Vec3> &points, uint64_t cell_limit, Progress &progress) {
  Triangulation &triangulation = impl_->triangulation;
  const std::vector<int32_t> order = insertion_order(points.size());
  Triangulation::Cell_handle hint;
  for (std::size_t done = 0; done < order.size(); ++done) {
    const int32_t i = order[done];
    const auto vertex = impl_->insert(points[i], hint);
    vertex->info() = i;
    hint = vertex->cell();
    progress.tick(done, order.size());
    if ((done & 63) == 0 || triangulation.number_of_vertices() < 4096) {
      const uint64_t cells = triangulation.tds().number_of_cells();
      if (cells > cell_limit)
        throw Error(VBM_ERROR_LIMIT,
                    "resource limit: " + std::to_string(cells) + " Delaunay tetrahedra after " +
                        std::to_string(done + 1) + " of " + std::to_string(order.size()) +
                        " samples exceed the limit of " + std::to_string(cell_limit) +
                        " (cell_limit); samples along curves in space make them grow as n * n");
    }
  }
  impl_->samples = int32_t(points.size());
  impl_->last = hint;
}

bool Delaunay::insert_apart(const Vec3 &point, double apart) {
  const auto nearest = impl_->nearest(point);
  const Vec3 there = to_vec(nearest->point());
  if (there == point || distance(there, point) < apart) return false;
  const auto vertex = impl_->insert(point, nearest->cell());
  vertex->info() = impl_->samples++;
  impl_->last = vertex->cell();
  return true;
}

Cells Delaunay::cells(Progress &progress) {
  Triangulation &triangulation = impl_->triangulation;
  Cells out;
  out.samples = impl_->samples;
  out.corner = impl_->corner;
  // Numbered by their least vertex, so that cells near each other in space are so in memory too.
  std::vector<int32_t> first(std::size_t(out.samples) + 10, 0);
  for (auto c = triangulation.all_cells_begin(); c != triangulation.all_cells_end(); ++c) {
    ++first[group_of(triangulation, c, out.samples) + 1];
    progress.tick(0, 1);
  }
  for (std::size_t g = 0; g + 1 < first.size(); ++g) first[g + 1] += first[g];
  const int32_t count = first[out.samples + 8];
  progress.tick_slow(0, 1);
  for (auto c = triangulation.all_cells_begin(); c != triangulation.all_cells_end(); ++c) {
    const int32_t g = group_of(triangulation, c, out.samples);
    c->info() = g == out.samples + 8 ? -1 : first[g]++;
    progress.tick(0, 1);
  }
  progress.tick_slow(0, 1);
  out.vertex.resize(count);
  out.neighbor.resize(count);
  for (auto c = triangulation.finite_cells_begin(); c != triangulation.finite_cells_end(); ++c) {
    const int32_t id = c->info();
    for (int i = 0; i < 4; ++i) {
      const int32_t v = c->vertex(i)->info();
      out.vertex[id][i] = v >= 0 ? v : out.samples + (-1 - v);
      out.neighbor[id][i] = c->neighbor(i)->info();
    }
    progress.tick(id, count);
  }
  return out;
}

} // namespace vbm::impl
