// SPDX-License-Identifier: GPL-3.0-or-later
// One labelling for all the rules of thesis 3.1.2. Every sample has an axis: its normal, or where
// none is given the direction to its pole (Amenta and Bern 1998: the pole vector estimates the
// normal). A ball that touches a sample lies in front of or behind it along that axis, the more
// clearly the nearer to the axis its centre is seen from the sample. That is the thesis's
// dot-product test for normals and scan directions; and for bare points both of the power crust's
// rules at once (Amenta, Choi, Kolluri 2001): two balls through one sample intersect at the angle
// between their centres seen from it, so deeply intersecting balls are on one side of its axis, and
// its two poles on opposite sides. What differs: votes are summed over all balls and samples
// instead of following the single strongest link, and no power diagram is needed for it.
#include "balls/labels.h"

#include "core/error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace vbm::impl {

namespace {

/// A ball or a sample while labels spread: what was voted on it so far, all that can be, and how
/// certain of itself it was at most, in steps.
struct Node {
  float vote = 0, total = 0;
  uint8_t step = 0;
  bool done = false;
};

/// Nodes by descending confidence in [0, 1], in steps; within a step the last one in comes out
/// first, so that work stays in one neighbourhood of memory.
class BucketQueue {
public:
  /// Nodes may be pushed again as they grow more certain, and then come out more than once.
  void push(int32_t index, Node &node, float key) {
    const int b = std::clamp(int(key * kSteps), 1, kSteps - 1);
    if (b <= node.step) return;
    node.step = uint8_t(b);
    bucket_[b].push_back(index);
    top_ = std::max(top_, b);
  }
  /// The next node, or -1.
  int32_t pop() {
    for (; top_ >= 0; --top_) {
      auto &b = bucket_[top_];
      if (b.empty()) continue;
      const int32_t index = b.back();
      b.pop_back();
      return index;
    }
    return -1;
  }

private:
  static constexpr int kSteps = 64;
  std::vector<int32_t> bucket_[kSteps];
  int top_ = -1;
};

class Labeller {
public:
  Labeller(const Samples &samples, const Cells &cells, const BallSet &balls, Progress &progress)
      : samples_(samples), cells_(cells), balls_(balls), progress_(progress) {}

  Labels run() {
    find_axes();
    weigh();
    turn_outward();
    fix_known();
    if (samples_.rule == VBM_LABELS_NORMALS && !any_unknown_)
      vote_balls();
    else
      propagate();
    relax();
    ask();
    return result();
  }

private:
  int32_t sample_count() const { return cells_.samples; }

  void find_axes() {
    const bool normals = samples_.rule == VBM_LABELS_NORMALS || samples_.rule == VBM_LABELS_VOXELS;
    axis_.resize(sample_count());
    sign_.assign(sample_count(), 0);
    fixed_sample_.assign(sample_count(), 0);
    std::vector<float> best(sample_count(), 0);
    std::vector<int32_t> pole(sample_count(), -1);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      progress_.tick(0, 1);
      const int32_t b = balls_.of_cell[c];
      const float r = float(balls_.ball[b].radius);
      for (int32_t v : cells_.vertex[c])
        if (v < cells_.samples && r > best[v]) best[v] = r, pole[v] = b;
    }
    for (int32_t s = 0; s < sample_count(); ++s) {
      progress_.tick(0, 1);
      const Vec3 given = samples_.normal.empty() ? Vec3{} : samples_.normal[s];
      const bool known = dot(given, given) > 0;
      const Vec3 to_pole = unit(balls_.ball[pole[s]].center - samples_.position[s]);
      if (normals && known) {
        axis_[s] = given;
        sign_[s] = 1;
        fixed_sample_[s] = 1;
      } else {
        axis_[s] = to_pole;
        any_unknown_ = true;
        if (samples_.rule == VBM_LABELS_SCAN && known) {
          const double facing = dot(given, to_pole);
          if (std::fabs(facing) > kGrazing) {
            sign_[s] = facing > 0 ? 1 : -1;
            fixed_sample_[s] = 1;
          }
        }
      }
    }
  }

