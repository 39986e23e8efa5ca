// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 4.4.1, after Ranjan and Fournier, "Matching and interpolation of shapes using unions of
// circles" (1996). "As many other unprocessed balls as possible" is a search for the place that most
// balls' ranges of allowed centres have in common, which costs the cube of their number to do
// exactly; here the best of several starts is taken, each of which grows by one ball after another
// until no other fits.
#include "match/grouping.h"

#include "core/progress.h"
#include "match/ball_tree.h"
#include "match/enclosing_ball.h"
#include "match/sort_in_pieces.h"
#include "match/union_gap.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace vbm::impl {
namespace {

/// Steps of the mean shift towards where balls lie densest; later ones hardly move it.
constexpr int kShifts = 3;

/// By the union: the enclosing ball's radius is tried this much larger at a time, and halved between
/// success and failure so often.
constexpr double kWider = 1.2;
constexpr int kHalvings = 3;

/// Candidates that take so long to look at that the clock is looked at each time.
constexpr std::size_t kMany = 10000;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// Directions in which a place off the largest ball's centre is tried: to the faces and the corners of
/// a cube.
constexpr double kCorner = 0.57735;
constexpr Vec3 kDirections[] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                {0, -1, 0}, {0, 0, 1},  {0, 0, -1},
                                {kCorner, kCorner, kCorner},    {-kCorner, kCorner, kCorner},
                                {kCorner, -kCorner, kCorner},   {-kCorner, -kCorner, kCorner},
                                {kCorner, kCorner, -kCorner},   {-kCorner, kCorner, -kCorner},
                                {kCorner, -kCorner, -kCorner},  {-kCorner, -kCorner, -kCorner}};

class Grouper {
public:
  Grouper(const std::vector<Ball> &balls, const Allowance &allowance, Progress &progress)
      : balls_(balls), allowance_(allowance), progress_(progress), tree_(balls, progress),
        growing_(balls, progress) {
    if (allowance.by_union) gap_ = std::make_unique<UnionGap>(balls, progress);
  }

  Grouping run(std::size_t most);

private:
  void gather(int32_t largest);
  Vec3 densest(Vec3 start) const;
  void sort_members();
  std::size_t depth(const Vec3 &center) const;
  Vec3 deepest() const;
  void grow(const Vec3 &start);
  void take_in_order(double limit);
  void fill();
  bool gather_more(double limit);
  bool widen_to(double limit);
  void widen();

  const std::vector<Ball> &balls_;
  const Allowance allowance_;
  Progress &progress_;
  BallTree tree_;
  EnclosingBall growing_;
  std::unique_ptr<UnionGap> gap_;

  std::size_t done_ = 0; // balls in groups
  // The group being made.
  int32_t largest_ = 0;
  double limit_ = 0;
  std::vector<int32_t> candidates_;               // that may be in it, without the largest
  std::vector<std::pair<double, int32_t>> order_; // how far each reaches from a place
  std::vector<int32_t> bulk_, rest_;
  Ball best_;
  std::vector<int32_t> best_members_;
};

/// Unprocessed balls that a ball within the limit can enclose together with the largest one.
void Grouper::gather(int32_t largest) {
  largest_ = largest;
  const Ball &a = balls_[largest];
  limit_ = allowance_.limit(a.radius);
  candidates_.clear();
  tree_.inside(a.center, 2 * limit_ - a.radius, candidates_);
  candidates_.erase(std::remove(candidates_.begin(), candidates_.end(), largest),
                    candidates_.end());
  sort_in_pieces(candidates_, std::less<int32_t>(), progress_);
}

/// The largest first, then the rest ascending.
void Grouper::sort_members() {
  const int32_t none = -1; // before all others
  best_members_.front() = none;
  sort_in_pieces(best_members_, std::less<int32_t>(), progress_);
  best_members_.front() = largest_;
}

std::size_t Grouper::depth(const Vec3 &center) const {
  std::size_t count = 0;
  if (candidates_.size() > kMany) progress_.tick_slow(done_, balls_.size());
  for (int32_t i : candidates_)
    count += distance(balls_[i].center, center) + balls_[i].radius <= limit_;
  return count;
}

/// The mean of the centres of all balls that a ball of the largest radius there would enclose,
/// again and again, never so far that it would not enclose the largest one.
Vec3 Grouper::densest(Vec3 c) const {
  const Ball &a = balls_[largest_];
  const double range = limit_ - a.radius;
  for (int shift = 0; shift < kShifts; ++shift) {
    Vec3 sum;
    double count = 1;
    if (candidates_.size() > kMany) progress_.tick_slow(done_, balls_.size());
    for (int32_t i : candidates_)
      if (distance(balls_[i].center, c) + balls_[i].radius <= limit_) {
        sum += balls_[i].center - a.center;
        ++count;
      }
    Vec3 d = sum * (1 / count);
    const double far = length(d);
    if (far > range) d = d * (range / far);
    c = a.center + d;
  }
  return c;
}

/// The balls that fit together with the largest one and lie nearest to a place.
void Grouper::grow(const Vec3 &start) {
  bulk_.clear();
  order_.clear();
  for (int32_t i : candidates_) {
    progress_.tick(done_, balls_.size());
    const double reach = distance(balls_[i].center, start) + balls_[i].radius;
    if (reach <= limit_)
      bulk_.push_back(i); // one ball about the place encloses all of these
    else
      order_.push_back({reach, i});
  }
  growing_.start(largest_);
  if (!growing_.add(bulk_.data(), bulk_.data() + bulk_.size(), limit_)) // by a rounding error
    for (int32_t i : bulk_) order_.push_back({limit_, i});
  take_in_order(limit_);
  const auto &members = growing_.members();
  if (members.size() > best_members_.size() ||
      (members.size() == best_members_.size() && growing_.ball().radius < best_.radius)) {
    best_ = growing_.ball();
    best_members_ = members;
  }
}

