// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest ball enclosing balls, grown one ball after another.
#pragma once

#include "core/model.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vbm::impl {

class Progress;

/// Keeps the smallest enclosing ball of the balls added so far. Those that determine it (four at
/// most, Fischer and Gärtner 2004) are its basis, so that most balls that would make it too large
/// are refused without a look at the rest.
class EnclosingBall {
public:
  /// `balls` and `progress` must outlive it.
  EnclosingBall(const std::vector<Ball> &balls, Progress &progress);
  ~EnclosingBall();

  /// Begin anew with one of the balls.
  void start(int32_t ball);
  /// Add balls, all or none: if the smallest enclosing ball then has at most this radius.
  bool add(const int32_t *first, const int32_t *last, double limit);
  bool add(int32_t ball, double limit) { return add(&ball, &ball + 1, limit); }

  const Ball &ball() const { return ball_; }
  const std::vector<int32_t> &members() const { return members_; }

private:
  struct Solver;

  double farthest(double limit) const;
  const int32_t *outmost(const int32_t *first, const int32_t *last, const Vec3 &center,
                         double &reach) const;
  bool enclose(int32_t outside, const int32_t *first, const int32_t *last, double limit);

  const std::vector<Ball> &balls_;
  Progress &progress_;
  std::unique_ptr<Solver> solver_;
  Ball ball_;
  std::vector<int32_t> members_, basis_, trial_;
};

} // namespace vbm::impl
