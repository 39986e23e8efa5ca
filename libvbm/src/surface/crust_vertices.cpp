// SPDX-License-Identifier: GPL-3.0-or-later
// Amenta, Choi, Kolluri, "The power crust" (2001). It differs where four balls touch a common
// sample: there their power centre is that sample by definition, not by arithmetic. Other vertices
// are computed in as many digits as they need: the power centre of nearly flat tetrahedra flies off
// in doubles.
#include "surface/crust_vertices.h"

#include "core/double_double.h"
#include "core/hash.h"
#include "core/progress.h"
#include "core/tolerances.h"
#include "surface/power_diagram.h"
#include "surface/power_predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vbm::impl {
namespace {

/// The power centre by Cramer's rule, relative to ball a; false if its error may exceed
/// kCrustVertexError.
template <class Number>
bool power_center(const Site &a, const Site *const other[3], double unit_error, Vec3 &center) {
  Number row[3][3], lift[3];
  double size[3], lift_size[3];
  for (int i = 0; i < 3; ++i) {
    const Site &q = *other[i];
    row[i][0] = Number(q.x) - Number(a.x);
    row[i][1] = Number(q.y) - Number(a.y);
    row[i][2] = Number(q.z) - Number(a.z);
    const double x = double(row[i][0]), y = double(row[i][1]), z = double(row[i][2]);
    lift[i] = row[i][0] * row[i][0] + row[i][1] * row[i][1] + row[i][2] * row[i][2] +
              (Number(a.r) - Number(q.r)) * (Number(a.r) + Number(q.r));
    size[i] = std::fabs(x) + std::fabs(y) + std::fabs(z);
    lift_size[i] = x * x + y * y + z * z + std::fabs(a.r - q.r) * (a.r + q.r);
  }
  Number normal[3][3]; // [i]: row i+1 x row i+2
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const Number *u = row[(i + 1) % 3], *v = row[(i + 2) % 3];
      normal[i][k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    }
  const double det =
      2 * double(row[0][0] * normal[0][0] + row[0][1] * normal[0][1] + row[0][2] * normal[0][2]);
  double x[3], reach = 0;
  for (int k = 0; k < 3; ++k) {
    x[k] = double(lift[0] * normal[0][k] + lift[1] * normal[1][k] + lift[2] * normal[2][k]) / det;
    reach = std::max(reach, std::fabs(x[k]));
  }
  const double numerator = lift_size[0] * size[1] * size[2] + size[0] * lift_size[1] * size[2] +
                           size[0] * size[1] * lift_size[2];
  const double error =
      unit_error * (numerator + 2 * reach * size[0] * size[1] * size[2]) / std::fabs(det);
  if (!(error < kCrustVertexError)) return false;
  center = {a.x + x[0], a.y + x[1], a.z + x[2]};
  return true;
}

class Placement {
public:
  Placement(const CrustComplex &crust, const Model &model, const Selection &selected,
            Progress &progress)
      : crust_(crust), model_(model), selected_(selected), balls_(selected.balls),
        signature_(crust.balls, 0) {
    for (std::size_t b = 0; b < crust.balls; ++b) {
      progress.tick(0, 1);
      const List list = samples_of(int32_t(b));
      for (const int32_t *s = list.begin; s != list.end; ++s) signature_[b] |= bit(*s);
    }
  }

  void place(std::size_t v, CrustVertices &out) {
    const std::array<int32_t, 4> &ball = crust_.vertices[v].ball;
    int32_t near = common_sample(ball);
    float pull = 0;
    out.sample.push_back(near);
    if (near >= 0) {
      out.position.push_back(model_.samples.position[near]);
    } else {
      Vec3 x = center(ball);
      out.clamped += clamp(ball, x);
      out.position.push_back(x);
      nearest_samples(ball, x, near, pull);
    }
    out.near.push_back(near);
    out.pull.push_back(pull);
  }

private:
  struct List {
    const int32_t *begin, *end;
  };

  List samples_of(int32_t ball) const {
    if (std::size_t(ball) >= crust_.balls) return {nullptr, nullptr};
    const auto [begin, end] = selected_.samples_of(model_, ball);
    return {begin, end};
  }

  /// A bit for each sample that a ball touches, by a hash: most balls without a common sample have
  /// no common bit.
  static uint64_t bit(int32_t sample) {
    return uint64_t(1) << (hash_index(uint64_t(sample)) >> 58);
  }

