// SPDX-License-Identifier: GPL-3.0-or-later
// Bad meshes, and meshes from bad files, and the right behaviour of each.
#include "nasty.h"
#include "nasty_files.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace nasty;

namespace {

const double kPi = std::acos(-1.0);

Expect flat(const std::string &what) { return fails(VBM_ERROR_DEGENERATE, {what, "dimension"}); }

/// A volume in the file's units, for bounding boxes of the given sides.
Expect volume_in(double value, double x, double y, double z, double relative) {
  const double diagonal3 = std::pow(std::hypot(x, y, z), 3);
  return all({volume(value / diagonal3, relative * value / diagonal3),
              crust_volume(value / diagonal3, std::max(.05, relative) * value / diagonal3)});
}
/// From faces: the tetrahedra along the edges may be cut off.
Expect cube() { return all({solid(1, 0), volume_in(1, 1, 1, 1, 1e-3)}); }
/// From its eight corners: the crust is an octahedron round their ball.
Expect corners() { return all({solid(1, 0), volume(1 / std::sqrt(27), 1e-12)}); }
/// The polyhedron of 24 by 48 is 1 % smaller than its ball; the crust may be rounder or flatter.
Expect ball() { return all({solid(1, 0), volume_in(4 * kPi / 3, 2, 2, 2, .03)}); }

/// Boundary loops of a mesh, counted by following open edges.
int64_t loops_of(const std::string &file) {
  const Geometry g = read_geometry(nasty_folder() + "/" + file);
  std::map<std::pair<int32_t, int32_t>, int> half;
  std::size_t at = 0;
  for (uint32_t n : g.sizes) {
    for (uint32_t i = 0; i < n; ++i) ++half[{g.corners[at + i], g.corners[at + (i + 1) % n]}];
    at += n;
  }
  // Open vertices joined by open edges: as many loops as groups, where no vertex has four.
  std::map<int32_t, int32_t> parent;
  const auto find = [&](int32_t v) {
    while (parent[v] != v) v = parent[v];
    return v;
  };
  for (const auto &[e, n] : half)
    if (!half.count({e.second, e.first})) parent[e.first] = e.first, parent[e.second] = e.second;
  for (const auto &[e, n] : half)
    if (!half.count({e.second, e.first})) parent[find(e.first)] = find(e.second);
  int64_t loops = 0;
  for (const auto &[v, p] : parent) loops += v == p;
  return loops;
}

Expect open(uint64_t loops) {
  return all({report(&vbm_model_report::open_loops, loops),
              notes({"open", std::to_string(loops) + " boundary loop"})});
}
Expect open_by_count(const std::string &file) {
  return [=](const Outcome &o) {
    // Loops that touch at a vertex may be counted as one or as several.
    const int64_t loops = loops_of(file);
    return o.report.open_loops >= uint64_t(loops) && o.report.open_loops <= 2 * uint64_t(loops)
               ? testing::AssertionSuccess()
               : testing::AssertionFailure() << o.report.open_loops << " open loops, not " << loops;
  };
}

/// Two balls of radius 1 at distance d, together.
double union_of_balls(double d) { return 8 * kPi / 3 - kPi * (4 + d) * (2 - d) * (2 - d) / 12; }

std::vector<Case> meshes() {
  const auto u64 = [](uint64_t n) { return n; };
  using R = vbm_model_report;
  const double ball_volume = 4 * kPi / 3;
  const double far = std::hypot(.8, .1, .2);
  return {
      {"mesh/m00_empty.off", flat("0 points"), flat("0 samples")},
      {"mesh/m01_cube.off", corners(), all({cube(), report(&R::flipped, 0)})},
      {"mesh/m02_cube_inverted.off", corners(),
       all({cube(), report(&R::flipped, 1), notes({"inside out"})})},
      {"mesh/m03_cube_halfinverted.off", corners(), all({cube(), notes({"contradicting"})})},
      {"mesh/m04_sphere_hole1.off", ball(), all({ball(), open(1)})},
      {"mesh/m05_hemisphere.off",
       {},
       either({all({works(), open(1)}), fails(VBM_ERROR_NO_INTERIOR, {"open"})})},
      {"mesh/m06_holes10pct.off", ball(),
       all({ball(), open_by_count("mesh/m06_holes10pct.off"), notes({"open", "boundary loops"})})},
      {"mesh/m07_touch_vertex.off", {}, all({solid(2, 0), volume_in(2, 2, 2, 2, 1e-3)})},
      {"mesh/m08_touch_edge.off",
       {},
       all({works(), volume_in(2, 2, 2, 1, 1e-3), notes({"three or more faces"})})},
      {"mesh/m09_book3.off",
       {},
       either({all({works(), notes({"three or more"})}), fails(VBM_ERROR_NO_INTERIOR)})},
      {"mesh/m10_moebius.off",
       {},
       either({all({works(), notes({"not orientable"}), notes({"open"})}),
               fails(VBM_ERROR_NO_INTERIOR)})},
      // Vertices of the two sheets that cross are one to rounding: they branch along a circle.
      {"mesh/m11_klein.off",
       {},
       either({all({works(), notes({"not orientable"})}),
               all({works(), notes({"three or more faces"})}), fails(VBM_ERROR_NO_INTERIOR)})},
      {"mesh/m12_nested_alt.off",
       {},
       all({solid(3, 0), volume_in(ball_volume * (1 - .343 + .064), 2, 2, 2, .06)})},
      {"mesh/m13_nested_same.off",
       {},
       all({solid(1, 0), volume_in(ball_volume, 2, 2, 2, .06), notes({"at least once"})})},
      {"mesh/m14_overlap.off",
       {},
       all({solid(1, 0), volume_in(union_of_balls(far), 2.8, 2.1, 2.2, .06),
            notes({"at least once"})})},
      {"mesh/m15_doubled.off",
       {},
       all({solid(1, 0), volume_in(ball_volume, 2, 2, 2, .06), report(&R::merged, u64(482))})},
      {"mesh/m16_flat_sheet.off", flat("400 points"), flat("")},
      {"mesh/m17_two_sided_sheet.off", flat("400 points"), flat("")},
      {"mesh/m18_1000_tets.off", {}, solid(1000, 0)},
      {"mesh/m19_needles.off", {}, either({works(), fails(VBM_ERROR_DEGENERATE)})},
      {"mesh/m20_degenerate.off",
       {},
       all({ball(), report(&R::skipped_faces, u64(4)), report(&R::dropped, u64(1)), notes({"4"})})},
      {"mesh/m21_out_of_range.off", ball(),
       all({fails(VBM_ERROR_INPUT, {"face 2208", "999999"}), names("face", {2208, 2209}, 2)})},
      {"mesh/m22_ngon.off", flat("5000 points"), flat("")},
      {"mesh/m23_tjunction.off", {}, cube()},
      {"mesh/m24_internal_wall.off", {}, all({cube(), open(1)})},
      {"mesh/m25_spikes.off", {}, works()},
      {"mesh/m26_thin_shell.off",
       {},
       either({all({works(), undersampled(), notes({"too thin"})}), fails(VBM_ERROR_NO_INTERIOR)})},
      {"mesh/m27_long_thin.off", {}, works()},
  };
}

std::vector<Case> files() {
  const Expect tetrahedron = all({solid(1, 0), volume_in(1 / 6., 1, 1, 1, 1e-3)});
  const Expect four_points = all({solid(1, 0), volume(1 / 6. / std::sqrt(27), 1e-12)});
  std::vector<Case> out;
  for (const char *file : {"f04_crlf.off", "f05_cr.off", "f06_bom.obj", "f12_neg_index.obj",
                           "f18_long_line.obj", "f20_trailing_garbage.off"})
    out.push_back({std::string("file/") + file, four_points, tetrahedron});
  out.push_back({"file/f08_dot_under_comma_locale.obj", solid(1, 0),
                 all({solid(1, 0), volume_in(1.5 / 6, 1.5, 1, 1, 2e-3)})});
  const Expect bad = all({fails(VBM_ERROR_INPUT, {"vertex 1"}), names("vertex", {1}, 1)});
  out.push_back({"file/f13_text_nan.obj", bad, bad});
  out.push_back({"file/f21_lines_only.obj", flat("3 points"), flat("0")});
  out.push_back({"file/f22_points_only.obj", ball(), flat("0")});
  for (const std::string &file : nasty_index("names/"))
    out.push_back({file, four_points, tetrahedron});
  return out;
}

/// Files of no geometry, or of other formats than the reader's own: it refuses them, with a line.
const std::set<std::string> kUnreadable = {"f01_zero_bytes.obj",      "f02_zero_bytes.ply",
                                           "f03_zero_bytes.stl",      "f07_comma.obj",
                                           "f09_truncated.off",       "f10_count_lies.off",
                                           "f11_negative_count.off",  "f14_coff.obj",
                                           "f15_png_named.off",       "f16_solid_binary.stl",
                                           "f17_stl_count_short.stl", "f19_nul.obj",
                                           "f23_big_endian.ply",      "f24_truncated.ply",
                                           "f25_list_bomb.ply",       "f26_header_unended.ply",
                                           "f27_gz.off.gz",           "f28_face0.obj"};

class Meshes : public testing::TestWithParam<Case> {};

TEST_P(Meshes, BehavesAsStated) { run_case(GetParam()); }

std::string name(const testing::TestParamInfo<Case> &info) {
  std::string file = info.param.file.substr(info.param.file.find('/') + 1);
  file = file.substr(0, file.rfind('.'));
  return file.substr(0, file.find_first_of(" -'\"")); // the file's own name may be anything
}

INSTANTIATE_TEST_SUITE_P(Nasty, Meshes, testing::ValuesIn(meshes()), name);

TEST(NastyFiles, BehaveAsStated) {
  for (const Case &c : files()) {
    SCOPED_TRACE(c.file);
    run_case(c);
  }
}

TEST(NastyFiles, AreRefusedWithALine) {
  if (nasty_folder().empty())
    GTEST_SKIP() << "no nasty/make_nasty.py in the folder that VBM_SHARED names";
  for (const std::string &file : kUnreadable) try {
      read_geometry(nasty_folder() + "/file/" + file);
      ADD_FAILURE() << file << " was read";
    } catch (const std::runtime_error &error) {
      EXPECT_EQ(std::string(error.what()).rfind("line ", 0), 0u) << error.what();
    }
}

TEST(NastyMeshes, TablesAreComplete) {
  if (nasty_folder().empty())
    GTEST_SKIP() << "no nasty/make_nasty.py in the folder that VBM_SHARED names";
  std::set<std::string> known;
  for (const Case &c : meshes()) known.insert(c.file);
  for (const Case &c : files()) known.insert(c.file);
  for (const std::string &file : kUnreadable) known.insert("file/" + file);
  for (const char *prefix : {"mesh/", "file/", "names/"})
    for (const std::string &file : nasty_index(prefix)) EXPECT_EQ(known.count(file), 1u) << file;
}

} // namespace
