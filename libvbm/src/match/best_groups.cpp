// SPDX-License-Identifier: GPL-3.0-or-later
// A greedy cover: the least slack with which the clustering of thesis 4.4.1 makes at most so many
// groups, by halving; then the worst groups are cut in two until there are as many as asked for.
// Seeking the least sphericity instead, as the thesis's own parameter suggests, gives every ball an
// error in proportion to its size, and a largest one 1.1 to 6 times as large with as many balls
// (a torus and a bunny of 8,000 and 35,000 balls to 20, 100 and 500).
#include "match/best_groups.h"

#include "core/progress.h"
#include "match/enclosing_ball.h"
#include "match/union_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <queue>
#include <utility>

namespace vbm::impl {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// Share of the count that the search may fall short by; cutting makes up for it. And ratio of the
/// slacks between which the search ends: a closer look moves no error visibly.
constexpr double kShort = 0.03, kClose = 1.01;
/// More halvings than any search takes that is not stopped by these two.
constexpr int kMaxHalvings = 60;

struct Group {
  Ball enclosing;
  std::vector<int32_t> members; // the largest first
};

/// How far a group's enclosing ball may be from what it stands for.
class Errors {
public:
  Errors(const std::vector<Ball> &balls, bool by_union, Progress &progress) : balls_(balls) {
    if (by_union) gap_ = std::make_unique<UnionGap>(balls, progress);
  }
  double operator()(const Group &group) const {
    const double most = 2 * (group.enclosing.radius - balls_[group.members.front()].radius);
    return gap_ && most > 0 ? std::min(most, gap_->bound(group.enclosing)) : most;
  }

private:
  const std::vector<Ball> &balls_;
  std::unique_ptr<UnionGap> gap_;
};

Group group_of(const std::vector<Ball> &balls, std::vector<int32_t> members, Progress &progress) {
  std::sort(members.begin(), members.end());
  const auto largest =
      std::max_element(members.begin(), members.end(), [&](int32_t a, int32_t b) {
        return balls[a].radius < balls[b].radius; // the first of them
      });
  std::rotate(members.begin(), largest, largest + 1);
  EnclosingBall enclosing(balls, progress);
  enclosing.start(members.front());
  enclosing.add(members.data() + 1, members.data() + members.size(), kNoLimit);
  return {enclosing.ball(), std::move(members)};
}

/// In two: round the largest ball, and round the one that reaches farthest from there.
std::pair<Group, Group> cut(const std::vector<Ball> &balls, const Errors &error,
                            const Group &group, Progress &progress) {
  const int32_t a = group.members.front();
  const auto out = [&](int32_t i, int32_t from) { // how far i reaches out of it
    return distance(balls[i].center, balls[from].center) + balls[i].radius - balls[from].radius;
  };
  int32_t b = group.members[1];
  for (int32_t i : group.members)
    if (i != a && out(i, a) > out(b, a)) b = i;
  std::vector<int32_t> first{a}, second{b}, rest{a};
  for (int32_t i : group.members) {
    if (i == a || i == b) continue;
    (out(i, a) <= out(i, b) ? first : second).push_back(i);
    rest.push_back(i);
  }
  std::pair<Group, Group> two{group_of(balls, std::move(first), progress),
                              group_of(balls, std::move(second), progress)};
  if (std::max(error(two.first), error(two.second)) > error(group))
    two = {group_of(balls, std::move(rest), progress), group_of(balls, {b}, progress)};
  return two;
}

/// Cut groups, the worst first, until there are so many.
void cut_to(const std::vector<Ball> &balls, const Errors &error, std::size_t count,
            Grouping &grouping, Progress &progress) {
  std::vector<Group> groups;
  std::priority_queue<std::pair<double, int64_t>> worst; // of equal ones the earliest
  const auto push = [&](std::size_t g) {
    if (groups[g].members.size() > 1)
      worst.push({error(groups[g]), -int64_t(g)});
  };
  for (std::size_t g = 0; g < grouping.enclosing.size(); ++g) {
    const auto begin = grouping.members.index.begin();
    groups.push_back({grouping.enclosing[g],
                      {begin + int64_t(grouping.members.offset[g]),
                       begin + int64_t(grouping.members.offset[g + 1])}});
    push(g);
  }
  while (groups.size() < count && !worst.empty() && worst.top().first > 0) {
    progress.tick_slow(groups.size(), count);
    const std::size_t g = std::size_t(-worst.top().second);
    worst.pop();
    auto [first, second] = cut(balls, error, groups[g], progress);
    groups[g] = std::move(first);
    groups.push_back(std::move(second));
    push(g);
    push(groups.size() - 1);
  }
  grouping = {};
  for (const Group &group : groups) {
    grouping.enclosing.push_back(group.enclosing);
    grouping.members.index.insert(grouping.members.index.end(), group.members.begin(),
                                  group.members.end());
    grouping.members.offset.push_back(grouping.members.index.size());
  }
}

} // namespace

Grouping best_groups(const std::vector<Ball> &balls, std::size_t count, bool by_union,
                     Progress &progress) {
  const std::size_t total = balls.size();
  const auto groups = [&](double slack) {
    Allowance allowance;
    allowance.slack = slack;
    allowance.by_union = by_union && slack > 0;
    return group_balls(balls, allowance, count, progress);
  };
  const auto whole = [&](const Grouping &g) { return g.members.index.size() == total; };

  progress.stage("balls inside others", 0.05);
  Grouping best = groups(0);
  if (whole(best)) return best;
  // One ball about all: its radius is the largest slack there can be.
  std::vector<int32_t> others(total);
  std::iota(others.begin(), others.end(), 0);
  EnclosingBall all(balls, progress);
  all.start(0);
  all.add(others.data() + 1, others.data() + total, kNoLimit);
  double low = 0, high = all.ball().radius;
  best = {};
  for (int halving = 0; halving < kMaxHalvings; ++halving) {
    progress.stage("least error", 0.05 + 0.85 * (1 - std::pow(0.8, halving + 1)));
    const double slack = best.enclosing.empty() ? high : low > 0 ? std::sqrt(low * high) : high / 4;
    Grouping g = groups(slack);
    if (whole(g)) {
      high = slack;
      best = std::move(g);
      if (double(best.enclosing.size()) >= (1 - kShort) * double(count)) break;
    } else {
      low = slack;
      if (best.enclosing.empty()) high *= 2; // rounding
    }
    if (!best.enclosing.empty() && low > 0 && high <= low * kClose) break;
  }
  progress.stage("worst clusters", 0.98);
  cut_to(balls, Errors(balls, by_union, progress), count, best, progress);
  return best;
}

} // namespace vbm::impl
