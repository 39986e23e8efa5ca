// SPDX-License-Identifier: GPL-3.0-or-later
// Contexts in several threads at once, and finished models read by several threads. Most telling
// under ThreadSanitizer.
#include "outcome.h"
#include "snapshot.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace {

/// Run all of them at the same time.
void at_once(const std::vector<std::function<void()>> &bodies) {
  std::atomic<std::size_t> ready{0};
  std::vector<std::thread> threads;
  for (const auto &body : bodies)
    threads.emplace_back([&] {
      ++ready;
      while (ready < bodies.size()) std::this_thread::yield();
      body();
    });
  for (std::thread &thread : threads) thread.join();
}

TEST(Threads, ContextsAreIndependent) {
  // Kinds of input that use different parts of the library, exact arithmetic (a box's samples are
  // cospherical by the thousand) and errors included.
  const shapes::Shape torus = shapes::torus(24, 12, 2, .6, .2);
  const shapes::Shape box = shapes::box({1, 2, 3});
  const shapes::Shape sphere = shapes::sphere_mesh(12, 24);
  shapes::Shape bad = sphere;
  bad.points[100] = 0. / 0.;
  const std::vector<Build> builds = {points_of(torus), mesh_of(box), points_of(sphere, true),
                                     points_of(bad)};
  std::vector<std::string> alone;
  for (const Build &build : builds) alone.push_back(run(build).bytes);
  std::vector<std::function<void()>> bodies;
  for (std::size_t i = 0; i < builds.size(); ++i)
    bodies.push_back([&, i] {
      for (int round = 0; round < 2; ++round) {
        const std::size_t which = (i + std::size_t(round)) % builds.size();
        const Outcome outcome = run(builds[which]);
        EXPECT_EQ(outcome.problems, "");
        EXPECT_TRUE(outcome.bytes == alone[which]) << "another result in a thread: " << which;
      }
    });
  at_once(bodies);
}

/// Balls enough for a call to be divided among threads, and what becomes of them: nothing if it was
/// cancelled.
std::string ball_surface(const shapes::Shape &shape, double radius, int32_t threads,
                         vbm_progress_fn progress = nullptr, void *user = nullptr) {
  const std::vector<double> radii(shape.size(), radius);
  vbm_context *context = nullptr;
  EXPECT_EQ(vbm_context_create(&context), VBM_OK);
  vbm_context_set_threads(context, threads);
  vbm_context_set_progress(context, progress, user);
  vbm_ball_surface_options options;
  vbm_ball_surface_options_init(&options, sizeof options);
  vbm_surface *surface = nullptr;
  const vbm_status status = vbm_surface_from_balls(context, shape.points.data(), radii.data(),
                                                   shape.size(), &options, &surface);
  EXPECT_TRUE(status == VBM_OK || (progress && status == VBM_ERROR_CANCELLED))
      << vbm_context_message(context);
  EXPECT_EQ(surface != nullptr, status == VBM_OK);
  std::string bytes = surface ? snapshot(surface) : "";
  vbm_surface_free(surface);
  vbm_context_free(context);
  return bytes;
}

TEST(Threads, AnyNumberGivesTheSame) {
  const shapes::Shape torus = shapes::torus(60, 30, 2, .6, .03);
  for (double radius : {.1, .4}) {
    const std::string one = ball_surface(torus, radius, 1);
    EXPECT_FALSE(one.empty());
    for (int32_t threads : {0, 2, 64})
      EXPECT_TRUE(ball_surface(torus, radius, threads) == one) << threads << ", radius " << radius;
  }
}

TEST(Threads, ManyAtOnceAreIndependent) {
  const shapes::Shape torus = shapes::torus(60, 30, 2, .6, .03),
                      other = shapes::torus(40, 40, 2, .9, .02);
  const std::string first = ball_surface(torus, .1, 1), second = ball_surface(other, .1, 1);
  std::vector<std::function<void()>> bodies;
  for (int i = 0; i < 4; ++i)
    bodies.push_back([&, i] {
      const bool odd = i & 1;
      EXPECT_TRUE(ball_surface(odd ? other : torus, .1, 2) == (odd ? second : first)) << i;
    });
  at_once(bodies);
}

