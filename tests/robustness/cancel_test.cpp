// SPDX-License-Identifier: GPL-3.0-or-later
// Progress, and cancelling at every report of it.
#include "child.h"
#include "outcome.h"
#include "snapshot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

/// Watches the progress of a call and stops it where told.
class Watch {
public:
  explicit Watch(vbm_context *context) : context_(context) {
    vbm_context_set_progress(context, &Watch::call, this);
  }
  ~Watch() { vbm_context_set_progress(context_, nullptr, nullptr); }

  void restart() {
    calls = 0;
    last = 0;
    in_stage.clear();
  }

  /// Stop at the so-manieth call in all, or in this stage; 0: never.
  int stop_at = 0;
  std::string stop_stage;

  int calls = 0;
  double last = 0;
  bool went_down = false, out_of_range = false;
  std::map<std::string, int> in_stage;

private:
  static int call(void *user, double fraction, const char *stage) {
    Watch &w = *static_cast<Watch *>(user);
    ++w.calls;
    w.went_down |= fraction < w.last;
    w.out_of_range |= !(fraction >= 0 && fraction <= 1) || !stage || !*stage;
    w.last = fraction;
    const int here = ++w.in_stage[stage];
    if (w.stop_stage.empty()) return w.calls == w.stop_at;
    return stage == w.stop_stage && here == w.stop_at;
  }
  vbm_context *context_;
};

/// A whole job: balls, surface and crust, axis, pruning and the surface after it. Its result, or ""
/// if it was cancelled.
class Job {
public:
  Job(std::string name, Build build) : name(std::move(name)), build_(std::move(build)) {}

  /// Run it with the watch's orders; a cancelled call must leave nothing, and the rest of the job
  /// is then not done. *calls receives the calls of the whole job.
  std::string run(vbm_context *context, Watch &watch, int *calls = nullptr) {
    std::string result;
    int sum = 0;
    vbm_model *model = reinterpret_cast<vbm_model *>(this);
    vbm_surface *surface = reinterpret_cast<vbm_surface *>(this), *crust = surface;
    vbm_axis *axis = reinterpret_cast<vbm_axis *>(this), *pruned = axis;
    const int stop = watch.stop_at;
    const auto step = [&](auto &handle, auto &&call) {
      watch.restart();
      if (watch.stop_stage.empty()) watch.stop_at = stop ? stop - sum : 0;
      const vbm_status status = call();
      sum += watch.calls;
      for (const auto &[stage, n] : watch.in_stage) stages[stage] = std::max(stages[stage], n);
      EXPECT_FALSE(watch.went_down) << name;
      EXPECT_FALSE(watch.out_of_range) << name;
      if (status == VBM_OK) {
        EXPECT_EQ(watch.last, 1) << name << " does not end at 1";
        return true;
      }
      EXPECT_EQ(status, VBM_ERROR_CANCELLED) << name << ": " << vbm_context_message(context);
      EXPECT_EQ(std::string(vbm_context_message(context)).rfind("cancelled", 0), 0u);
      EXPECT_EQ(handle, nullptr) << name;
      return false;
    };
    bool done = step(model, [&] { return build_(context, nullptr, &model); });
    if (done) {
      result = snapshot(model);
      done = step(surface, [&] { return vbm_model_surface(context, model, &surface); });
      if (done) {
        result += snapshot(surface);
        vbm_surface_free(surface);
        done =
            step(crust, [&] { return vbm_model_power_crust(context, model, nullptr, 0, &crust); });
        if (done) {
          result += snapshot(crust);
          vbm_surface_free(crust);
          done = step(axis, [&] { return vbm_model_medial_axis(context, model, nullptr, &axis); });
        }
        if (done) {
          result += snapshot(axis);
          vbm_prune_options options;
          vbm_prune_options_init(&options, sizeof options);
          options.measure = VBM_MEASURE_BALLS;
          options.threshold = 0.02;
          done = step(pruned, [&] { return vbm_axis_prune(context, axis, &options, &pruned); });
          // Also after a cancelled pruning: the axis is untouched.
          EXPECT_EQ(result.substr(result.size() - snapshot(axis).size()), snapshot(axis)) << name;
          vbm_axis_free(axis);
        }
        if (done) {
          result += snapshot(pruned);
          surface = reinterpret_cast<vbm_surface *>(this);
          done =
              step(surface, [&] { return vbm_axis_surface(context, pruned, nullptr, &surface); });
          vbm_axis_free(pruned);
          if (done) result += snapshot(surface);
          if (done) vbm_surface_free(surface);
        }
      }
      // Also after a cancelled surface: the model is untouched.
      EXPECT_EQ(result.rfind(snapshot(model), 0), 0u) << name;
      vbm_model_free(model);
    }
    watch.stop_at = stop;
    if (calls) *calls = sum;
    return done ? result : "";
  }

  std::string name;
  std::map<std::string, int> stages; // with the most reports of one call

private:
  Build build_;
};

class Cancel : public testing::Test {
protected:
  void SetUp() override { ASSERT_EQ(vbm_context_create(&context), VBM_OK); }
  void TearDown() override { vbm_context_free(context); }

