// SPDX-License-Identifier: GPL-3.0-or-later
// Lawson's flips: of slivers where they leave the surface no farther from the skin, which is told
// from the skin's normals at the ends of edges, and the worse of two triangles gets better; and of
// folded triangles, wherever they are less folded after it.
#include "ball_surface/skin_mesh.h"
#include "ball_surface/thinness.h"
#include "core/progress.h"

#include <algorithm>

namespace vbm::impl {
namespace {

/// Squared sine of the smallest angle of a triangle that is a sliver: of 25 degrees.
constexpr double kSliver = 0.18;
/// So much better the worse of two triangles has to get, which is more than rounding.
constexpr double kBetter = 1e-6;
/// Cosine between a triangle's normal and the skin's, below which no flip may bring it.
constexpr double kTurned = 0.7;

/// A triangle's share of flips, at most.
constexpr std::size_t kMostFlips = 10;

class Flipping {
public:
  Flipping(SkinMesh &mesh, const SkinDetail &detail, Progress &progress)
      : mesh_(mesh), least_(detail.least), progress_(progress), twin_(twins_of(mesh, progress)) {}

  std::size_t run() {
    std::vector<int32_t> work;
    for (std::size_t t = mesh_.triangles.size(); t-- > 0;) {
      progress_.tick(0, 1);
      if (is_bad(int32_t(t))) work.push_back(int32_t(t));
    }
    // Each is better than what was there in one way, and there are two.
    const std::size_t most = kMostFlips * mesh_.triangles.size();
    std::size_t flips = 0;
    while (!work.empty() && flips < most) {
      progress_.tick(0, 1);
      const int32_t t = work.back();
      work.pop_back();
      if (!is_bad(t)) continue;
      for (int32_t h = 3 * t; h < 3 * t + 3; ++h) {
        const int32_t other = twin_[h] / 3;
        if (!flip(h)) continue;
        ++flips;
        work.push_back(other);
        work.push_back(t);
        break;
      }
    }
    return flips;
  }

private:
  using Corners = std::array<int32_t, 3>;

  static int32_t next(int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  int32_t from(int32_t h) const { return mesh_.triangles[h / 3].vertex[h % 3]; }
  const Vec3 &at(int32_t v) const { return mesh_.position[v]; }

  bool is_bad(int32_t t) const {
    const Corners &v = mesh_.triangles[t].vertex;
    return thinness_of(v) < kSliver || upright(mesh_, v) < kFolded;
  }

  double thinness_of(const Corners &v) const { return thinness(at(v[0]), at(v[1]), at(v[2])); }

  bool are_joined(int32_t h, int32_t v) const { // h begins at the other
    int32_t k = h;
    do {
      if (from(next(k)) == v) return true;
      k = twin_[next(next(k))];
    } while (k != h);
    return false;
  }

  bool flip(int32_t h) {
    const int32_t g = twin_[h], i = h / 3, j = g / 3;
    const int32_t h1 = next(h), h2 = next(h1), g1 = next(g), g2 = next(g1);
    const int32_t a = from(h), b = from(g), c = from(h2), d = from(g2);
    if (c == d) return false;
    const Corners old_i{a, b, c}, old_j{b, a, d}, new_i{c, a, d}, new_j{d, b, c};
    const double before = std::min(upright(mesh_, old_i), upright(mesh_, old_j)),
                 after = std::min(upright(mesh_, new_i), upright(mesh_, new_j));
    if (before >= kFolded || after <= before + kBetter) {
      const double worst = std::min(thinness_of(old_i), thinness_of(old_j));
      if (std::min(thinness_of(new_i), thinness_of(new_j)) <= worst + kBetter) return false;
      const double least =
          std::min(least_[mesh_.triangles[i].ball], least_[mesh_.triangles[j].ball]);
      if (bend(mesh_, c, d) > std::max(bend(mesh_, a, b), least)) return false;
      if (after < std::min(before, kTurned)) return false;
    }
    if (are_joined(h2, d)) return false;
    const int32_t ca = twin_[h2], ad = twin_[g1], db = twin_[g2], bc = twin_[h1];
    mesh_.triangles[i].vertex = new_i;
    mesh_.triangles[j].vertex = new_j;
    link(3 * i, ca);
    link(3 * i + 1, ad);
    link(3 * j, db);
    link(3 * j + 1, bc);
    link(3 * i + 2, 3 * j + 2);
    return true;
  }

  void link(int32_t h, int32_t g) {
    twin_[h] = g;
    twin_[g] = h;
  }

  SkinMesh &mesh_;
  const std::vector<double> &least_;
  Progress &progress_;
  std::vector<int32_t> twin_; // of half-edges 3 * triangle + side
};

} // namespace

std::size_t flip_slivers(SkinMesh &mesh, const SkinDetail &detail, Progress &progress) {
  return Flipping(mesh, detail, progress).run();
}

} // namespace vbm::impl
