// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of clustering, against its goals: 7,000 balls in 0.1 s, 100,000 in 5 s. It measures and
// passes no judgement: it always ends with 0 unless it cannot run.
//   vbm_bench_cluster [MODEL.obj]
#include "clock.h"
#include "meshes.h"

#include <vbm/vbm.hpp>

#include <cstdio>
#include <exception>
#include <vector>

namespace {

struct Balls {
  std::vector<double> centers, radii;
};

/// About so many of them: every so-manieth.
Balls some(const Balls &all, std::size_t count) {
  Balls out;
  const double step = double(all.radii.size()) / double(count);
  for (double at = 0; at < double(all.radii.size()); at += step > 1 ? step : 1) {
    const std::size_t i = std::size_t(at);
    out.radii.push_back(all.radii[i]);
    out.centers.insert(out.centers.end(), &all.centers[3 * i], &all.centers[3 * i] + 3);
  }
  return out;
}

void line(const char *name, const Balls &balls, const vbm::ClusterOptions &options, double goal) {
  vbm::Context context;
  const bench::Seconds start = bench::now();
  const vbm::Clusters clusters =
      vbm::cluster_balls(context, {balls.centers.data(), balls.radii.size()},
                         {balls.radii.data(), balls.radii.size()}, options);
  const double seconds = (bench::now() - start).cpu;
  const bench::Seconds again = bench::now();
  const vbm_cluster_error error = clusters.measure(context, 20000);
  const double measuring = (bench::now() - again).cpu;
  std::printf("  %-26s %8zu %8zu %9.3f %9.3f %11.4g %11.4g %11.4g", name, balls.radii.size(),
              clusters.radii().size, seconds, measuring, clusters.report().gap, error.outward,
              error.inward);
  if (goal > 0) std::printf("   goal <= %g s: %s", goal, seconds <= goal ? "pass" : "over");
  std::printf("\n");
}

void table(const Balls &balls, double goal) {
  for (const int32_t measure : {VBM_CLUSTER_ENCLOSING, VBM_CLUSTER_UNION}) {
    const bool enclosing = measure == VBM_CLUSTER_ENCLOSING;
    for (const double sphericity : {.95, .8, .5}) {
      vbm::ClusterOptions options;
      options.sphericity = sphericity;
      options.measure = measure;
      char name[64];
      std::snprintf(name, sizeof name, "%s, %.2f", enclosing ? "enclosing" : "union", sphericity);
      line(name, balls, options, enclosing ? goal : 0);
    }
    vbm::ClusterOptions options;
    options.count = 300;
    options.measure = measure;
    line(enclosing ? "enclosing, the best 300" : "union, the best 300", balls, options,
         enclosing ? goal : 0);
  }
}

int run(int argc, char **argv) {
  const bench::Mesh mesh = argc > 1 ? bench::read_obj(argv[1]) : bench::bunny();
  vbm::Context context;
  vbm::BuildOptions all_balls;
  all_balls.balls = VBM_BALLS_VORONOI;
  std::printf("%s\n  %-26s %8s %8s %9s %9s %11s %11s %11s\n", mesh.name.c_str(), "CPU seconds",
              "balls", "clusters", "cluster", "measure", "gap", "outward", "inward");
  for (const bool polar : {true, false}) {
    const vbm::Model model =
        vbm::build_points(context, {mesh.points.data(), mesh.point_count()},
                          {}, polar ? vbm::BuildOptions() : all_balls);
    Balls balls;
    balls.centers.assign(model.centers().data, model.centers().data + 3 * model.inner_count());
    balls.radii.assign(model.radii().data, model.radii().data + model.inner_count());
    if (polar) table(some(balls, 7000), .1);
    table(polar ? balls : some(balls, 100000), polar ? 0 : 5);
  }
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