  /// Cancel at the k-th report, for every k, then run whole again. Reports come by the clock: a
  /// slow machine makes many, and takes long for each, so of many only some are tried.
  void at_every_report(Job job) {
    Watch watch(context);
    int calls = 0;
    const std::string whole = job.run(context, watch, &calls);
    ASSERT_NE(whole, "");
    ASSERT_GT(calls, 10) << job.name;
    const int stride = 1 + calls / (sanitized() ? 8 : 25);
    for (int k = 1, tries = 0; k <= calls; k += stride, ++tries) {
      watch.stop_at = k;
      int reached = 0;
      const std::string result = job.run(context, watch, &reached);
      // A faster run may have fewer.
      if (reached >= k) {
        EXPECT_EQ(result, "") << job.name << " went on after report " << k;
      }
      watch.stop_at = 0;
      if (tries % 5 == 0) {
        EXPECT_TRUE(job.run(context, watch) == whole) << job.name << ": another result after " << k;
      }
    }
  }

  const shapes::Shape torus = shapes::torus(24, 10, 2, .6, .2);
  const shapes::Shape box = shapes::box({1, 2, .1}); // thin: it is refined
  const std::vector<double> scanners = {9, 0, 0, -9, 0, 0, 0, 9, 0, 0, -9, 0, 0, 0, 9, 0, 0, -9};
  vbm_context *context = nullptr;
};

TEST_F(Cancel, Points) { at_every_report({"points", points_of(torus)}); }

TEST_F(Cancel, Mesh) { at_every_report({"mesh", mesh_of(box)}); }

TEST_F(Cancel, Volume) {
  std::vector<float> values;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      for (int k = 0; k < 20; ++k)
        values.push_back(
            float(7.3 - shapes::distance({double(i), double(j), double(k)}, {9.6, 9.4, 9.5})));
  const double voxel[3] = {1, 1, 1};
  at_every_report({"volume", [&](vbm_context *c, const vbm_build_options *o, vbm_model **out) {
                     return vbm_build_volume(c, values.data(), VBM_SCALAR_FLOAT, 20, 20, 20, voxel,
                                             nullptr, 0, o, out);
                   }});
}

TEST_F(Cancel, RangeScan) {
  const shapes::Shape sphere = shapes::sphere_points(300);
  std::vector<int32_t> scanner;
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    std::size_t best = 0;
    for (std::size_t s = 0; s < 6; ++s) {
      const auto facing = [&](std::size_t k) {
        return sphere.points[3 * i] * scanners[3 * k] +
               sphere.points[3 * i + 1] * scanners[3 * k + 1] +
               sphere.points[3 * i + 2] * scanners[3 * k + 2];
      };
      if (facing(s) > facing(best)) best = s;
    }
    scanner.push_back(int32_t(best));
  }
  at_every_report({"range scan", [&](vbm_context *c, const vbm_build_options *o, vbm_model **out) {
                     return vbm_build_range_scan(c, sphere.points.data(), sphere.size(),
                                                 scanners.data(), 6, scanner.data(), o, out);
                   }});
}

TEST_F(Cancel, EveryStageOfABigJob) {
  const shapes::Shape big =
      sanitized() ? shapes::torus(40, 18, 2, .6, .3) : shapes::torus(70, 30, 2, .6, .3);
  for (Job job : {Job{"big points", points_of(big)}, Job{"big mesh", mesh_of(big)}}) {
    Watch watch(context);
    int calls = 0;
    const std::string whole = job.run(context, watch, &calls);
    ASSERT_NE(whole, "");
    const std::map<std::string, int> stages = job.stages;
    EXPECT_GE(stages.size(), 3u);
    for (const auto &[stage, reports] : stages)
      for (int k : std::set<int>{1, reports / 2 + 1}) { // at its beginning, and within
        watch.stop_stage = stage;
        watch.stop_at = k;
        const std::string result = job.run(context, watch);
        if (k == 1) {
          EXPECT_EQ(result, "") << job.name << " went on at " << stage;
        }
      }
    watch.stop_at = 0;
    EXPECT_TRUE(job.run(context, watch) == whole) << "another result after cancelling";
  }
}

TEST_F(Cancel, WithoutACallbackAllIsTheSame) {
  Job job{"points", points_of(torus)};
  std::string watched;
  {
    Watch watch(context);
    watched = job.run(context, watch);
  }
  const std::string balls_and_surfaces = run(points_of(torus)).bytes;
  vbm_model *model = nullptr;
  ASSERT_EQ(points_of(torus)(context, nullptr, &model), VBM_OK);
  vbm_axis *axis = nullptr;
  ASSERT_EQ(vbm_model_medial_axis(context, model, nullptr, &axis), VBM_OK);
  // Both go on after the crust: one as this job does, the other as the checks do.
  const size_t shown = watched.find(snapshot(axis));
  ASSERT_NE(shown, std::string::npos);
  EXPECT_EQ(balls_and_surfaces.compare(0, shown, watched, 0, shown), 0);
  vbm_axis_free(axis);
  vbm_model_free(model);
}

} // namespace