  /// Votes between every cell and its samples: the cosine at the sample between its axis and the
  /// ball's centre, squared with its sign kept, so that balls beside a sample (slivers) hardly
  /// vote.
  void weigh() {
    weight_.resize(cells_.size());
    ball_total_.assign(balls_.ball.size(), 0);
    sample_total_.assign(sample_count(), 0);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const int32_t b = balls_.of_cell[c];
      const Ball &ball = balls_.ball[b];
      float total = ball_total_[b];
      for (int i = 0; i < 4; ++i) {
        const int32_t s = cells_.vertex[c][i];
        float w = 0;
        if (s < cells_.samples && ball.radius > 0) {
          const double t = dot(ball.center - samples_.position[s], axis_[s]) / ball.radius;
          w = float(t * std::fabs(t));
          sample_total_[s] += std::fabs(w);
        }
        weight_[c][i] = w;
        total += std::fabs(w);
      }
      ball_total_[b] = total;
      progress_.tick(c, cells_.size());
    }
  }

  /// Normals of points or of an open mesh may all point inward; a closed mesh was looked at before.
  /// The balls at the closing box are outside, so the samples they touch must mostly show them
  /// their front.
  void turn_outward() {
    if (samples_.rule != VBM_LABELS_NORMALS || samples_.inside) return;
    double front = 0;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (!cells_.has_corner(c)) continue;
      for (int i = 0; i < 4; ++i)
        if (const int32_t s = cells_.vertex[c][i]; s < cells_.samples && fixed_sample_[s])
          front += weight_[c][i];
    }
    if (front >= 0) return;
    turned_ = true;
    for (int32_t s = 0; s < sample_count(); ++s) sign_[s] = int8_t(-sign_[s]);
  }

  /// Balls that touch a corner of the closing box are outside.
  void fix_known() {
    label_.assign(balls_.ball.size(), 0);
    fixed_ball_.assign(balls_.ball.size(), 0);
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (cells_.has_corner(c)) fix(balls_.of_cell[c], -1);
    if (samples_.inside && samples_.inside->decides_every_ball())
      for (std::size_t b = 0; b < balls_.ball.size(); ++b) {
        progress_.tick(b, balls_.ball.size());
        if (!fixed_ball_[b]) ask(int32_t(b));
      }
  }

  void fix(int32_t ball, int8_t label) {
    label_[ball] = label;
    fixed_ball_[ball] = 1;
  }

  void ask(int32_t b) {
    const Ball &ball = balls_.ball[b];
    switch (samples_.inside->test(ball.center, ball.radius)) {
    case InsideTest::Answer::inside:
      fix(b, 1);
      break;
    case InsideTest::Answer::outside:
      fix(b, -1);
      break;
    case InsideTest::Answer::unknown:
      break;
    }
  }

  /// Fill votes_ from the samples' signs.
  void vote_on_balls() {
    votes_.assign(balls_.ball.size(), 0);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      progress_.tick(c, cells_.size());
      float vote = votes_[balls_.of_cell[c]];
      for (int i = 0; i < 4; ++i)
        if (const int32_t s = cells_.vertex[c][i]; s < cells_.samples)
          vote += weight_[c][i] * sign_[s];
      votes_[balls_.of_cell[c]] = vote;
    }
  }

  /// In front of an outward axis is outside: positive votes mean outside.
  void vote_balls() {
    vote_on_balls();
    for (std::size_t b = 0; b < balls_.ball.size(); ++b)
      if (!fixed_ball_[b]) label_[b] = votes_[b] > 0 ? -1 : 1;
  }

  void build_incidence() {
    first_.assign(sample_count() + 1, 0);
    for (const auto &cell : cells_.vertex)
      for (int32_t v : cell)
        if (v < cells_.samples) ++first_[v + 1];
    for (int32_t s = 0; s < sample_count(); ++s) first_[s + 1] += first_[s];
    slot_.resize(first_.back());
    std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      progress_.tick(0, 1);
      for (int i = 0; i < 4; ++i)
        if (const int32_t v = cells_.vertex[c][i]; v < cells_.samples)
          slot_[next[v]++] = uint32_t(4 * c + i);
    }
    progress_.tick_slow(0, 1);
    ball_first_.assign(balls_.ball.size() + 1, 0);
    for (int32_t b : balls_.of_cell) ++ball_first_[b + 1];
    for (std::size_t b = 0; b < balls_.ball.size(); ++b) ball_first_[b + 1] += ball_first_[b];
    ball_cell_.resize(cells_.size());
    next.assign(ball_first_.begin(), ball_first_.end() - 1);
    for (std::size_t c = 0; c < cells_.size(); ++c)
      ball_cell_[next[balls_.of_cell[c]]++] = int32_t(c);
  }

  /// Nodes 0 .. balls - 1 are balls, the rest samples. The most certain node is decided next, and
  /// votes on its neighbours.
  void propagate() {
    build_incidence();
    const int32_t balls = int32_t(balls_.ball.size());
    std::vector<Node> nodes(std::size_t(balls) + sample_count());
    for (int32_t b = 0; b < balls; ++b) nodes[b].total = ball_total_[b] + kDoubt;
    for (int32_t s = 0; s < sample_count(); ++s) nodes[balls + s].total = sample_total_[s] + kDoubt;
    BucketQueue queue;
    const auto vote = [&](int32_t index, float weight) {
      Node &node = nodes[index];
      if (node.done) return;
      node.vote += weight;
      queue.push(index, node, std::fabs(node.vote) / node.total);
    };
    const auto spread_ball = [&](int32_t b) {
      for (uint32_t k = ball_first_[b]; k < ball_first_[b + 1]; ++k) {
        const int32_t c = ball_cell_[k];
        for (int i = 0; i < 4; ++i) // an outside ball in front: outward
          if (const int32_t s = cells_.vertex[c][i]; s < cells_.samples)
            vote(balls + s, -weight_[c][i] * label_[b]);
      }
    };
    const auto spread_sample = [&](int32_t s) {
      for (uint32_t k = first_[s]; k < first_[s + 1]; ++k) {
        const uint32_t c = slot_[k] / 4;
        vote(balls_.of_cell[c], weight_[c][slot_[k] & 3] * sign_[s]);
      }
    };
    std::size_t decided = 0;
    const auto decide = [&](Node &node) {
      node.done = true;
      ++decided;
    };
    for (int32_t b = 0; b < balls; ++b)
      if (fixed_ball_[b]) decide(nodes[b]);
    for (int32_t s = 0; s < sample_count(); ++s)
      if (fixed_sample_[s]) decide(nodes[balls + s]);
    for (int32_t b = 0; b < balls; ++b)
      if (fixed_ball_[b]) spread_ball(b);
    for (int32_t s = 0; s < sample_count(); ++s)
      if (fixed_sample_[s]) spread_sample(s);
    while (decided < nodes.size()) {
      const int32_t index = queue.pop();
      if (index < 0) break;
      Node &node = nodes[index];
      if (node.done) continue;
      decide(node);
      if (index < balls) {
        label_[index] = node.vote > 0 ? -1 : 1;
        spread_ball(index);
      } else {
        sign_[index - balls] = node.vote < 0 ? -1 : 1;
        spread_sample(index - balls);
      }
      progress_.tick(decided, nodes.size());
    }
    std::vector<uint32_t>().swap(slot_);
  }

  /// Let every undecided sample and ball follow the majority of the other side until nothing
  /// changes.
  void relax() {
    if (first_.empty()) return;
    std::vector<float> votes;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      std::size_t changed = 0;
      votes.assign(sample_count(), 0);
      for (std::size_t c = 0; c < cells_.size(); ++c) {
        progress_.tick(c, cells_.size());
        const float label = label_[balls_.of_cell[c]];
        for (int i = 0; i < 4; ++i)
          if (const int32_t s = cells_.vertex[c][i]; s < cells_.samples)
            votes[s] -= weight_[c][i] * label;
      }
      for (int32_t s = 0; s < sample_count(); ++s) {
        if (fixed_sample_[s]) continue;
        const int8_t sign = votes[s] < 0 ? -1 : 1;
        changed += sign != sign_[s];
        sign_[s] = sign;
      }
      vote_on_balls();
      progress_.tick_slow(1, 1);
      for (std::size_t b = 0; b < balls_.ball.size(); ++b) {
        progress_.tick(1, 1);
        if (fixed_ball_[b]) continue;
        const int8_t label = votes_[b] > 0 ? -1 : 1;
        changed += label != label_[b];
        label_[b] = label;
      }
      if (!changed) break;
    }
  }

  /// Where the samples of a ball contradict each other, the input itself decides if it can.
  void ask() {
    if (!samples_.inside || samples_.inside->decides_every_ball()) return;
    for (std::size_t b = 0; b < balls_.ball.size(); ++b) {
      if (fixed_ball_[b] || std::fabs(votes_[b]) > kAgreement * ball_total_[b]) continue;
      ask(int32_t(b));
      trust(int32_t(b));
      progress_.tick_slow(b, balls_.ball.size());
    }
  }

  /// How far the surface keeps from the centre, in radii. A sliver along the surface has its centre
  /// on it, and its label is as good as its opposite.
  void trust(int32_t b) {
    if (trust_.empty()) trust_.assign(balls_.ball.size(), -1);
    const Ball &ball = balls_.ball[b];
    Vec3 point, normal;
    if (samples_.refiner && samples_.refiner->nearest(ball.center, ball.radius, point, normal))
      trust_[b] = float(distance(ball.center, point) / ball.radius);
  }

  Labels result() {
    Labels out;
    out.turned = turned_;
    out.inside.resize(balls_.ball.size());
    out.confidence.resize(balls_.ball.size());
    for (std::size_t b = 0; b < balls_.ball.size(); ++b) {
      progress_.tick(1, 1);
      out.inside[b] = label_[b] > 0;
      if (!trust_.empty() && trust_[b] >= 0) {
        out.confidence[b] = std::min(trust_[b], 0.99f);
        continue;
      }
      out.confidence[b] = fixed_ball_[b] ? 1 : std::fabs(votes_[b]) / (ball_total_[b] + kDoubt);
    }
    return out;
  }

  /// Cosine: scan directions this near to the surface do not tell its sides apart.
  static constexpr double kGrazing = 0.05;
  /// Votes: added to a node's total, so that a node with hardly any votes is not certain of itself.
  static constexpr float kDoubt = 0.05f;
  /// Share of the votes: a ball whose samples agree less than this is asked about.
  static constexpr float kAgreement = 0.98f;
  static constexpr int kSweeps = 20;

  const Samples &samples_;
  const Cells &cells_;
  const BallSet &balls_;
  Progress &progress_;

  std::vector<Vec3> axis_;
  std::vector<int8_t> sign_;  // per sample: +1 its axis points outward, -1 inward, 0 unknown
  std::vector<int8_t> label_; // per ball: +1 inside, -1 outside, 0 unknown
  std::vector<uint8_t> fixed_sample_, fixed_ball_;
  std::vector<std::array<float, 4>> weight_; // per cell and vertex
  std::vector<float> ball_total_, sample_total_;
  std::vector<float> votes_; // per ball, by the signs as they are
  std::vector<float> trust_; // per ball that was asked about, else -1; empty if none was
  std::vector<uint32_t> first_, slot_, ball_first_;
  std::vector<int32_t> ball_cell_;
  bool any_unknown_ = false, turned_ = false;
};

} // namespace

Labels label_balls(const Samples &samples, const Cells &cells, const BallSet &balls,
                   Progress &progress) {
  return Labeller(samples, cells, balls, progress).run();
}

} // namespace vbm::impl
