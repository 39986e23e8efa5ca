// SPDX-License-Identifier: GPL-3.0-or-later
// The envelope of a ball complex: the union of its balls, of the truncated cones along its edges
// and of the slabs over its triangles. How far a point is from it.
#pragma once

#include "medial/ball_complex.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// One, two or three balls; the others are -1.
using Primitive = std::array<int32_t, 3>;

/// How a point lies to a primitive.
struct EnvelopeHit {
  double distance = 0;               // to its boundary, negative inside
  int32_t primitive = -1;            // among Envelope::primitives()
  std::array<double, 3> weight = {}; // of its balls: the mixture that reaches the point best
};

class Envelope {
public:
  /// The complex must outlive it.
  Envelope(const BallComplex &complex, Progress &progress);

  /// Triangles, then edges of no triangle, then balls of neither.
  const std::vector<Primitive> &primitives() const { return primitive_; }

  /// The primitive whose signed distance is least. For a point outside the envelope that is its
  /// distance; a point inside is at least that deep. A primitive that is likely to be it, -1 for
  /// none, makes it quicker, and is the one that is told if others are as near.
  EnvelopeHit nearest(const Vec3 &p, int32_t likely = -1) const;
  /// Whether p is deeper than `depth` inside some primitive.
  bool covers(const Vec3 &p, double depth) const;

  /// The centre and the radius of a mixture of a primitive's balls.
  Ball at(const EnvelopeHit &hit) const;

private:
  struct Slab {
    Vec3 normal, gradient; // of the triangle; of the radius over it
    Vec3 to_b, to_c;       // dual vectors: weights of the second and third ball
    double slope = 2;      // sqrt(1 - |gradient|^2); beyond 1: no tangent planes, the edges tell
    uint8_t edges = 0;     // bit i: the edge from ball i to the next is tested with this triangle
  };
  struct Node {
    Vec3 low, high;            // of centres
    double radius;             // largest
    int32_t begin, end, right; // primitives; the second child, the first being next; -1 in leaves
  };

  void add(const Primitive &primitive);
  void share_edges();
  void build(Progress &progress);
  double bound(const Node &node, const Vec3 &p) const;
  void test(int32_t primitive, const Vec3 &p, EnvelopeHit &best) const;
  void test_edge(int32_t primitive, int i, int j, const Vec3 &p, EnvelopeHit &best) const;

  const BallComplex &complex_;
  std::vector<Primitive> primitive_;
  std::vector<Slab> slab_; // of triangles
  std::vector<int32_t> order_;
  std::vector<Node> node_;
};

} // namespace vbm::impl
