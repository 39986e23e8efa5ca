// SPDX-License-Identifier: GPL-3.0-or-later
// Speed and memory of the main job as ratios to CGAL's bare triangulations of the same points, all
// in one process, interleaved, the median of several rounds. It measures and passes no judgement:
// it always ends with 0 unless it cannot run.
//   vbm_bench_speed [--repeat N] [--small] [--points] [MODEL.obj]
#include "bare.h"
#include "clock.h"
#include "memory.h"
#include "meshes.h"

#include <vbm/vbm.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace bench;

constexpr double kSurfaceGoal = 3, kCrustGoal = 1.3,
                 kCrustAim = 0.6; // times the bare triangulations
constexpr double kMemoryGoal = 2;
constexpr double kMegabytesGoal = 1500; // of the larger model

/// Processor seconds of every stage of a call, in the order they came, and the longest time between
/// two reports, which is what a user who cancels waits for.
class Stages {
public:
  void attach(vbm::Context &context) {
    context.set_progress([this](double, const char *name) {
      heard(now().cpu);
      if (list_.empty() || list_.back().first != name) begin(name);
      return false;
    });
  }
  void begin(const std::string &name) {
    const double t = now().cpu;
    if (!list_.empty()) list_.back().second += t;
    list_.push_back({name, -t});
  }
  void end() { begin(""); }
  void print() const {
    std::printf("    stages:");
    for (std::size_t i = 0; i + 1 < list_.size(); ++i)
      std::printf("%s %s %.2f", i ? "," : "", list_[i].first.c_str(), list_[i].second);
    std::printf("\n    longest time between two reports: %.0f ms, in: %s\n", 1000 * silence_,
                silent_.c_str());
  }

private:
  void heard(double time) {
    if (!list_.empty() && time - last_ > silence_) {
      silence_ = time - last_;
      silent_ = list_.back().first;
    }
    last_ = time;
  }

  std::vector<std::pair<std::string, double>> list_;
  std::string silent_; // the stage of the longest silence
  double last_ = 0, silence_ = 0;
};

struct Task {
  std::string name;
  std::function<void(Stages &)> work;
  double megabytes = 0;
  std::vector<std::pair<Seconds, Stages>> runs;

  Seconds median() const { return runs[runs.size() / 2].first; } // once sorted
};

vbm::Model build(vbm::Context &context, const Mesh &mesh, bool faces) {
  const vbm::View<double, 3> points{mesh.points.data(), mesh.point_count()};
  if (!faces) return vbm::build_points(context, points);
  return vbm::build_mesh(context, points,
                         vbm::View<int32_t, 3>{mesh.triangles.data(), mesh.triangle_count()});
}

void measure(std::vector<Task> &tasks, int repeat) {
  for (Task &task : tasks)
    task.megabytes = peak_megabytes([&] {
      Stages stages;
      task.work(stages);
    });
  for (int round = 0; round < repeat; ++round)
    for (Task &task : tasks) {
      Stages stages;
      const Seconds start = now();
      task.work(stages);
      task.runs.push_back({now() - start, stages});
    }
  for (Task &task : tasks)
    std::sort(task.runs.begin(), task.runs.end(),
              [](const auto &a, const auto &b) { return a.first.cpu < b.first.cpu; });
}

void print_task(const Task &task) {
  const Seconds s = task.median();
  std::printf("  %-42s %8.2f %8.2f %8.0f\n", task.name.c_str(), s.cpu, s.wall, task.megabytes);
}

void print_ratio(const char *name, double cpu, double wall, double goal, double aim) {
  std::printf("  %-42s %8.2f %8.2f", name, cpu, wall);
  if (goal > 0) std::printf("   goal <= %.4g: %s", goal, cpu <= goal ? "pass" : "over");
  if (aim > 0) std::printf("   aim <= %.4g: %s", aim, cpu <= aim ? "pass" : "over");
  std::printf("\n");
}

void print_memory(const char *name, double ratio, double goal) {
  std::printf("  %-42s %8s %8s %8.2f", name, "", "", ratio);
  if (goal > 0) std::printf("   goal <= %.4g: %s", goal, ratio <= goal ? "pass" : "over");
  std::printf("\n");
}

