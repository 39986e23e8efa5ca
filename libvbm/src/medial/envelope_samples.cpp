// SPDX-License-Identifier: GPL-3.0-or-later
// A point of the envelope lies on a ball where the outward normal there is n, and has the height
// n . c + r over the plane through the origin across n. Balls, cones and slabs touch that plane
// where all their balls reach the same height, and what lies behind it is covered by a neighbour
// that reaches higher. So balls give the directions in which no neighbour is higher, cones the
// circles of such directions of equal height for two balls, slabs the one or two for three. Spheres
// are cut as octahedra, again and again, but not where a neighbour is higher all over.
#include "medial/envelope_samples.h"

#include "core/progress.h"
#include "medial/cell_lists.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

/// Unit lengths. A point is covered if it is deeper than this in a primitive: more than rounding.
constexpr double kCovered = 1e-9;

/// Steps around a circle or across a triangle, and halvings of an octahedron's edges, at most:
/// enough for all that is within the bounding box. Balls of bad samplings reach far beyond it.
constexpr int kMostSteps = 1 << 9, kMostHalvings = 7;

/// Points and pieces of spheres looked at, after which the spacing is doubled and all is done anew:
/// several times what an axis of 5,000 balls takes.
constexpr std::size_t kMostWork = 1 << 23;

constexpr double kPi = 3.14159265358979323846;

int steps(double length, double spacing) {
  return int(std::clamp(std::ceil(length / spacing), 1.0, double(kMostSteps)));
}

class Sampler {
public:
  Sampler(const BallComplex &complex, const Envelope &envelope, double spacing, Progress &progress)
      : complex_(complex), envelope_(envelope), spacing_(spacing), progress_(progress),
        edges_(all_edges(complex)) {
    neighbors_ = lists_of(complex.ball.size(), edges_);
    triangles_at_ = lists_of(complex.ball.size(), complex.triangle);
  }

  EnvelopeSamples run() {
    while (!try_once()) spacing_ *= 2;
    return std::move(out_);
  }

private:
  /// False if it would take too much work. With one point a primitive it is done in any case.
  bool try_once() {
    out_ = EnvelopeSamples();
    work_ = 0;
    const std::size_t primitives = complex_.ball.size() + edges_.size() + complex_.triangle.size();
    const std::size_t most = kMostWork + 16 * primitives;
    for (std::size_t v = 0; v < complex_.ball.size() && work_ <= most; ++v) sphere(int32_t(v));
    for (std::size_t e = 0; e < edges_.size() && work_ <= most; ++e)
      cone(edges_[e][0], edges_[e][1]);
    for (std::size_t t = 0; t < complex_.triangle.size() && work_ <= most; ++t)
      slab(complex_.triangle[t]);
    return work_ <= most;
  }

  double height(int32_t v, const Vec3 &n) const {
    return dot(n, complex_.ball[v].center) + complex_.ball[v].radius;
  }

  void add(const Vec3 &p, double area) {
    progress_.tick(0, 1);
    ++work_;
    if (envelope_.covers(p, kCovered)) return;
    out_.point.push_back(p);
    out_.area.push_back(area);
  }

  void sphere(int32_t v) {
    const Ball &ball = complex_.ball[v];
    if (!(ball.radius > 0)) return;
    around_.clear();
    for (uint64_t k = neighbors_.offset[v]; k < neighbors_.offset[v + 1]; ++k) {
      const auto &e = edges_[neighbors_.index[k]];
      const Ball &other = complex_.ball[e[0] == v ? e[1] : e[0]];
      const Vec3 to = other.center - ball.center;
      const double far = length(to), rise = other.radius - ball.radius;
      if (far <= rise) return; // inside the neighbour
      if (far > -rise) around_.push_back({to * (1 / far), -rise / far});
    }
    int halvings = 0;
    while (halvings < kMostHalvings && ball.radius * kPi / 2 / (1 << halvings) > spacing_)
      ++halvings;
    const double area = 4 * kPi * ball.radius * ball.radius / double(8 * (1 << 2 * halvings));
    for (int octant = 0; octant < 8; ++octant) {
      const Vec3 x{octant & 1 ? -1. : 1., 0, 0}, y{0, octant & 2 ? -1. : 1., 0},
          z{0, 0, octant & 4 ? -1. : 1.};
      cut(ball, x, y, z, halvings, area);
    }
  }