/// Cancels at a report, and notes who is called.
struct Canceller {
  int left;
  std::thread::id caller = std::this_thread::get_id();
  bool only_caller = true;

  static int report(void *user, double, const char *) {
    Canceller &self = *static_cast<Canceller *>(user);
    self.only_caller &= std::this_thread::get_id() == self.caller;
    return --self.left < 0;
  }
};

TEST(Threads, CancelledWhereverTheyAre) {
  const shapes::Shape torus = shapes::torus(90, 40, 2, .6, .03);
  Canceller all{1 << 30};
  const std::string whole = ball_surface(torus, .1, 2, &Canceller::report, &all);
  EXPECT_TRUE(all.only_caller);
  const int reports = (1 << 30) - all.left;
  int cancelled = 0;
  for (int at = 0; at < reports; at += 1 + reports / 8) {
    Canceller some{at};
    const std::string got = ball_surface(torus, .1, 2, &Canceller::report, &some);
    EXPECT_TRUE(got.empty() || got == whole) << at; // reports come by the clock: it may be done
    EXPECT_TRUE(some.only_caller);
    cancelled += got.empty();
  }
  EXPECT_GT(cancelled, 0);
  EXPECT_TRUE(ball_surface(torus, .1, 2) == whole);
}

TEST(Threads, BallSurfacesInContextsOfTheirOwn) {
  const shapes::Shape torus = shapes::torus(16, 8, 2, .6, .2);
  const std::vector<double> radii(torus.size(), .35);
  const auto make = [&](int32_t style) {
    vbm_context *context = nullptr;
    EXPECT_EQ(vbm_context_create(&context), VBM_OK);
    vbm_ball_surface_options options;
    vbm_ball_surface_options_init(&options, sizeof options);
    options.style = style;
    vbm_surface *surface = nullptr;
    EXPECT_EQ(vbm_surface_from_balls(context, torus.points.data(), radii.data(), torus.size(),
                                     &options, &surface),
              VBM_OK)
        << vbm_context_message(context);
    std::string bytes = snapshot(surface);
    vbm_surface_free(surface);
    vbm_context_free(context);
    return bytes;
  };
  std::vector<std::string> alone;
  for (int32_t style = 0; style < 3; ++style) alone.push_back(make(style));
  std::vector<std::function<void()>> bodies;
  for (int32_t i = 0; i < 6; ++i)
    bodies.push_back([&, i] { EXPECT_TRUE(make(i % 3) == alone[std::size_t(i % 3)]) << i; });
  at_once(bodies);
}

TEST(Threads, OneAxisManyReaders) {
  const shapes::Shape torus = shapes::torus(30, 14, 2, .6, .2);
  vbm_context *context = nullptr;
  ASSERT_EQ(vbm_context_create(&context), VBM_OK);
  vbm_model *model = nullptr;
  ASSERT_EQ(points_of(torus)(context, nullptr, &model), VBM_OK) << vbm_context_message(context);
  const auto make = [&] {
    vbm_axis *axis = nullptr;
    EXPECT_EQ(vbm_model_medial_axis(context, model, nullptr, &axis), VBM_OK);
    return axis;
  };
  // All of them ask for the balls' volumes, which are found once, and prune by them.
  const auto use = [&](const vbm_axis *axis, double threshold) {
    vbm_context *own = nullptr;
    EXPECT_EQ(vbm_context_create(&own), VBM_OK);
    const double *shares = nullptr;
    size_t count = 0;
    EXPECT_EQ(vbm_axis_part_ball_volumes(own, axis, &shares, &count), VBM_OK);
    std::string bytes(reinterpret_cast<const char *>(shares), count * sizeof *shares);
    vbm_prune_options options;
    vbm_prune_options_init(&options, sizeof options);
    options.measure = VBM_MEASURE_BALLS;
    options.threshold = threshold;
    vbm_axis *pruned = nullptr;
    EXPECT_EQ(vbm_axis_prune(own, axis, &options, &pruned), VBM_OK) << vbm_context_message(own);
    bytes += snapshot(pruned);
    vbm_surface *surface = nullptr;
    EXPECT_EQ(vbm_axis_surface(own, pruned, nullptr, &surface), VBM_OK);
    bytes += snapshot(surface);
    vbm_surface_free(surface);
    vbm_axis_free(pruned);
    vbm_context_free(own);
    return bytes;
  };
  const double thresholds[] = {0.001, 0.02, 0.3};
  vbm_axis *first = make();
  std::vector<std::string> alone, together(3);
  for (double threshold : thresholds) alone.push_back(use(first, threshold));
  vbm_axis_free(first);
  vbm_axis *axis = make();
  std::vector<std::function<void()>> bodies;
  for (std::size_t t = 0; t < 3; ++t)
    bodies.push_back([&, t] { together[t] = use(axis, thresholds[t]); });
  at_once(bodies);
  for (std::size_t t = 0; t < 3; ++t)
    EXPECT_TRUE(together[t] == alone[t]) << "another result beside other threads: " << t;
  vbm_axis_free(axis);
  vbm_model_free(model);
  vbm_context_free(context);
}

