// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/spacing.h"

#include "core/error.h"
#include "core/progress.h"
#include "sampling/checks.h"
#include "sampling/lattice.h"
#include "sampling/tolerances.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

/// No edge is cut into more parts for the sake of thin walls: along edges the spacing is followed
/// step by step.
constexpr double kMostParts = 20'000;

/// The spacing on walls is raised by this until the samples are few enough, but to no more than so
/// many times what they ask for: then the walls are not told apart at all.
constexpr double kFloorStep = 1.1, kMostFloor = 20;

struct Weighted {
  double value, weight;
};

/// The value that half the weight is below.
double median(std::vector<Weighted> &values) {
  double all = 0, below = 0;
  for (const Weighted &v : values) all += v.weight;
  // Quickselect by weight.
  std::size_t begin = 0, end = values.size();
  while (end - begin > 1) {
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(values.begin() + begin, values.begin() + middle, values.begin() + end,
                     [](const Weighted &p, const Weighted &q) { return p.value < q.value; });
    double left = 0;
    for (std::size_t i = begin; i < middle; ++i) left += values[i].weight;
    if (below + left > all / 2)
      end = middle;
    else
      below += left, begin = middle;
  }
  return values.empty() ? 0 : values[begin].value;
}

/// The longest side of the typical triangle: half the area is in triangles with longer ones. With
/// `widths`, what it measures across that side.
double typical(const TriangleMesh &mesh, const std::vector<Vec3> &position, bool widths,
               Progress &progress) {
  std::vector<Weighted> sides;
  sides.reserve(mesh.triangle.size());
  for (const Triangle &t : mesh.triangle) {
    const Vec3 a = position[t[0]], b = position[t[1]], c = position[t[2]];
    const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
    const double area = length(cross(b - a, c - a));
    if (!widths)
      sides.push_back({longest, area});
    else if (longest > 0)
      sides.push_back({area / std::sqrt(longest), area});
  }
  progress.tick_slow(0, 1);
  const double found = median(sides);
  return widths ? found : std::sqrt(found);
}

double diagonal_of(const std::vector<Vec3> &position) {
  if (position.empty()) return 0;
  Vec3 low = position[0], high = position[0];
  for (const Vec3 &p : position)
    for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
  return distance(low, high);
}

/// Whether the mesh's edges bend gently nearly everywhere: it then stands for a curved shape, whose
/// vertices lie on it and whose faces do not.
bool is_smooth(const TriangleMesh &mesh, const std::vector<Vec3> &face_normal,
               const std::vector<double> &edge_length) {
  double bent = 0, gentle = 0;
  for (std::size_t i = 0; i < mesh.edge.size(); ++i) {
    const Edge &e = mesh.edge[i];
    if (e.faces() != 2) continue;
    const double cosine =
        dot(face_normal[mesh.side[e.begin] / 3], face_normal[mesh.side[e.begin + 1] / 3]);
    if (cosine > kSamePlane) continue;
    bent += edge_length[i];
    if (cosine > kGentle) gentle += edge_length[i];
  }
  return gentle > kSmoothShare * bent;
}

/// Call visit(x, count) on the way along an edge, with the samples that are due up to there.
template <class Visit>
void walk(const Vec3 &a, const Vec3 &b, const SpacingField &field, Visit visit) {
  const double length = distance(a, b);
  double count = 0;
  for (double x = 0; x < length;) {
    double spacing = field.at(a + (b - a) * (x / length));
    const double step = std::min(length - x, spacing / 2);
    spacing = field.at(a + (b - a) * ((x + step / 2) / length));
    count += step / spacing;
    x = step < length - x ? x + step : length;
    visit(x / length, count);
  }
}

} // namespace

std::vector<double> edge_parts(const TriangleMesh &mesh, const std::vector<Vec3> &position,
                               const std::vector<double> &edge_length, const SpacingField &field,
                               Progress &progress) {
  std::vector<double> parts(edge_length.size(), 1);
  for (std::size_t e = 0; e < parts.size(); ++e) {
    const double length = edge_length[e];
    if (!(length > field.least())) continue;
    if (field.constant()) {
      parts[e] = std::ceil(length / field.most());
      continue;
    }
    progress.tick(0, 1);
    const Vec3 a = position[mesh.edge[e].a], b = position[mesh.edge[e].b];
    if (field.at((a + b) * 0.5) - kSpacingGrowth * length / 2 >= length) continue;
    double count = 0;
    walk(a, b, field, [&](double, double due) { count = due; });
    parts[e] = std::max(1.0, std::ceil(count * (1 - 1e-12)));
  }
  return parts;
}

void cut_edge(const Vec3 &a, const Vec3 &b, double parts, const SpacingField &field,
              const std::function<void(double share)> &visit) {
  const int64_t count = std::llround(parts);
  if (field.constant()) {
    for (int64_t k = 1; k < count; ++k) visit(double(k) / double(count));
    return;
  }
  double all = 0;
  walk(a, b, field, [&](double, double due) { all = due; });
  int64_t k = 1;
  double x = 0, at = 0;
  walk(a, b, field, [&](double next_x, double next) {
    for (; k < count && all * double(k) / double(count) <= next; ++k) {
      const double due = all * double(k) / double(count);
      visit(x + (next_x - x) * (next > at ? (due - at) / (next - at) : 1));
    }
    x = next_x, at = next;
  });
}