  /// A triangle of directions.
  void cut(const Ball &ball, const Vec3 &a, const Vec3 &b, const Vec3 &c, int halvings,
           double area) {
    progress_.tick(0, 1);
    ++work_;
    const Vec3 middle = unit(a + b + c);
    const double reach =
        std::min({dot(middle, a), dot(middle, b), dot(middle, c)}); // cosine of its radius
    const double sine = halvings ? std::sqrt(std::max(0.0, 1 - reach * reach)) : 0;
    for (const auto &[to, limit] : around_) {
      // All directions within the radius of the middle are nearer to `to` than acos(limit).
      const double cosine = dot(middle, to);
      const double aside = std::sqrt(std::max(0.0, 1 - cosine * cosine));
      if (halvings == 0 ? cosine > limit : cosine > -reach && cosine * reach - aside * sine > limit)
        return;
    }
    if (halvings == 0) return add(ball.center + middle * ball.radius, area);
    const Vec3 ab = unit(a + b), bc = unit(b + c), ca = unit(c + a);
    cut(ball, a, ab, ca, halvings - 1, area);
    cut(ball, ab, b, bc, halvings - 1, area);
    cut(ball, ca, bc, c, halvings - 1, area);
    cut(ball, ab, bc, ca, halvings - 1, area);
  }

  void cone(int32_t i, int32_t j) {
    const Ball &a = complex_.ball[i], &b = complex_.ball[j];
    const Vec3 axis = b.center - a.center;
    const double far = length(axis), rise = b.radius - a.radius;
    if (!(far > std::fabs(rise))) return;
    const Vec3 u = axis * (1 / far);
    const double lean = -rise / far, across = std::sqrt(1 - lean * lean);
    const Vec3 helper = std::fabs(u.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 e1 = unit(cross(u, helper)), e2 = cross(u, e1);
    const double side = std::sqrt(far * far - rise * rise), large = std::max(a.radius, b.radius);
    const int turns = steps(2 * kPi * large * across, spacing_), along = steps(side, spacing_);
    for (int k = 0; k < turns; ++k) {
      progress_.tick(0, 1);
      const double angle = 2 * kPi * (k + 0.5) / turns;
      const Vec3 n = u * lean + (e1 * std::cos(angle) + e2 * std::sin(angle)) * across;
      if (higher_beside(i, j, n)) continue;
      for (int m = 0; m < along; ++m) {
        const double t = (m + 0.5) / along, r = a.radius + rise * t;
        add(a.center + axis * t + n * r, 2 * kPi * r * across / turns * side / along);
      }
    }
  }

  /// Whether a triangle at the edge covers what has this normal.
  bool higher_beside(int32_t i, int32_t j, const Vec3 &n) const {
    const double level = height(i, n);
    for (uint64_t k = triangles_at_.offset[i]; k < triangles_at_.offset[i + 1]; ++k) {
      const auto &t = complex_.triangle[triangles_at_.index[k]];
      if (t[0] != j && t[1] != j && t[2] != j) continue;
      for (int32_t v : t)
        if (v != i && v != j && height(v, n) > level) return true;
    }
    return false;
  }

  void slab(const std::array<int32_t, 3> &t) {
    const Ball &a = complex_.ball[t[0]], &b = complex_.ball[t[1]], &c = complex_.ball[t[2]];
    const Vec3 u = b.center - a.center, v = c.center - a.center, n = cross(u, v);
    const double n2 = dot(n, n);
    if (!(n2 > 0)) return;
    const Vec3 gradient =
        (cross(v, n) * (b.radius - a.radius) + cross(n, u) * (c.radius - a.radius)) * (1 / n2);
    const double g2 = dot(gradient, gradient);
    if (!(g2 < 1)) return;
    for (int side = -1; side <= 1; side += 2) {
      const Vec3 normal = n * (side * std::sqrt((1 - g2) / n2)) - gradient;
      const Vec3 at[3] = {a.center + normal * a.radius, b.center + normal * b.radius,
                          c.center + normal * c.radius};
      const double longest =
          std::max({distance(at[0], at[1]), distance(at[1], at[2]), distance(at[2], at[0])});
      const int rows = steps(longest, spacing_);
      const double area = length(cross(at[1] - at[0], at[2] - at[0])) / 2 / (double(rows) * rows);
      // The centres of rows * rows equal triangles.
      for (int i = 0; i < rows; ++i)
        for (int j = 0; i + j < rows; ++j)
          for (int flip = 0; flip < 2 && i + j + flip < rows; ++flip) {
            const double s = (i + (1 + flip) / 3.0) / rows, r = (j + (1 + flip) / 3.0) / rows;
            add(at[0] + (at[1] - at[0]) * s + (at[2] - at[0]) * r, area);
          }
    }
  }

  struct Cap {
    Vec3 to;
    double limit; // cosine
  };

  const BallComplex &complex_;
  const Envelope &envelope_;
  double spacing_;
  Progress &progress_;
  std::size_t work_ = 0; // pieces and points looked at
  std::vector<std::array<int32_t, 2>> edges_;
  Incidence neighbors_, triangles_at_;
  std::vector<Cap> around_;
  EnvelopeSamples out_;
};

} // namespace

EnvelopeSamples sample_envelope(const BallComplex &complex, const Envelope &envelope,
                                double spacing, Progress &progress) {
  return Sampler(complex, envelope, spacing, progress).run();
}

} // namespace vbm::impl