TEST(Threads, OneModelManyReaders) {
  const shapes::Shape torus = shapes::torus(30, 14, 2, .6, .2);
  vbm_context *context = nullptr;
  ASSERT_EQ(vbm_context_create(&context), VBM_OK);
  vbm_model *model = nullptr;
  ASSERT_EQ(points_of(torus)(context, nullptr, &model), VBM_OK) << vbm_context_message(context);
  const auto surfaces = [&](const std::vector<uint8_t> &keep) {
    std::string bytes;
    vbm_context *own = nullptr;
    EXPECT_EQ(vbm_context_create(&own), VBM_OK);
    vbm_surface *surface = nullptr;
    EXPECT_EQ(vbm_model_surface(own, model, &surface), VBM_OK);
    bytes += snapshot(surface);
    vbm_surface_free(surface);
    EXPECT_EQ(vbm_model_power_crust(own, model, keep.data(), keep.size(), &surface), VBM_OK)
        << vbm_context_message(own);
    bytes += snapshot(surface);
    vbm_surface_free(surface);
    vbm_context_free(own);
    return bytes + snapshot(model);
  };
  // Different balls are kept in each thread.
  std::vector<std::vector<uint8_t>> keep(3);
  for (std::size_t t = 0; t < keep.size(); ++t) {
    keep[t].assign(vbm_model_inner_count(model), 1);
    for (std::size_t b = 0; b < t * keep[t].size() / 4; ++b) keep[t][b] = 0;
  }
  std::vector<std::string> alone, together(keep.size());
  for (const auto &mask : keep) alone.push_back(surfaces(mask));
  std::vector<std::function<void()>> bodies;
  for (std::size_t t = 0; t < keep.size(); ++t)
    bodies.push_back([&, t] { together[t] = surfaces(keep[t]); });
  at_once(bodies);
  for (std::size_t t = 0; t < keep.size(); ++t)
    EXPECT_TRUE(together[t] == alone[t]) << "another result beside other threads: " << t;
  vbm_model_free(model);
  vbm_context_free(context);
}

TEST(Threads, ProgressComesOnTheCallingThread) {
  const shapes::Shape torus = shapes::torus(60, 30, 2, .6, .2);
  std::thread worker([&] {
    vbm_context *context = nullptr;
    ASSERT_EQ(vbm_context_create(&context), VBM_OK);
    struct State {
      std::thread::id caller = std::this_thread::get_id();
      int calls = 0, elsewhere = 0;
    } state;
    vbm_context_set_progress(
        context,
        [](void *user, double, const char *) {
          State &s = *static_cast<State *>(user);
          ++s.calls;
          s.elsewhere += std::this_thread::get_id() != s.caller;
          return 0;
        },
        &state);
    vbm_model *model = nullptr;
    EXPECT_EQ(mesh_of(torus)(context, nullptr, &model), VBM_OK);
    vbm_surface *surface = nullptr;
    EXPECT_EQ(vbm_model_power_crust(context, model, nullptr, 0, &surface), VBM_OK);
    EXPECT_GT(state.calls, 5);
    EXPECT_EQ(state.elsewhere, 0);
    vbm_surface_free(surface);
    vbm_model_free(model);
    vbm_context_free(context);
  });
  worker.join();
}

} // namespace
