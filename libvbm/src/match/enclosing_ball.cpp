// SPDX-License-Identifier: GPL-3.0-or-later
// Fischer, Gärtner, "The smallest enclosing ball of balls: combinatorial structure and algorithms"
// (2004), by CGAL's solver, which is handed the basis and the farthest ball outside until there is
// none.
#include "match/enclosing_ball.h"

#include "core/progress.h"

#include <CGAL/Min_sphere_of_spheres_d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vbm::impl {
namespace {

/// Ratio. CGAL's solver takes a ball as enclosed that sticks out by less than this share of the
/// radius; so does add(). The radius is then widened by what sticks out.
constexpr double kStickingOut = 1e-12;

/// Rounds after which a solver that runs in circles for rounding is left: far more than any need.
constexpr int kMaxRounds = 64;

/// Members whose search takes so long that the clock is looked at each time; and so many that it is
/// looked at between.
constexpr std::size_t kMany = 10000;
constexpr std::ptrdiff_t kPiece = 1 << 16;

struct Traits {
  struct Sphere {
    double center[3], radius;
    int32_t ball;
  };
  using FT = double;
  using Cartesian_const_iterator = const double *;
  using Use_square_roots = CGAL::Tag_true;
  using Algorithm = CGAL::Farthest_first_heuristic;
  static const int D = 3;

  const double *center_cartesian_begin(const Sphere &s) const { return s.center; }
  double radius(const Sphere &s) const { return s.radius; }
};

double reach(const Ball &ball, const Vec3 &center) {
  return distance(ball.center, center) + ball.radius;
}

} // namespace

struct EnclosingBall::Solver {
  CGAL::Min_sphere_of_spheres_d<Traits> miniball;
};

EnclosingBall::EnclosingBall(const std::vector<Ball> &balls, Progress &progress)
    : balls_(balls), progress_(progress), solver_(std::make_unique<Solver>()) {}
EnclosingBall::~EnclosingBall() = default;

void EnclosingBall::start(int32_t ball) {
  ball_ = balls_[ball];
  members_.assign(1, ball);
  basis_.assign(1, ball);
}

/// An upper bound of how far from the centre a ball may reach that can still be added. The centre is a
/// mean of the basis's centres, so that a step x away from it leads away from at least one of them:
/// the radius becomes at least sqrt((R - r)^2 + x^2) + r, r being the basis's smallest radius.
double EnclosingBall::farthest(double limit) const {
  double r = ball_.radius;
  for (int32_t b : basis_) r = std::min(r, balls_[b].radius);
  const double most = limit - r, now = ball_.radius - r;
  return limit + std::sqrt(std::max(0.0, (most - now) * (most + now)));
}

/// The ball that reaches farthest from a centre, if that is farther than `reach`, which receives how
/// far; else null.
const int32_t *EnclosingBall::outmost(const int32_t *first, const int32_t *last,
                                      const Vec3 &center, double &reach) const {
  const int32_t *found = nullptr;
  while (first != last) {
    const int32_t *stop = first + std::min(last - first, kPiece);
    for (; first != stop; ++first) {
      const double r = impl::reach(balls_[*first], center);
      if (r > reach) reach = r, found = first;
    }
    if (first != last) progress_.tick_slow(0, 1);
  }
  return found;
}

bool EnclosingBall::add(const int32_t *first, const int32_t *last, double limit) {
  double most = ball_.radius;
  if (const int32_t *outside = outmost(first, last, ball_.center, most))
    if (most > farthest(limit) || !enclose(*outside, first, last, limit)) return false;
  members_.insert(members_.end(), first, last);
  return true;
}

/// Let the ball grow so that it encloses these balls as well, of which one is known to be outside.
bool EnclosingBall::enclose(int32_t outside, const int32_t *first, const int32_t *last,
                            double limit) {
  auto &miniball = solver_->miniball;
  // Relative to the first one, so that digits are those of the balls, not of where they lie.
  const Vec3 origin = balls_[members_.front()].center;
  trial_ = basis_;
  for (int round = 0;; ++round) {
    progress_.tick(0, 1);
    if (members_.size() > kMany) progress_.tick_slow(0, 1);
    trial_.push_back(outside);
    miniball.clear();
    for (int32_t i : trial_) {
      const Vec3 d = balls_[i].center - origin;
      miniball.insert(Traits::Sphere{{d.x, d.y, d.z}, balls_[i].radius, i});
    }
    const double *c = miniball.center_cartesian_begin();
    Ball result;
    result.center = origin + Vec3{c[0], c[1], c[2]};
    result.radius = miniball.radius();
    if (!(result.radius <= limit)) return false;
    trial_.clear();
    for (auto s = miniball.support_begin(); s != miniball.support_end(); ++s)
      trial_.push_back((*s).ball);

    double most = result.radius;
    const int32_t *here = outmost(members_.data(), members_.data() + members_.size(),
                                  result.center, most);
    if (const int32_t *there = outmost(first, last, result.center, most)) here = there;
    if (!here || most <= result.radius * (1 + kStickingOut) || round == kMaxRounds) {
      result.radius = most;
      if (!(result.radius <= limit)) return false;
      basis_ = trial_;
      ball_ = result;
      return true;
    }
    outside = *here;
  }
}

} // namespace vbm::impl
