// SPDX-License-Identifier: GPL-3.0-or-later
// Breadth-first over the faces, a piece at a time, as is common practice; edges with three or more
// sides are not crossed, for there is no telling which faces belong together there.
#include "sampling/orientation.h"

#include "core/progress.h"
#include "sampling/tolerances.h"

namespace vbm::impl {
namespace {

class Propagation {
public:
  Propagation(TriangleMesh &mesh, const std::vector<Vec3> &position, Progress &progress)
      : mesh_(mesh), position_(position), progress_(progress), sign_(mesh.triangle.size(), 0) {}

  /// Find every face's sign: faces of equal sign in a piece agree. False if that cannot be.
  bool run(std::vector<int32_t> &to_turn) {
    for (std::size_t seed = 0; seed < sign_.size(); ++seed) {
      if (sign_[seed]) continue;
      if (!spread(static_cast<int32_t>(seed))) return false;
      if (contradictions_) choose(to_turn);
    }
    return true;
  }

private:
  bool spread(int32_t seed) {
    piece_.assign(1, seed);
    sign_[seed] = 1;
    contradictions_ = 0;
    closed_ = true;
    for (std::size_t next = 0; next < piece_.size(); ++next) {
      if ((next & 255) == 0) progress_.tick(0, 1);
      const int32_t t = piece_[next];
      for (int32_t s = 3 * t; s < 3 * t + 3; ++s) {
        const Edge &e = mesh_.edge[mesh_.edge_of_side[s]];
        if (e.faces() != 2) {
          closed_ = false;
          continue;
        }
        const int32_t there =
            mesh_.side[e.begin] == s ? mesh_.side[e.begin + 1] : mesh_.side[e.begin];
        const bool agree = mesh_.direction(s) != mesh_.direction(there);
        const int8_t wanted = static_cast<int8_t>(agree ? sign_[t] : -sign_[t]);
        contradictions_ += !agree;
        int8_t &sign = sign_[there / 3];
        if (sign == 0) {
          sign = wanted;
          piece_.push_back(there / 3);
        } else if (sign != wanted) {
          return false;
        }
      }
    }
    return true;
  }

  void choose(std::vector<int32_t> &to_turn) {
    double area[2] = {0, 0}, volume = 0; // volume: with the faces of sign -1 turned
    const Vec3 origin = position_[mesh_.triangle[piece_[0]][0]];
    for (int32_t t : piece_) {
      const Triangle &v = mesh_.triangle[t];
      const Vec3 a = position_[v[0]] - origin, b = position_[v[1]] - origin,
                 c = position_[v[2]] - origin;
      area[sign_[t] < 0] += length(cross(b - a, c - a));
      volume += sign_[t] * dot(a, cross(b, c));
    }
    bool turn_positive = area[1] > area[0];
    const bool clear = area[turn_positive] >= kClearMajority * (area[0] + area[1]);
    if (closed_ && !clear) turn_positive = volume < 0;
    for (int32_t t : piece_)
      if ((sign_[t] > 0) == turn_positive) to_turn.push_back(t);
  }

  const TriangleMesh &mesh_;
  const std::vector<Vec3> &position_;
  Progress &progress_;
  std::vector<int8_t> sign_;
  std::vector<int32_t> piece_;
  std::size_t contradictions_ = 0;
  bool closed_ = true;
};

} // namespace

Orientation make_consistent(TriangleMesh &mesh, const std::vector<Vec3> &position, bool turn,
                            Progress &progress) {
  Orientation result;
  std::size_t contradictions = 0;
  for (const Edge &e : mesh.edge) {
    if ((e.begin & 1023) == 0) progress.tick(0, 1);
    const bool contradiction = e.faces() == 2 && e.balance != 0;
    contradictions += contradiction;
    result.inconsistent_edges += contradiction || e.faces() > 2;
  }
  if (contradictions == 0) return result;
  std::vector<int32_t> to_turn;
  result.orientable = Propagation(mesh, position, progress).run(to_turn);
  if (!result.orientable || !turn) return result;
  for (int32_t t : to_turn) mesh.turn(t);
  result.turned_edges = contradictions;
  return result;
}

} // namespace vbm::impl