SpacingChoice::SpacingChoice(const SpacingInput &input, const vbm_build_options &options,
                             Samples &samples, Progress &progress) {
  const double vertices = static_cast<double>(samples.position.size());
  const double most = std::min(std::max(kMostAdded, kMostAddedPerVertex * vertices),
                               static_cast<double>(sample_limit(options)) - vertices);
  const double across = diagonal_of(samples.position) / kSpacingsAcross;
  double wanted = kTypicalSides * typical(input.mesh, samples.position, false, progress);
  const bool dense = wanted <= kEvenlyDense * across;
  if (is_smooth(input.mesh, input.face_normal, input.edge_length)) {
    const double strips = kTypicalWidths * typical(input.mesh, samples.position, true, progress);
    if (strips * kMostAcross >= across * kSpacingsAcross) wanted = std::min(wanted, strips);
  } else {
    wanted = std::min(wanted, across);
  }
  if (!(wanted > 0)) return;
  wanted_ = base_ = wanted;
  for (;;) {
    const SpacingField field(base_);
    const std::vector<double> parts =
        edge_parts(input.mesh, samples.position, input.edge_length, field, progress);
    const Lattice lattice(input.mesh, samples.position, input.face_normal, input.edge_length, parts,
                          field, base_, progress);
    count_ = lattice.samples_on_edges() + lattice.estimate();
    if (count_ <= most) break;
    base_ *= std::max(kSpacingStep, std::sqrt(count_ / most)); // counts go with at most h^-2
  }
  build();
  if (!dense && !samples.normal.empty()) look_for_walls(input, options, samples, progress);
}

void SpacingChoice::look_for_walls(const SpacingInput &input, const vbm_build_options &options,
                                   const Samples &samples, Progress &progress) {
  walls_ = find_thin_walls(input.mesh, samples.position, input.face_normal, input.tree,
                           input.buried, base_, progress);
  if (walls_.site.empty()) return;
  least_ = HUGE_VAL;
  for (const SpacingSite &s : walls_.site) least_ = std::min(least_, s.spacing);
  for (const SpacingSite &s : walls_.edge_site) least_ = std::min(least_, s.spacing);
  if (least_ >= base_) return;
  const double share = std::min(1.0, kThinShare * walls_.thin_area / walls_.area);
  most_ = std::min(count_ + std::max(kLeastThin, share * kMostThin),
                   double(sample_limit(options)) - double(samples.position.size()));
  double longest = 0;
  for (double length : input.edge_length) longest = std::max(longest, length);
  const double even = estimate(SpacingField(base_), base_); // also where the mesh is dense already
  floor_ = least_;
  if (longest <= kMostParts * least_)
    for (build(); floor_ <= kMostFloor * least_; progress.tick_slow(0, 1)) {
      if (count_ + estimate(spacing_.field, spacing_.top) - even <= most_) return;
      coarsen();
    }
  // Walls so thin are as good as none: what cannot be resolved is not worth samples.
  floor_ = base_;
  build();
}

/// The spacing for this floor, on the lattices that need the fewest samples.
void SpacingChoice::build() {
  spacing_ = {SpacingField(base_), base_};
  if (!(floor_ > 0 && floor_ < base_)) return;
  std::vector<SpacingSite> sites = walls_.site;
  sites.insert(sites.end(), walls_.edge_site.begin(), walls_.edge_site.end());
  for (SpacingSite &s : sites) s.spacing = std::max(s.spacing, floor_);
  spacing_.field = SpacingField(base_, std::move(sites));
  double best = HUGE_VAL;
  const double fitting = floor_ * std::exp2(std::floor(std::log2(base_ / floor_) + 1e-9));
  for (const double top : {fitting, base_, base_ * 0.84, base_ * 0.71, base_ * 0.59})
    if (const double count = estimate(spacing_.field, top); count < best)
      best = count, spacing_.top = top;
}

double SpacingChoice::estimate(const SpacingField &field, double top) const {
  double sum = 0;
  for (const ThinWalls::Probe &p : walls_.probe) {
    const double step = kLattice * Lattice::level_spacing(top, field.at(p.at));
    sum += p.area / (step * step * 0.866);
  }
  return sum;
}

void SpacingChoice::coarsen() {
  floor_ = floor_ * kFloorStep <= kMostFloor * least_ ? floor_ * kFloorStep : base_;
  build();
}

void SpacingChoice::note(Samples &samples) const {
  const auto text = [&](double length) {
    return short_number(samples.frame.length_to_input(length));
  };
  if (base_ > wanted_ && std::isfinite(base_))
    samples.notes.push_back("the mesh would need very many samples at a spacing of " +
                            text(wanted_) + ", so it was sampled at " + text(base_));
  if (floor_ > least_)
    samples.notes.push_back("the mesh is as thin as " + text(walls_.thinnest) +
                            " and would need very many samples at a spacing of " + text(least_) +
                            " there, so it was sampled at " + text(floor_));
}

} // namespace vbm::impl
