// SPDX-License-Identifier: GPL-3.0-or-later
// A face has one winding number on its back and one less on its front: those of the other parts
// there, which do not change across it, and its own part's. No step off the face is needed, which
// at edges and corners could end anywhere.
#include "sampling/buried.h"

#include "core/progress.h"
#include "sampling/checks.h"
#include "sampling/tolerances.h"

#include <algorithm>

namespace vbm::impl {
namespace {

/// Unit lengths. Steps off a face to its sides, where its part should wind round once and not at
/// all: far above rounding, far below any sampling.
constexpr double kStep = 1e-7;

bool holds(const Vec3 &low, const Vec3 &high, const Vec3 &p) {
  for (int a = 0; a < 3; ++a)
    if (p[a] < low[a] - kNearDuplicate || p[a] > high[a] + kNearDuplicate) return false;
  return true;
}

template <class T> void keep_only(const std::vector<uint8_t> &gone, std::vector<T> &values) {
  std::size_t to = 0;
  for (std::size_t s = 0; s < values.size(); ++s)
    if (!gone[s]) values[to++] = values[s];
  values.resize(to);
}

} // namespace

BuriedTest::BuriedTest(const std::vector<Triangle> &triangles, const Parts &parts,
                       Progress &progress)
    : shells_(parts.part.size()) {
  std::vector<std::vector<Triangle>> faces(shells_.size());
  std::vector<std::vector<uint8_t>> use(shells_.size());
  const auto add = [&](const Triangle &t, int32_t part, int what) {
    faces[part].push_back(t);
    use[part].push_back(static_cast<uint8_t>(what));
  };
  for (std::size_t t = 0; t < triangles.size(); ++t)
    add(triangles[t], parts.part_of[t], TriangleTree::winding | TriangleTree::surface);
  for (std::size_t c = 0; c < parts.caps.size(); ++c)
    add(parts.caps[c], parts.cap_part[c], TriangleTree::winding);
  std::vector<int32_t> number(parts.position.size(), -1); // within the part
  for (std::size_t p = 0; p < shells_.size(); ++p) {
    progress.tick_slow(p, shells_.size());
    std::vector<Vec3> position;
    std::vector<int32_t> corners;
    for (Triangle &t : faces[p])
      for (int32_t &v : t) {
        if (number[v] < 0) {
          number[v] = static_cast<int32_t>(position.size());
          position.push_back(parts.position[v]);
          corners.push_back(v);
        }
        v = number[v];
      }
    for (int32_t v : corners) number[v] = -1;
    const Part &part = parts.part[p];
    shells_[p].low = part.low;
    shells_[p].high = part.high;
    shells_[p].solid = part.solid;
    shells_[p].inward = part.volume < 0;
    shells_[p].tree = TriangleTree(std::move(position), faces[p], use[p], progress);
  }
}

bool BuriedTest::Shell::winds_once(const Vec3 &point, const Vec3 &normal) const {
  if (!solid || dot(normal, normal) == 0) return false;
  for (double step : {-kStep, kStep}) {
    int number;
    if (!tree.winding_number(point + normal * step, number)) return false;
    if (number != 0 && number != (inward ? -1 : 1)) return false;
  }
  return true;
}

bool BuriedTest::buried(const Vec3 &point, const Vec3 &normal) const {
  int low = 0, high = 0; // winding numbers at the point's sides
  bool own = false;
  for (const Shell &shell : shells_) {
    if (!holds(shell.low, shell.high, point)) continue;
    TriangleTree::Nearest found{kNearDuplicate, {}, -1};
    if (shell.tree.nearest(point, found)) {
      if (!shell.winds_once(point, normal)) return false;
      own = true;
      shell.inward ? --low : ++high;
    } else if (int number; shell.solid) {
      if (!shell.tree.winding_number(point, number)) return false;
      low += number;
      high += number;
    }
  }
  return own && (low > 0) == (high > 0);
}

void drop_buried(const BuriedTest &test, Samples &samples, Progress &progress) {
  const std::size_t count = samples.position.size();
  std::vector<uint8_t> gone(count);
  std::vector<int32_t> number(count, -1);
  int32_t left = 0;
  for (std::size_t s = 0; s < count; ++s) {
    progress.tick_slow(s, count);
    gone[s] = test.buried(samples.position[s], samples.normal[s]);
    if (!gone[s])
      number[s] = left++;
    else if (samples.input[s] < 0)
      --samples.added;
    else
      ++samples.merged; // all its input points are counted as dropped below
  }
  if (left == int32_t(count)) return;
  for (int32_t &s : samples.input_sample) {
    if (s < 0) continue;
    s = number[s];
    if (s >= 0) continue;
    ++samples.dropped;
    --samples.merged;
  }
  keep_only(gone, samples.position);
  keep_only(gone, samples.normal);
  keep_only(gone, samples.input);
  keep_only(gone, samples.input_position);
  samples.notes.push_back(counted(count - left, "sample was", "samples were") +
                          " left out where parts of the mesh run inside others");
}

} // namespace vbm::impl
