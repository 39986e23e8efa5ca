// SPDX-License-Identifier: GPL-3.0-or-later
// Circumcentres in doubles relative to one vertex, and where that is ill-conditioned, numerators
// and denominator in CGAL's exact ring arithmetic, rounded once.
#include "balls/circumcenter.h"

#include "core/exact.h"
#include "core/tolerances.h"

#include <algorithm>
#include <limits>

namespace vbm::impl {

namespace {

/// Numerators n and denominator d with centre - p0 = n / d, for edges a, b, c from p0.
template <class T> struct Quotients { T x, y, z, d; };

template <class T> Quotients<T> center_offset(const T (&a)[3], const T (&b)[3], const T (&c)[3]) {
  const T aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
  const T bb = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
  const T cc = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
  const T bc[3] = {b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]};
  const T ca[3] = {c[1] * a[2] - c[2] * a[1], c[2] * a[0] - c[0] * a[2], c[0] * a[1] - c[1] * a[0]};
  const T ab[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const T det = a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
  return {aa * bc[0] + bb * ca[0] + cc * ab[0], aa * bc[1] + bb * ca[1] + cc * ab[1],
          aa * bc[2] + bb * ca[2] + cc * ab[2], det + det};
}

Vec3 exact_offset(const Vec3 &p, const Vec3 &q, const Vec3 &r, const Vec3 &s) {
  const auto scaled = [](double x) { return Exact(x * kSampleScale); };
  const Exact o[3] = {scaled(p.x), scaled(p.y), scaled(p.z)};
  const Exact a[3] = {scaled(q.x) - o[0], scaled(q.y) - o[1], scaled(q.z) - o[2]};
  const Exact b[3] = {scaled(r.x) - o[0], scaled(r.y) - o[1], scaled(r.z) - o[2]};
  const Exact c[3] = {scaled(s.x) - o[0], scaled(s.y) - o[1], scaled(s.z) - o[2]};
  const auto n = center_offset(a, b, c);
  const double d = CGAL::to_double(n.d) * kSampleScale;
  return {CGAL::to_double(n.x) / d, CGAL::to_double(n.y) / d, CGAL::to_double(n.z) / d};
}

} // namespace

Ball circumball(const Cells &cells, const std::vector<Vec3> &samples, std::size_t cell,
                double *condition) {
  const auto at = [&](int i) -> const Vec3 & {
    const int32_t v = cells.vertex[cell][i];
    return v < cells.samples ? samples[v] : cells.corner[v - cells.samples];
  };
  const Vec3 &p = at(0), &q = at(1), &r = at(2), &s = at(3);
  const double a[3] = {q.x - p.x, q.y - p.y, q.z - p.z};
  const double b[3] = {r.x - p.x, r.y - p.y, r.z - p.z};
  const double c[3] = {s.x - p.x, s.y - p.y, s.z - p.z};
  const auto n = center_offset(a, b, c);
  const double size =
      length({a[0], a[1], a[2]}) * length({b[0], b[1], b[2]}) * length({c[0], c[1], c[2]});
  *condition = 2 * size / std::fabs(n.d);
  const Vec3 offset = *condition < kIllConditioned ? Vec3{n.x / n.d, n.y / n.d, n.z / n.d}
                                                   : exact_offset(p, q, r, s);
  return {p + offset, length(offset)};
}

Circumballs circumscribe(const Cells &cells, const std::vector<Vec3> &samples, Progress &progress,
                         const std::vector<uint8_t> *only) {
  Circumballs out;
  out.ball.resize(cells.size());
  out.condition.resize(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (only && !(*only)[i]) {
      out.condition[i] = std::numeric_limits<float>::infinity();
      continue;
    }
    double condition;
    out.ball[i] = circumball(cells, samples, i, &condition);
    out.condition[i] = float(std::min(condition, 1e30));
    out.exact += condition >= kIllConditioned;
    progress.tick(i, cells.size());
  }
  return out;
}

} // namespace vbm::impl
