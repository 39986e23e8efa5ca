// SPDX-License-Identifier: GPL-3.0-or-later
// Samples where one part of a mesh runs inside another: not on the boundary of what they bound
// together.
#pragma once

#include "sampling/parts.h"
#include "sampling/triangle_tree.h"

#include <vector>

namespace vbm::impl {

/// Knows for points of a mesh's faces whether the other parts wind round them so often that both
/// sides of the face are inside, or both outside. Queries are const and may run on many threads.
class BuriedTest {
public:
  /// Of triangles, and parts whose windings may be other than 0 and 1.
  BuriedTest(const std::vector<Triangle> &triangles, const Parts &parts, Progress &progress);

  /// `normal` is that of the face. False where it is not certain: on an open part, on faces of
  /// several parts, or where a part lies within or across itself.
  bool buried(const Vec3 &point, const Vec3 &normal) const;

private:
  struct Shell {
    Vec3 low, high;
    bool solid = false, inward = false;
    TriangleTree tree;
    bool winds_once(const Vec3 &point, const Vec3 &normal) const;
  };
  std::vector<Shell> shells_;
};

/// Leave such samples out, with a note. Input points are counted as dropped, others as not added.
void drop_buried(const BuriedTest &test, Samples &samples, Progress &progress);

} // namespace vbm::impl
