// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of surfaces from balls, as ratios to CGAL's bare regular triangulation of the same balls in
// the same process, of singular-point surfaces the median of several rounds that take turns; and
// CGAL's own skin surface on demand. Ratios are of the time one waits, and of processor time: calls use as many threads as
// there are processors, unless told otherwise. It measures and passes no judgement: it always ends
// with 0 unless it cannot run.
//   vbm_bench_balls [--repeat N] [--threads N] [--skin] [MODEL.obj | BALLS.csv ...]
// A CSV file has a ball a line: x, y, z and radius, after a line of names.
#include "bare.h"
#include "bare_skin.h"
#include "clock.h"
#include "meshes.h"

#include <vbm/vbm.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr double kGoal = 1.5; // times the regular triangulation, of the singular-point surface

struct Balls {
  std::string name;
  std::vector<double> centers, radii;
};

Balls polar_balls(const bench::Mesh &mesh) {
  vbm::Context context;
  const vbm::Model model = vbm::build_points(context, {mesh.points.data(), mesh.point_count()});
  Balls balls{mesh.name, {}, {}};
  balls.centers.assign(model.centers().data, model.centers().data + 3 * model.inner_count());
  balls.radii.assign(model.radii().data, model.radii().data + model.inner_count());
  return balls;
}

Balls read_csv(const std::string &path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  Balls balls{path, {}, {}};
  std::string line;
  std::getline(file, line);
  double v[4];
  while (std::getline(file, line)) {
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &v[0], &v[1], &v[2], &v[3]) != 4)
      throw std::runtime_error(path + ": no ball in " + line);
    balls.centers.insert(balls.centers.end(), v, v + 3);
    balls.radii.push_back(v[3]);
  }
  return balls;
}

double median(std::vector<double> of) {
  std::sort(of.begin(), of.end());
  return of[of.size() / 2];
}

/// Medians of several rounds: of seconds, and of their ratios to what is compared with.
struct Medians {
  double wall, ratio, cpu_ratio;
};

Medians measure(int repeat, const std::function<void()> &work, const std::function<void()> &bare) {
  std::vector<double> wall, ratio, cpu_ratio;
  for (int i = 0; i < repeat; ++i) {
    const bench::Seconds start = bench::now();
    bare();
    const bench::Seconds middle = bench::now();
    work();
    const bench::Seconds took = bench::now() - middle, compared = middle - start;
    wall.push_back(took.wall);
    ratio.push_back(took.wall / compared.wall);
    cpu_ratio.push_back(took.cpu / compared.cpu);
  }
  return {median(wall), median(ratio), median(cpu_ratio)};
}

void table(const Balls &balls, int repeat, int threads, bool skin) {
  const auto bare = [&] { bench::bare_regular(balls.centers, balls.radii); };
  const Medians alone = measure(repeat, bare, bare);
  std::printf("%s: %zu balls; CGAL's regular triangulation %.3f s\n", balls.name.c_str(),
              balls.radii.size(), alone.wall);
  std::printf("  %-18s %9s %9s %9s %6s %6s %8s %8s %8s\n", "", "polygons", "a ball", "triangles",
              "comp.", "genus", "s", "ratio", "of CPU");
  for (int32_t style = VBM_BALL_STYLE_SINGULAR_POINTS; style <= VBM_BALL_STYLE_POWER_CRUST;
       ++style) {
    static const char *const kNames[] = {"singular points", "skin", "power crust"};
    vbm::BallSurfaceOptions options;
    options.style = style;
    vbm_surface_report report{};
    const auto work = [&] {
      vbm::Context context;
      context.set_threads(threads);
      report = vbm::surface_from_balls(context, {balls.centers.data(), balls.radii.size()},
                                       {balls.radii.data(), balls.radii.size()}, options)
                   .report();
    };
    const Medians m = measure(style == VBM_BALL_STYLE_SINGULAR_POINTS ? repeat : 1, work, bare);
    std::printf("  %-18s %9llu %9.2f %9llu %6llu %6lld %8.3f %8.2f %8.2f", kNames[style],
                static_cast<unsigned long long>(report.polygons),
                double(report.polygons) / double(balls.radii.size()),
                static_cast<unsigned long long>(report.triangles),
                static_cast<unsigned long long>(report.components),
                static_cast<long long>(report.genus), m.wall, m.ratio, m.cpu_ratio);
    if (style == VBM_BALL_STYLE_SINGULAR_POINTS)
      std::printf("   goal <= %g: %s", kGoal, m.ratio <= kGoal ? "pass" : "over");
    std::printf("\n");
    std::fflush(stdout);
  }
  if (!skin) return;
  bench::SkinSize size;
  const Medians m = measure(
      1, [&] { size = bench::bare_skin(balls.centers, balls.radii, 0.9); }, bare);
  std::printf("  %-18s %9zu %9.2f %9zu %6zu %6lld %8.3f %8.2f %8.2f\n", "CGAL's skin",
              size.triangles, double(size.triangles) / double(balls.radii.size()), size.triangles,
              size.components, static_cast<long long>(size.genus()), m.wall, m.ratio, m.cpu_ratio);
}

int run(int argc, char **argv) {
  int repeat = 15, threads = 0;
  bool skin = false, given = false;
  for (int i = 1; i < argc; ++i) {
    const std::string arg = argv[i];
    if (arg == "--repeat" && i + 1 < argc) {
      repeat = std::max(1, std::atoi(argv[++i]));
    } else if (arg == "--threads" && i + 1 < argc) {
      threads = std::atoi(argv[++i]);
    } else if (arg == "--skin") {
      skin = true;
    } else {
      given = true;
      const bool csv = arg.size() > 4 && arg.compare(arg.size() - 4, 4, ".csv") == 0;
      table(csv ? read_csv(arg) : polar_balls(bench::read_obj(arg)), repeat, threads, skin);
    }
  }
  if (!given) table(polar_balls(bench::bunny()), repeat, threads, skin);
  return 0;
}

} // namespace

int main(int argc, char **argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
