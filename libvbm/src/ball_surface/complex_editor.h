// SPDX-License-Identifier: GPL-3.0-or-later
// Moves that keep a boundary complex the surface it is.
#pragma once

#include "ball_surface/patch_complex.h"

#include <cstdint>
#include <vector>

namespace vbm::impl {

class Progress;

/// The complex as a map: darts in loops round patches. Arcs may be contracted that do not end where
/// they begin, also such as are only thought of, across a patch; a disk with one arc round it
/// becomes a point, one with two an arc. Each of these leaves a closed surface the surface it was.
class ComplexEditor {
public:
  using Dart = PatchComplex::Dart;

  /// `points` are the complex's vertices, of which the map has the first.
  ComplexEditor(PatchComplex &complex, const DualShape &shape, const BoundaryMap &map,
                MergedPoints points);

  bool alive(int32_t d) const { return alive_[d] != 0; }
  /// The vertex a dart begins at, of all that became one.
  int32_t from(int32_t d) {
    int32_t &v = complex.darts[d].from; // kept, so that it takes no search the next time
    return v = points.find(v);
  }
  int32_t to(int32_t d) { return from(complex.darts[d].twin); }

  /// Contracts a dart and its twin; false where it ends where it begins.
  bool contract(int32_t d);
  /// Contracts what would be an arc from where dart d begins to where e begins, both of a patch:
  /// of one loop of a disk, which becomes two disks, or of two loops, which become one. Returns the
  /// patch that is new, -1 if there is none.
  int32_t zip(int32_t d, int32_t e);
  /// A vertex in a dart and its twin, at an angle of its arc: they end there, and two more follow.
  int32_t split(int32_t d, double angle);
  /// The same, where the circle's own point there is known.
  int32_t split(int32_t d, double angle, const Vec3 &p);
  /// Undoes that for a vertex with two arcs: dart d, which begins there, joins the one before it.
  void join(int32_t d);

  /// Patches of one loop with one dart or two: points and arcs, while there are any on the list;
  /// mouths that are wider than `bulge` radii stay.
  void close(double bulge, Progress &progress);
  /// Puts a patch on that list if it is one.
  void look_at(int32_t patch);
  /// Its first dart, of those alive.
  int32_t dart_of(int32_t patch);

  /// Where a piece of an arc is, as its ends have been moved.
  Vec3 piece_point(int32_t d, double angle);
  /// The same, where the circle's own point is known.
  Vec3 piece_point(int32_t d, double angle, const Vec3 &p);

  /// No two arcs have the same ends after this, and none ends where it begins.
  void split_double_arcs(Progress &progress);
  /// Numbers what is left anew, and gives the samples.
  std::vector<int32_t> finish();

  PatchComplex &complex;
  const DualShape &shape;
  MergedPoints points;

private:
  void take_out(int32_t d);
  void list_first_darts();
  void fill_loop(int32_t patch);
  void trim(int32_t d);
  void close_mouth(int32_t patch, double bulge);
  void divide(PatchComplex::Arc &near, PatchComplex::Arc &far, bool forward, double angle,
              const Vec3 &p);
  const Vec3 &place(int32_t i) const {
    const std::size_t known = singular_.size();
    return std::size_t(i) < known ? singular_[i] : complex.position[std::size_t(i) - known];
  }

  const std::vector<Vec3> &singular_; // places of the map's points
  std::vector<uint8_t> alive_;
  std::vector<int32_t> first_, work_; // per patch one of its darts; patches to look at
};

} // namespace vbm::impl
