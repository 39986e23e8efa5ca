// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of the medial axis as ratios to CGAL's bare triangulations of the same points, all in one
// process, interleaved, the median of several rounds. It measures and passes no judgement: it
// always ends with 0 unless it cannot run.
//   vbm_bench_axis [--repeat N] [--small] [MODEL.obj]
#include "bare.h"
#include "clock.h"
#include "meshes.h"

#include <vbm/vbm.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace bench;

constexpr double kAxisGoal = 1, kPruneGoal = 0.3, kChainGoal = 1; // ratios
constexpr double kAgainGoal = 0.05; // seconds, on the smaller model: pruning with other thresholds
constexpr double kDragGoal = 0.1;   // the same with the axis built anew
constexpr double kSurfaceGoal = 1;  // the surface then

/// The scheme of thesis 7.7 for a bunny of middle detail: 2 x 5 triangles, 1 %, then `last`.
vbm::Axis prune(vbm::Context &context, const vbm::Axis &axis, double last) {
  const auto step = [&](const vbm::Axis &from, vbm_measure measure, double threshold,
                        int32_t iterations) {
    vbm::PruneOptions options;
    options.measure = measure;
    options.threshold = threshold;
    options.iterations = iterations;
    return from.prune(context, options);
  };
  return step(step(step(axis, VBM_MEASURE_TRIANGLES, 5, 2), VBM_MEASURE_VOLUME, 0.01, 1),
              VBM_MEASURE_VOLUME, last, 1);
}

struct Task {
  const char *name;
  std::function<void()> work;
  std::vector<Seconds> runs;
  Seconds median() const { return runs[runs.size() / 2]; } // once sorted
};

void print(const char *name, Seconds value, double goal, bool seconds = false) {
  std::printf("  %-46s %8.3f %8.3f%s", name, value.cpu, value.wall, seconds ? " s" : "");
  if (goal > 0) std::printf("   goal <= %.4g: %s", goal, value.cpu <= goal ? "pass" : "over");
  std::printf("\n");
}

void run(const Mesh &mesh, int repeat, bool interactive) {
  const vbm::View<double, 3> points{mesh.points.data(), mesh.point_count()};
  vbm::Context context;
  const vbm::Model model = vbm::build_points(context, points);
  const std::vector<double> samples(model.samples().data,
                                    model.samples().data + 3 * model.samples().size),
      centers(model.centers().data, model.centers().data + 3 * model.centers().size),
      radii(model.radii().begin(), model.radii().end());
  std::optional<vbm::Axis> axis, pruned;
  std::vector<Task> tasks = {
      {"CGAL: Delaunay", [&] { bare_delaunay(samples); }, {}},
      {"CGAL: regular, of all poles", [&] { bare_regular(centers, radii); }, {}},
      {"axis + parts", [&] { axis.emplace(vbm::medial_axis(context, model)); }, {}},
      {"pruning, 2 x 5 triangles, 1 %, 5 %",
       [&] { pruned.emplace(prune(context, *axis, .05)); },
       {}},
      {"pruning again, 2 x 5 triangles, 1 %, 10 %", [&] { prune(context, *axis, .1); }, {}},
      {"surface", [&] { pruned->surface(context); }, {}},
      {"samples to simplified surface",
       [&] {
         const vbm::Model built = vbm::build_points(context, points);
         const vbm::Axis whole = vbm::medial_axis(context, built);
         prune(context, whole, .05).surface(context);
       },
       {}}};
  for (int round = 0; round < repeat; ++round)
    for (Task &task : tasks) {
      const Seconds start = now();
      task.work();
      task.runs.push_back(now() - start);
    }
  for (Task &task : tasks)
    std::sort(task.runs.begin(), task.runs.end(),
              [](const Seconds &a, const Seconds &b) { return a.cpu < b.cpu; });

  std::printf("%s: %zu points, %zu polar balls (%s)\n", mesh.name.c_str(), points.size,
              radii.size(), mesh.source.c_str());
  const vbm_axis_report whole = axis->report(), left = pruned->report();
  std::printf("  axis: %llu triangles, %llu parts; pruned: %llu triangles, %llu parts\n",
              (unsigned long long)whole.triangles, (unsigned long long)whole.parts,
              (unsigned long long)left.triangles, (unsigned long long)left.parts);
  std::printf("  %-46s %8s %8s\n", "", "CPU", "wall");
  for (const Task &task : tasks) print(task.name, task.median(), 0, true);
  const auto ratio = [](Seconds a, Seconds b) { return Seconds{a.cpu / b.cpu, a.wall / b.wall}; };
  const Seconds delaunay = tasks[0].median(), regular = tasks[1].median();
  print("axis + parts / Delaunay", ratio(tasks[2].median(), delaunay), kAxisGoal);
  print("pruning / Delaunay", ratio(tasks[3].median(), delaunay), kPruneGoal);
  print("chain / (Delaunay + regular)",
        ratio(tasks[6].median(), {delaunay.cpu + regular.cpu, delaunay.wall + regular.wall}),
        kChainGoal);
  if (interactive) {
    print("pruning again", tasks[4].median(), kAgainGoal, true);
    print("a threshold moved: parts and pruning", tasks[4].median(), kDragGoal, true);
    print("a threshold moved: surface", tasks[5].median(), kSurfaceGoal, true);
  }
  std::printf("\n");
  std::fflush(stdout);
}

int usage() {
  std::fprintf(stderr, "vbm_bench_axis [--repeat N] [--small] [MODEL.obj]\n"
                       "  --repeat N  rounds, of which the median counts; default 3\n"
                       "  --small     without the model subdivided twice\n");
  return 2;
}

} // namespace

int main(int argc, char **argv) {
  int repeat = 3;
  bool small = false;
  std::string path;
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "--small"))
      small = true;
    else if (!std::strcmp(argv[i], "--repeat") && i + 1 < argc)
      repeat = std::max(1, std::atoi(argv[++i]));
    else if (argv[i][0] != '-' && path.empty())
      path = argv[i];
    else
      return usage();
  }
  try {
    const Mesh mesh = path.empty() ? bench::bunny() : read_obj(path);
    std::printf("libvbm %s, median of %d rounds\n\n", vbm_version(), repeat);
    run(mesh, repeat, true);
    if (small) return 0;
    Mesh large = subdivide(subdivide(mesh));
    large.name += " subdivided twice";
    run(large, repeat, false);
  } catch (const std::exception &e) {
    std::fprintf(stderr, "vbm_bench_axis: %s\n", e.what());
    return 1;
  }
}
