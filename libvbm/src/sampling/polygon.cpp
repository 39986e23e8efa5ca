// SPDX-License-Identifier: GPL-3.0-or-later
// Ear clipping after Meisters, "Polygons have ears" (1975), in the plane of Newell's normal.
// Corners that may stand in an ear's way are looked up by their first coordinate, so that a polygon
// of many corners and small ears takes little more than sorting; a bound on the work keeps the
// worst case from being quadratic. Where no ear is left (the polygon crosses itself) the next
// corner is cut off all the same.
#include "sampling/polygon.h"

#include "core/progress.h"
#include "sampling/tolerances.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

struct Point2 {
  double x, y;
};

double turn(const Point2 &a, const Point2 &b, const Point2 &c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon seen against its normal: counter-clockwise.
std::vector<Point2> flatten(const std::vector<int32_t> &corners,
                            const std::vector<Vec3> &position) {
  const Vec3 origin = position[corners[0]];
  Vec3 normal;
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal +=
        cross(position[corners[i]] - origin, position[corners[(i + 1) % corners.size()]] - origin);
  normal = unit(normal);
  const Vec3 along = std::fabs(normal.x) < 0.6   ? Vec3{1, 0, 0}
                     : std::fabs(normal.y) < 0.6 ? Vec3{0, 1, 0}
                                                 : Vec3{0, 0, 1};
  const Vec3 v = unit(cross(normal, along)), u = cross(v, normal);
  std::vector<Point2> flat;
  for (int32_t c : corners)
    flat.push_back({dot(position[c] - origin, u), dot(position[c] - origin, v)});
  return flat;
}

class EarClipper {
public:
  EarClipper(const std::vector<int32_t> &corners, std::vector<Point2> flat)
      : corners_(corners), flat_(std::move(flat)), n_(static_cast<int32_t>(corners.size())) {
    before_.resize(n_), after_.resize(n_);
    for (int32_t i = 0; i < n_; ++i) before_[i] = (i + n_ - 1) % n_, after_[i] = (i + 1) % n_;
    for (int32_t i = 0; i < n_; ++i)
      if (turn_at(i) <= 0) reflex_.push_back(i);
    std::sort(reflex_.begin(), reflex_.end(), [this](int32_t i, int32_t j) {
      return flat_[i].x != flat_[j].x ? flat_[i].x < flat_[j].x : i < j;
    });
    gone_.assign(n_, 0);
    budget_ = kEarWork * n_;
  }

  void clip(std::vector<Triangle> &out, Progress &progress) {
    int32_t i = 0, tried = 0;
    for (int32_t left = n_; left > 3;) {
      if ((tried & 63) == 0) progress.tick(0, 1);
      if (tried <= left && budget_ > 0 && !is_ear(i)) {
        i = after_[i];
        ++tried;
        continue;
      }
      out.push_back({corners_[before_[i]], corners_[i], corners_[after_[i]]});
      after_[before_[i]] = after_[i];
      before_[after_[i]] = before_[i];
      gone_[i] = 1;
      i = after_[after_[i]]; // leave the neighbour, or the ears become a fan of needles
      tried = 0;
      --left;
    }
    out.push_back({corners_[before_[i]], corners_[i], corners_[after_[i]]});
  }

private:
  double turn_at(int32_t i) const { return turn(flat_[before_[i]], flat_[i], flat_[after_[i]]); }

  bool is_ear(int32_t i) {
    const int32_t h = before_[i], j = after_[i];
    const Point2 a = flat_[h], b = flat_[i], c = flat_[j];
    --budget_;
    if (!(turn(a, b, c) > 0)) return false;
    const double low = std::min({a.x, b.x, c.x}), high = std::max({a.x, b.x, c.x});
    auto k = std::lower_bound(reflex_.begin(), reflex_.end(), low,
                              [this](int32_t r, double x) { return flat_[r].x < x; });
    for (; k != reflex_.end() && flat_[*k].x <= high; ++k) {
      --budget_;
      const int32_t r = *k;
      if (gone_[r] || r == h || r == i || r == j) continue;
      const int32_t v = corners_[r]; // a corner passed twice blocks nothing at its own place
      if (v == corners_[h] || v == corners_[i] || v == corners_[j]) continue;
      const Point2 p = flat_[r];
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0 && turn_at(r) <= 0)
        return false;
    }
    return true;
  }

  const std::vector<int32_t> &corners_;
  std::vector<Point2> flat_;
  int32_t n_;
  std::vector<int32_t> before_, after_, reflex_;
  std::vector<uint8_t> gone_;
  int64_t budget_;
};

/// The same cyclic sequence for a polygon wherever it starts and whichever way it runs, so that
/// copies and reversed copies are cut alike. Returns whether it had to be reversed.
bool make_canonical(std::vector<int32_t> &corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  if (corners[1] <= corners.back()) return false;
  std::reverse(corners.begin() + 1, corners.end());
  return true;
}

void cut_quadrangle(const std::vector<int32_t> &c, const std::vector<Point2> &p,
                    const std::vector<Vec3> &position, std::vector<Triangle> &out) {
  const bool fits02 = turn(p[0], p[1], p[2]) > 0 && turn(p[0], p[2], p[3]) > 0;
  const bool fits13 = turn(p[1], p[2], p[3]) > 0 && turn(p[1], p[3], p[0]) > 0;
  const bool shorter02 =
      distance(position[c[0]], position[c[2]]) <= distance(position[c[1]], position[c[3]]);
  if (fits02 != fits13 ? fits02 : shorter02)
    out.insert(out.end(), {{c[0], c[1], c[2]}, {c[0], c[2], c[3]}});
  else
    out.insert(out.end(), {{c[1], c[2], c[3]}, {c[1], c[3], c[0]}});
}

} // namespace

void triangulate_polygon(const std::vector<int32_t> &corners, const std::vector<Vec3> &position,
                         std::vector<Triangle> &out, Progress &progress) {
  std::vector<int32_t> canonical = corners;
  const bool reversed = make_canonical(canonical);
  std::vector<Point2> flat = flatten(canonical, position);
  const std::size_t first = out.size();
  if (canonical.size() == 4)
    cut_quadrangle(canonical, flat, position, out);
  else
    EarClipper(canonical, std::move(flat)).clip(out, progress);
  if (reversed)
    for (std::size_t t = first; t < out.size(); ++t) std::swap(out[t][1], out[t][2]);
}

} // namespace vbm::impl