/// Add what fits, in order of reach: twice as many at once after each success, so that a ball that
/// grows little by little does not look at its members each time.
void Grouper::take_in_order(double limit) {
  sort_in_pieces(order_, std::less<std::pair<double, int32_t>>(), progress_);
  rest_.clear();
  for (const auto &[reach, i] : order_) rest_.push_back(i);
  std::size_t run = 1;
  for (std::size_t next = 0; next < rest_.size();) {
    progress_.tick(done_, balls_.size());
    run = std::min(run, rest_.size() - next);
    if (growing_.add(rest_.data() + next, rest_.data() + next + run, limit)) {
      next += run;
      run *= 2;
    } else if (run > 1) {
      run = 1;
    } else {
      ++next; // it will not fit later either: the ball only grows
    }
  }
}

/// Of places as far from the largest ball's centre as allowed, one where a ball encloses most.
Vec3 Grouper::deepest() const {
  const Ball &a = balls_[largest_];
  Vec3 best = a.center;
  std::size_t most = 0;
  for (const Vec3 &direction : kDirections) {
    const Vec3 place = a.center + direction * (limit_ - a.radius);
    const std::size_t d = depth(place);
    if (d > most) most = d, best = place;
  }
  return best;
}

/// The best group about the largest ball. Against all groups there are, tried out on random sets,
/// it has the most members in 9 of 10 cases for 20 candidates, and 96 % of the most for 60.
void Grouper::fill() {
  const Vec3 c = balls_[largest_].center;
  Vec3 mean;
  for (int32_t i : candidates_) mean += balls_[i].center - c;
  const Vec3 off = deepest();
  grow(c);
  grow(densest(c));
  grow(densest(c + mean * (1.0 / double(candidates_.size()))));
  grow(off);
  grow(densest(off));
}

/// Whether any ball left could be added within this limit; how far each reaches is in order_.
bool Grouper::gather_more(double limit) {
  candidates_.clear();
  tree_.inside(balls_[largest_].center, 2 * limit - balls_[largest_].radius, candidates_);
  sort_members();
  order_.clear();
  for (int32_t i : candidates_)
    if (i != largest_ && !std::binary_search(best_members_.begin() + 1, best_members_.end(), i))
      order_.push_back({distance(balls_[i].center, best_.center) + balls_[i].radius, i});
  return !order_.empty();
}

/// Take more balls, up to an enclosing ball of this radius, if the union allows it.
bool Grouper::widen_to(double limit) {
  if (!gather_more(limit)) return true;
  growing_.start(largest_);
  growing_.add(best_members_.data() + 1, best_members_.data() + best_members_.size(), kNoLimit);
  take_in_order(limit);
  const Ball &ball = growing_.ball();
  if (!gap_->at_most(ball, allowance_.gap(ball.radius))) return false;
  best_ = ball;
  best_members_ = growing_.members();
  return true;
}

/// Enclosing balls that are farther from their largest ball than the allowance, but not from the
/// union: as far as steps go, then as far between the last two as halving shows.
void Grouper::widen() {
  double good = limit_;
  while (gather_more(good * kWider) && widen_to(good * kWider)) good *= kWider;
  double bad = good * kWider;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double middle = (good + bad) / 2;
    (widen_to(middle) ? good : bad) = middle;
  }
}

Grouping Grouper::run(std::size_t most) {
  std::vector<int32_t> by_size(balls_.size());
  for (std::size_t i = 0; i < by_size.size(); ++i) by_size[i] = int32_t(i);
  const auto larger = [&](int32_t a, int32_t b) {
    return balls_[a].radius != balls_[b].radius ? balls_[a].radius > balls_[b].radius : a < b;
  };
  sort_in_pieces(by_size, larger, progress_);
  Grouping grouping;
  std::vector<uint8_t> processed(balls_.size(), 0);
  for (int32_t a : by_size) {
    if (processed[a]) continue;
    if (most && grouping.enclosing.size() == most) break;
    progress_.tick(done_, balls_.size());
    gather(a);
    best_ = balls_[a];
    best_members_.assign(1, a);
    if (!candidates_.empty()) fill();
    if (gap_) widen();
    sort_members();
    for (int32_t i : best_members_) {
      progress_.tick(done_, balls_.size());
      processed[i] = 1;
      tree_.remove(i);
      grouping.members.index.push_back(i);
    }
    grouping.members.offset.push_back(grouping.members.index.size());
    grouping.enclosing.push_back(best_);
    done_ += best_members_.size();
  }
  return grouping;
}

} // namespace

double Allowance::limit(double largest) const {
  if (slack > 0) return largest + slack;
  double limit = largest / sphericity;
  while (limit > largest && largest / limit < sphericity) limit = std::nextafter(limit, 0.0);
  return limit;
}

double Allowance::gap(double radius) const {
  return slack > 0 ? 2 * slack : 2 * radius * (1 - sphericity);
}

Grouping group_balls(const std::vector<Ball> &balls, const Allowance &allowance, std::size_t most,
                     Progress &progress) {
  return Grouper(balls, allowance, progress).run(most);
}

} // namespace vbm::impl
