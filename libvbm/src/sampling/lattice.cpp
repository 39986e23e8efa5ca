// SPDX-License-Identifier: GPL-3.0-or-later
// A triangular lattice, as the covering of the plane with the fewest points (Kershner, "The number
// of circles covering a set", 1939), clipped to the patches. A lattice point belongs to the one
// triangle of its patch whose half-open rows contain it, so that shared edges neither lose nor
// double points.
#include "sampling/lattice.h"

#include "core/progress.h"
#include "sampling/point_table.h"
#include "sampling/tolerances.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

constexpr double kRow = 0.86602540378443865; // sqrt(3) / 2

/// A number in [-1, 1) that depends on the arguments only.
double scatter(int64_t row, int64_t column, uint64_t salt) {
  const uint64_t h = mix_bits(static_cast<uint64_t>(row) +
                              mix_bits(static_cast<uint64_t>(column) + mix_bits(salt)));
  return static_cast<double>(h >> 11) * 0x1p-52 - 1;
}

} // namespace

Lattice::Lattice(const TriangleMesh &mesh, const std::vector<Vec3> &position,
                 const std::vector<Vec3> &face_normal, const std::vector<double> &edge_length,
                 const std::vector<double> &parts, const SpacingField &field, double top,
                 Progress &progress)
    : mesh_(mesh), position_(position), face_normal_(face_normal), field_(field), top_(top),
      length_(edge_length), parts_(parts) {
  for (double s = top; s > field.least() * kLevelSlack; s /= 2) ++levels_;
  joined_.assign(mesh.edge.size(), 0);
  patch_of_.assign(mesh.triangle.size(), -1);
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    if ((t & 255) == 0) progress.tick(0, 1);
    const int32_t *e = &mesh.edge_of_side[3 * t];
    if (patch_of_[t] < 0 && (is_long(e[0]) || is_long(e[1]) || is_long(e[2])))
      grow(static_cast<int32_t>(t), progress);
  }
  double area = 0;
  for (const Member &m : members_) {
    const Triangle &v = mesh.triangle[m.triangle];
    area += length(cross(position[v[1]] - position[v[0]], position[v[2]] - position[v[0]])) / 2;
  }
  const double c = kLattice * top;
  estimate_ = area / c / c / kRow;
}

/// The plane of a triangle with its first axis along its longest edge that is sharp, for there a
/// row along the edge looks best, or else its longest edge.
Lattice::Patch Lattice::plane_of(int32_t triangle) const {
  const Vec3 normal = face_normal_[triangle];
  int32_t best = 0;
  double best_length = -1;
  for (int32_t c = 0; c < 3; ++c) {
    const int32_t e = mesh_.edge_of_side[3 * triangle + c];
    const double l = is_flat(e) ? length_[e] * 1e-3 : length_[e];
    if (l > best_length) best_length = l, best = c;
  }
  const Triangle &v = mesh_.triangle[triangle];
  const Vec3 a = position_[v[best]], u = unit(position_[v[(best + 1) % 3]] - a);
  return {a, u, cross(normal, u), normal};
}

/// Whether the two faces at an edge go on in one plane, rather than fold back over each other.
bool Lattice::is_flat(int32_t edge) const {
  const Edge &e = mesh_.edge[edge];
  if (e.faces() != 2) return false;
  const int32_t s = mesh_.side[e.begin], t = mesh_.side[e.begin + 1];
  const double agree = mesh_.direction(s) != mesh_.direction(t) ? 1 : -1;
  return agree * dot(face_normal_[s / 3], face_normal_[t / 3]) > kSamePlane;
}

void Lattice::grow(int32_t seed, Progress &progress) {
  if (face_normal_[seed] == Vec3{}) return; // no area: its edges do
  const int32_t patch = static_cast<int32_t>(patches_.size());
  patches_.push_back(plane_of(seed));
  const Vec3 normal = patches_.back().normal;
  patch_of_[seed] = patch;
  std::size_t next = members_.size();
  members_.push_back({seed, patch});
  for (; next < members_.size(); ++next) {
    if ((next & 255) == 0) progress.tick(0, 1);
    const int32_t t = members_[next].triangle;
    for (int32_t s = 3 * t; s < 3 * t + 3; ++s) {
      const int32_t e = mesh_.edge_of_side[s];
      if (!is_long(e) || !is_flat(e)) continue;
      const int32_t n = mesh_.other(mesh_.edge[e], t);
      if (patch_of_[n] < 0 && std::fabs(dot(face_normal_[n], normal)) > kSamePlane) {
        patch_of_[n] = patch;
        members_.push_back({n, patch});
      }
      if (patch_of_[n] == patch) joined_[e] = 1;
    }
  }
}

std::array<Lattice::Corner, 3> Lattice::flatten(const Member &member) const {
  const Patch &patch = patches_[member.patch];
  std::array<Corner, 3> corner;
  for (int c = 0; c < 3; ++c) {
    const int32_t v = mesh_.triangle[member.triangle][c];
    const Vec3 p = position_[v] - patch.origin;
    corner[c] = {v, dot(p, patch.u), dot(p, patch.v)};
  }
  return corner;
}

