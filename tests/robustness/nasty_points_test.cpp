// SPDX-License-Identifier: GPL-3.0-or-later
// Bad point sets, and the right behaviour of each.
#include "host.h"
#include "nasty.h"
#include "nasty_files.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace nasty;

namespace {

const double kPi = std::acos(-1.0);

/// Too few points, or points that do not span space: with their number and dimension.
Expect flat(const std::string &count) { return fails(VBM_ERROR_DEGENERATE, {count, "dimension"}); }
/// Points that rounding alone lifts out of a line or plane: refused, or the result is flagged.
Expect nearly_flat(const std::string &count) {
  return either({flat(count), all({works(), undersampled(), notes({"too thin"})})});
}
/// Quadratically many tetrahedra: a stated limit, or done.
Expect within_budget() {
  return either({works(), fails(VBM_ERROR_LIMIT, {"limit"}), fails(VBM_ERROR_NO_INTERIOR)});
}

/// The lat-long sphere of most of these files: 1,106 points, which are all on the surface. Its
/// volume is that of the polyhedron, as a share of the diagonal cubed.
Expect sphere() {
  const shapes::Shape s = shapes::sphere_mesh(24, 48);
  double volume6 = 0;
  for (std::size_t f = 0; f < s.faces(); ++f) {
    const shapes::Vec a = s.at(std::size_t(s.triangles[3 * f])),
                      b = s.at(std::size_t(s.triangles[3 * f + 1])),
                      c = s.at(std::size_t(s.triangles[3 * f + 2]));
    volume6 += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  const double share = volume6 / 6 / std::pow(12, 1.5);
  return all({solid(1, 0), volume(share, 1e-9 * share), crust_volume(share, .005 * share),
              report(&vbm_model_report::samples, uint64_t(1106)), [](const Outcome &o) {
                return o.surface.triangles == 2208 && o.surface.vertices == 1106
                           ? testing::AssertionSuccess()
                           : testing::AssertionFailure()
                                 << o.surface.triangles << " triangles of " << o.surface.vertices
                                 << " vertices, not the sphere's 2208 of 1106";
              }});
}
/// As the unit case, but to coarse coordinates' precision.
Expect rounded_sphere() {
  const double share = kPi * 4 / 3 / std::pow(12, 1.5);
  return all({solid(1, 0), volume(share, .02 * share), crust_volume(share, .02 * share)});
}

Expect few_balls(uint64_t most) {
  return [=](const Outcome &o) {
    return o.report.inner_balls <= most
               ? testing::AssertionSuccess()
               : testing::AssertionFailure() << o.report.inner_balls << " inner balls";
  };
}

Expect merged(uint64_t count) { return report(&vbm_model_report::merged, count); }

std::vector<Case> cases() {
  std::vector<Case> out = {
      {"pts/p00_empty.xyz", flat("0 points")},
      {"pts/p01_one.xyz", flat("1 point")},
      {"pts/p02_two.xyz", flat("2 points")},
      {"pts/p03_three.xyz", flat("3 points")},
      {"pts/p04_tet.xyz", all({solid(1, 0), few_balls(1)})},
      {"pts/p05_same1000.xyz", flat("1000 points")},
      {"pts/p06_collinear.xyz", flat("1000 points")},
      {"pts/p07_collinear_skew.xyz", nearly_flat("1000 points")},
      {"pts/p08_coplanar_grid.xyz", flat("1024 points")},
      {"pts/p09_coplanar_skew.xyz", nearly_flat("2000 points")},
      {"pts/p10_cocircular.xyz", flat("1000 points")},
      {"pts/p11_sphere_fib.xyz", all({solid(1, 0), few_balls(1)})},
      {"pts/p12_integer_sphere.xyz", all({solid(1, 0), few_balls(1)})},
      // Solid lattices: no surface was sampled, so any closed result is right, or none.
      {"pts/p13_grid20.xyz", either({works(), fails(VBM_ERROR_NO_INTERIOR)})},
      {"pts/p13_grid60.xyz", either({works(), fails(VBM_ERROR_NO_INTERIOR)}), {}, false, true},
      {"pts/p14_two_lines.xyz", within_budget(), {}, false, true},
      {"pts/p15_moment_curve.xyz", within_budget(), {}, false, true},
      {"pts/p16_cube8.xyz", all({solid(1, 0), few_balls(1), volume(1 / std::sqrt(27), 1e-12)})},
      {"pts/q02_allnan.xyz", all({fails(VBM_ERROR_INPUT, {"vertex 0", "100"}),
                                  [](const Outcome &o) {
                                    return o.bad.size() == 100 && o.bad_total == 100
                                               ? testing::AssertionSuccess()
                                               : testing::AssertionFailure()
                                                     << o.bad.size() << " of " << o.bad_total;
                                  }})},
      {"pts/q02_allnan.xyz", fails(VBM_ERROR_DEGENERATE, {"0 different"}), {}, true},
      {"pts/q04_denormal.xyz", sphere()},
      // All but one of these points are the same once the whole is of unit size.
      {"pts/q05_max.xyz", either({works(), fails(VBM_ERROR_DEGENERATE, {"1106", "dimension"})})},
      {"pts/q06_offset_1e6.xyz", rounded_sphere()},
      {"pts/q06_offset_1e8.xyz", rounded_sphere()},
      {"pts/q06_offset_1e12.xyz", rounded_sphere()},
      {"pts/q06_offset_1e15.xyz",
       all({works(), notes({"distance from the origin"}),
            [](const Outcome &o) {
              return o.report.merged > 0
                         ? testing::AssertionSuccess()
                         : testing::AssertionFailure() << "rounding made duplicates, none counted";
            }})},
      {"pts/q07_mixed_scale.xyz", works()},
      {"pts/q08_float32.xyz", rounded_sphere()},
      // Five times the origin, with both signs of zero: one point, in the middle of the sphere.
      {"pts/q09_negzero.xyz", all({works(), merged(4)})},
      {"pts/q10_near_coplanar.xyz", nearly_flat("2000 points")},
      {"pts/q11_ulp_sphere.xyz", all({solid(1, 0), few_balls(1)})},
      {"pts/d01_dup2.xyz", all({sphere(), merged(1106)})},
      // The sphere's cap, every point a hundred times.
      {"pts/d02_dup100.xyz", all({works(), merged(19800)})},
      {"pts/d03_neardup.xyz", all({sphere(), merged(1106)})},
  };
  for (const char *e :
       {"-300", "-160", "-100", "-20", "-9", "+9", "+20", "+100", "+150", "+160", "+300"})
    out.push_back({std::string("pts/q03_scale_1e") + e + ".xyz", sphere()});
  for (const char *value : {"nan", "inf", "neginf"}) {
    const std::string file = std::string("pts/q01_") + value + ".xyz";
    out.push_back({file, all({fails(VBM_ERROR_INPUT, {"vertex 100"}), names("vertex", {100}, 1)})});
    out.push_back({file,
                   all({solid(1, 0), report(&vbm_model_report::dropped, uint64_t(1)),
                        notes({"1 ", "not finite"})}),
                   {},
                   true});
  }
  return out;
}

class NastyPoints : public testing::TestWithParam<Case> {};

TEST_P(NastyPoints, BehavesAsStated) { run_case(GetParam()); }

std::string name(const testing::TestParamInfo<Case> &info) {
  std::string file = info.param.file.substr(4);
  file = file.substr(0, file.rfind('.')) + (info.param.drop_invalid ? "_dropped" : "");
  std::replace(file.begin(), file.end(), '-', 'm');
  std::replace(file.begin(), file.end(), '+', 'p');
  return file;
}

INSTANTIATE_TEST_SUITE_P(All, NastyPoints, testing::ValuesIn(cases()), name);

TEST(NastyPointFiles, TableIsComplete) {
  if (nasty_folder().empty())
    GTEST_SKIP() << "no nasty/make_nasty.py in the folder that VBM_SHARED names";
  std::set<std::string> known;
  for (const Case &c : cases()) known.insert(c.file);
  for (const std::string &file : nasty_index("pts/")) EXPECT_EQ(known.count(file), 1u) << file;
  EXPECT_EQ(known.size(), nasty_index("pts/").size());
}

TEST(NastyPointFiles, CommaLocaleIsThere) {
  if (!have_comma_locale()) GTEST_SKIP() << "no locale de_DE.UTF-8: nothing ran in it";
}

} // namespace