  /// The first sample that all four balls touch, or -1.
  int32_t common_sample(const std::array<int32_t, 4> &ball) const {
    uint64_t bits = ~uint64_t(0);
    for (int32_t b : ball) bits &= std::size_t(b) < crust_.balls ? signature_[b] : 0;
    if (!bits) return -1;
    List list[4];
    for (int i = 0; i < 4; ++i) list[i] = samples_of(ball[i]);
    for (const int32_t *s = list[0].begin; s != list[0].end; ++s) {
      if (!(bit(*s) & bits)) continue;
      bool in = true;
      for (int i = 1; i < 4 && in; ++i)
        in = std::find(list[i].begin, list[i].end, *s) != list[i].end;
      if (in) return *s;
    }
    return -1;
  }

  Site site(int32_t ball) const {
    if (std::size_t(ball) >= crust_.balls) {
      const Vec3 &c = crust_.corner[ball - crust_.balls];
      return {c.x, c.y, c.z, 0};
    }
    const Ball &b = balls_[ball];
    // With the diagram's own radii: where balls are nearly the same ball, the corners that they
    // make with others are where the diagram says, or anywhere.
    return changed_site(b, ball, crust_.is_inner(ball));
  }

  Vec3 center(const std::array<int32_t, 4> &ball) const {
    const Site s[4] = {site(ball[0]), site(ball[1]), site(ball[2]), site(ball[3])};
    const Site *const other[3] = {&s[1], &s[2], &s[3]};
    Vec3 x;
    if (power_center<double>(s[0], other, kSignError, x)) return x;
    if (power_center<DoubleDouble>(s[0], other, kPairError, x)) return x;
    double c[3];
    if (power_center_exact(s[0], s[1], s[2], s[3], c) && is_finite({c[0], c[1], c[2]}))
      return {c[0], c[1], c[2]};
    // Flat before the radii were shrunk: anywhere near does, the next step brings it to its balls.
    for (int32_t b : ball)
      if (crust_.is_inner(b)) return balls_[b].center;
    return s[0].x == s[0].x ? Vec3{s[0].x, s[0].y, s[0].z} : Vec3{};
  }

  /// Bring a vertex that is far from all its inner balls back towards the one that reaches farthest
  /// to it.
  bool clamp(const std::array<int32_t, 4> &ball, Vec3 &x) const {
    double least = std::numeric_limits<double>::infinity();
    const Ball *nearest = nullptr;
    for (int32_t b : ball) {
      if (!crust_.is_inner(b)) continue;
      const double part = distance(balls_[b].center, x) / balls_[b].radius;
      if (part < least) {
        least = part;
        nearest = &balls_[b];
      }
    }
    if (!nearest || least <= kCrustReach) return false;
    x = nearest->center + (x - nearest->center) * (kCrustReach / least);
    return true;
  }

  void nearest_samples(const std::array<int32_t, 4> &ball, const Vec3 &x, int32_t &near,
                       float &pull) const {
    near = -1;
    double first = std::numeric_limits<double>::infinity(), second = first;
    for (int32_t b : ball) {
      const List list = samples_of(b);
      for (const int32_t *s = list.begin; s != list.end; ++s) {
        const Vec3 d = model_.samples.position[*s] - x;
        const double square = dot(d, d);
        if (square >= second || *s == near) continue;
        if (square < first) {
          second = first;
          first = square;
          near = *s;
        } else {
          second = square;
        }
      }
    }
    pull = second > 0 ? float(std::sqrt(first / second)) : 1;
  }

  const CrustComplex &crust_;
  const Model &model_;
  const Selection &selected_;
  const std::vector<Ball> &balls_;
  std::vector<uint64_t> signature_; // of each ball: the bits of its samples
};

} // namespace

CrustVertices crust_vertices(const CrustComplex &crust, const Model &model,
                             const Selection &selected, Progress &progress) {
  CrustVertices vertices;
  const std::size_t count = crust.vertices.size();
  vertices.position.reserve(count);
  vertices.sample.reserve(count);
  vertices.near.reserve(count);
  vertices.pull.reserve(count);
  Placement placement(crust, model, selected, progress);
  for (std::size_t v = 0; v < count; ++v) {
    progress.tick(v, count);
    placement.place(v, vertices);
  }
  return vertices;
}

} // namespace vbm::impl