/// One table: a mesh with its faces, or its bare points, for which the goals are.
void run(const Mesh &mesh, bool faces, int repeat, double megabytes_goal) {
  std::vector<double> samples, centers, radii;
  {
    vbm::Context context;
    const vbm::Model model = build(context, mesh, faces);
    samples.assign(model.samples().data, model.samples().data + 3 * model.samples().size);
    centers.assign(model.centers().data, model.centers().data + 3 * model.centers().size);
    radii.assign(model.radii().begin(), model.radii().end());
  }
  std::printf("%s, %s: %zu points", mesh.name.c_str(), faces ? "with faces" : "bare points",
              mesh.point_count());
  if (faces) std::printf(", %zu triangles, %zu samples", mesh.triangle_count(), samples.size() / 3);
  std::printf(", %zu polar balls (%s)\n", radii.size(), mesh.source.c_str());
  std::printf("  %-42s %8s %8s %8s\n", "", "CPU s", "wall s", "peak MB");

  const auto ours = [&](Stages &stages, bool crust) {
    vbm::Context context;
    stages.attach(context);
    const vbm::Model model = build(context, mesh, faces);
    const vbm::Surface surface = crust ? model.power_crust(context) : model.surface(context);
    stages.end();
  };
  std::vector<double> changed(radii);
  for (std::size_t b = 0; b < changed.size(); ++b)
    changed[b] *= 1 + 1e-9 * double((b * 2654435761u) % 1024) / 1024;
  std::vector<Task> tasks(5);
  tasks[0] = {"CGAL: Delaunay", [&](Stages &) { bare_delaunay(samples); }, 0, {}};
  tasks[1] = {
      "CGAL: regular, of all poles", [&](Stages &) { bare_regular(centers, radii); }, 0, {}};
  tasks[2] = {"balls + interpolating surface", [&](Stages &s) { ours(s, false); }, 0, {}};
  tasks[3] = {"balls + power crust", [&](Stages &s) { ours(s, true); }, 0, {}};
  tasks[4] = {"CGAL: regular, radii changed by 1e-9",
              [&](Stages &) { bare_regular(centers, changed); },
              0,
              {}};
  measure(tasks, repeat);

  for (const Task &task : tasks) print_task(task);
  const Seconds d = tasks[0].median(), r = tasks[1].median(), s = tasks[2].median(),
                c = tasks[3].median();
  const double bare = std::max(tasks[0].megabytes, tasks[1].megabytes); // one after the other
  const bool goals = !faces;
  print_ratio("regular / Delaunay", r.cpu / d.cpu, r.wall / d.wall, 0, 0);
  print_ratio("regular, radii changed / Delaunay", tasks[4].median().cpu / d.cpu,
              tasks[4].median().wall / d.wall, 0, 0);
  print_ratio("surface / Delaunay", s.cpu / d.cpu, s.wall / d.wall, goals ? kSurfaceGoal : 0, 0);
  print_ratio("crust / (Delaunay + regular)", c.cpu / (d.cpu + r.cpu), c.wall / (d.wall + r.wall),
              goals ? kCrustGoal : 0, goals ? kCrustAim : 0);
  print_memory("memory: surface / Delaunay", tasks[2].megabytes / tasks[0].megabytes,
               goals ? kMemoryGoal : 0);
  print_memory("memory: crust / larger triangulation", tasks[3].megabytes / bare,
               goals ? kMemoryGoal : 0);
  if (megabytes_goal > 0)
    std::printf("  %-42s %8s %8s %8.0f   goal < %.0f: %s\n", "memory: most", "", "",
                std::max(tasks[2].megabytes, tasks[3].megabytes), megabytes_goal,
                std::max(tasks[2].megabytes, tasks[3].megabytes) < megabytes_goal ? "pass"
                                                                                  : "over");
  for (int t : {2, 3}) {
    std::printf("  %s\n", tasks[t].name.c_str());
    tasks[t].runs[tasks[t].runs.size() / 2].second.print();
  }
  std::printf("\n");
  std::fflush(stdout);
}

int usage() {
  std::fprintf(stderr, "vbm_bench_speed [--repeat N] [--small] [--points] [MODEL.obj]\n"
                       "  --repeat N  rounds, of which the median counts; default 3\n"
                       "  --small     without the model subdivided twice\n"
                       "  --points    without the runs that use the faces\n");
  return 2;
}

} // namespace

int main(int argc, char **argv) {
  int repeat = 3;
  bool small = false, points = false;
  std::string path;
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "--small"))
      small = true;
    else if (!std::strcmp(argv[i], "--points"))
      points = true;
    else if (!std::strcmp(argv[i], "--repeat") && i + 1 < argc)
      repeat = std::max(1, std::atoi(argv[++i]));
    else if (argv[i][0] != '-' && path.empty())
      path = argv[i];
    else
      return usage();
  }
  try {
    std::vector<Mesh> meshes{path.empty() ? bench::bunny() : read_obj(path)};
    if (!small) {
      meshes.push_back(subdivide(subdivide(meshes[0])));
      meshes[1].name += " subdivided twice";
    }
    std::printf("libvbm %s, median of %d rounds\n\n", vbm_version(), repeat);
    for (std::size_t m = 0; m < meshes.size(); ++m)
      for (bool faces : {false, true})
        if (!faces || !points) run(meshes[m], faces, repeat, m ? kMegabytesGoal : 0);
  } catch (const std::exception &e) {
    std::fprintf(stderr, "vbm_bench_speed: %s\n", e.what());
    return 1;
  }
}