bool Lattice::in_margin(int32_t triangle, const std::array<Corner, 3> &corner, double u, double v,
                        double spacing) const {
  const double margin = kLatticeMargin * spacing, margin2 = margin * margin;
  for (int c = 0; c < 3; ++c) {
    const Corner &p = corner[c], &q = corner[(c + 1) % 3];
    const double pu = u - p.u, pv = v - p.v, eu = q.u - p.u, ev = q.v - p.v;
    if (pu * pu + pv * pv < margin2) return true;
    if (joined_[mesh_.edge_of_side[3 * triangle + c]]) continue;
    const double area = eu * pv - ev * pu;
    if (area * area < margin2 * (eu * eu + ev * ev)) return true;
  }
  return false;
}

/// The point of the triangle over (u, v) of its patch, moved a little if it stays in the triangle.
Vec3 Lattice::place(const Member &member, const std::array<Corner, 3> &corner, int64_t row,
                    int64_t column, double u, double v, double spacing) const {
  const Corner &p = corner[0];
  const double au = corner[1].u - p.u, av = corner[1].v - p.v, bu = corner[2].u - p.u,
               bv = corner[2].v - p.v, area = au * bv - av * bu;
  const uint64_t salt = 2 * static_cast<uint64_t>(member.patch);
  // Half of a square's side so that no move is longer than the jitter allows.
  const double reach = kLatticeJitter * spacing * 0.7071;
  double du = u - p.u + reach * scatter(row, column, salt);
  double dv = v - p.v + reach * scatter(row, column, salt + 1);
  double s = (du * bv - dv * bu) / area, t = (au * dv - av * du) / area;
  if (!(s >= 0 && t >= 0 && s + t <= 1)) {
    du = u - p.u, dv = v - p.v;
    s = std::clamp((du * bv - dv * bu) / area, 0.0, 1.0);
    t = std::clamp((au * dv - av * du) / area, 0.0, 1.0 - s);
  }
  const Triangle &name = mesh_.triangle[member.triangle];
  const Vec3 a = position_[name[0]];
  // In this form coordinates that all corners share stay exactly what they are.
  return a + (position_[name[1]] - a) * s + (position_[name[2]] - a) * t;
}

double Lattice::samples_on_edges() const {
  double sum = 0;
  for (std::size_t e = 0; e < parts_.size(); ++e)
    if (!within_patch(e)) sum += parts_[e] - 1;
  return sum;
}

double Lattice::level_spacing(double top, double spacing) {
  while (top > spacing * kLevelSlack) top /= 2;
  return top;
}

double Lattice::spacing_at(const Vec3 &p) const {
  return levels_ == 1 ? top_ : level_spacing(top_, field_.at(p));
}

/// Whether there can be a point on the triangle that levels before this one are too coarse for.
bool Lattice::may_have(const Member &member, int level) const {
  if (level == 0) return true;
  const Triangle &v = mesh_.triangle[member.triangle];
  const Vec3 a = position_[v[0]], b = position_[v[1]], c = position_[v[2]];
  const Vec3 middle = (a + b + c) * (1.0 / 3);
  const double reach = std::max({distance(middle, a), distance(middle, b), distance(middle, c)});
  return field_.at(middle) - kSpacingGrowth * reach < std::ldexp(top_, 1 - level);
}

void Lattice::visit(const Visit &visit) const {
  for (const Member &member : members_)
    for (int level = 0; level < levels_; ++level)
      if (may_have(member, level)) visit_points(member, level, visit);
}

/// The points of one level that are not of a coarser one, where the spacing asks for the level.
void Lattice::visit_points(const Member &member, int level, const Visit &visit) const {
  const std::array<Corner, 3> corner = flatten(member);
  const Patch &patch = patches_[member.patch];
  const double spacing = std::ldexp(top_, -level);
  const double step = kLattice * spacing, row_step = step * kRow;
  const auto [low, high] = std::minmax({corner[0].v, corner[1].v, corner[2].v});
  for (int64_t row = std::llround(std::ceil(low / row_step)); row * row_step < high; ++row) {
    const double v = row * row_step, shift = row & 1 ? 0.5 : 0;
    double begin = HUGE_VAL, end = -HUGE_VAL;
    for (int c = 0; c < 3; ++c) {
      const Corner *p = &corner[c], *q = &corner[(c + 1) % 3];
      if (p->name > q->name) std::swap(p, q); // the same numbers from both sides of an edge
      if (!(std::min(p->v, q->v) <= v && v < std::max(p->v, q->v))) continue;
      const double u = p->u + (v - p->v) / (q->v - p->v) * (q->u - p->u);
      begin = std::min(begin, u);
      end = std::max(end, u);
    }
    if (!(begin < end)) continue;
    for (int64_t column = std::llround(std::ceil(begin / step - shift));
         (column + shift) * step < end; ++column) {
      const double u = (column + shift) * step;
      double here = spacing;
      if (levels_ > 1) {
        const double wanted = field_.at(patch.origin + patch.u * u + patch.v * v);
        here = level_spacing(top_, wanted);
        if (here > spacing) { // on to where it may be less
          const double rest = (wanted * kLevelSlack - 2 * spacing) / kSpacingGrowth;
          column += std::max<int64_t>(0, int64_t(rest / step) - 1);
          continue;
        }
        const bool coarser = (row & 1) == 0 && ((column - row / 2) & 1) == 0;
        if (level > 0 && coarser) continue;
      }
      if (!in_margin(member.triangle, corner, u, v, here))
        visit(member.triangle, place(member, corner, row, column, u, v, here), here);
    }
  }
}

} // namespace vbm::impl
