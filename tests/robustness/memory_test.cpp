// SPDX-License-Identifier: GPL-3.0-or-later
// Requests for memory fail once, all or many of them, in every kind of call: an error, nothing
// lost, and the context goes on.
#include "child.h"
#include "failing_memory.h"
#include "shapes.h"
#include "snapshot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace {

using failing_memory::Mode;

/// Requests that fail in one test at most: with more, every so-manieth.
const long kMostFailures = sanitized() ? 120 : 1500;

class Memory : public testing::Test {
protected:
  /// One call that makes a handle. Returns its status, and what the handle shows.
  using Call = std::function<vbm_status(vbm_context *, std::string *shown)>;

  void fail_everywhere(const char *name, const Call &call) {
    std::string usual;
    vbm_context *context = nullptr;
    ASSERT_EQ(vbm_context_create(&context), VBM_OK);
    for (int warm = 0; warm < 2; ++warm) // what the libraries keep for ever
      ASSERT_EQ(call(context, &usual), VBM_OK) << name << ": " << vbm_context_message(context);
    failing_memory::arm(0, Mode::once);
    EXPECT_EQ(call(context, nullptr), VBM_OK);
    const long requests = failing_memory::disarm();
    vbm_context_free(context);
    ASSERT_GT(requests, 5) << name;
    const long stride = std::max(1L, (requests + kMostFailures - 1) / kMostFailures);
    std::printf("%s: %ld requests for memory\n", name, requests);
    long refused = 0;
    for (const Mode mode : {Mode::once, Mode::from_then_on})
      for (long k = 1; k <= requests; k += stride) {
        if (mode == Mode::from_then_on && k % 7 != 1) continue;
        const long before = failing_memory::blocks;
        ASSERT_EQ(vbm_context_create(&context), VBM_OK);
        failing_memory::arm(k, mode);
        const vbm_status status = call(context, nullptr);
        failing_memory::disarm();
        ASSERT_TRUE(failing_memory::failed) << name << " " << k;
        if (status == VBM_ERROR_MEMORY) {
          ++refused;
          ASSERT_EQ(std::string(vbm_context_message(context)).rfind("out of memory", 0), 0u);
        } else { // done without that memory
          ASSERT_EQ(status, VBM_OK) << name << " " << k << ": " << vbm_context_message(context);
        }
        if (status == VBM_OK || k % 50 == 1) {
          std::string shown;
          ASSERT_EQ(call(context, &shown), VBM_OK) << name << " after failing at " << k;
          ASSERT_TRUE(shown == usual) << name << ": another result after failing at " << k;
        }
        vbm_context_free(context);
        const long lost = failing_memory::blocks - before;
        ASSERT_EQ(lost, 0) << name << " loses " << lost << " blocks at " << k;
      }
    EXPECT_GT(refused, requests / stride / 2) << name;
  }

  /// A call that builds a model.
  static Call
  model_of(std::function<vbm_status(vbm_context *, const vbm_build_options *, vbm_model **)> build,
           vbm_balls balls = VBM_BALLS_POLAR) {
    return [build, balls](vbm_context *context, std::string *shown) {
      vbm_build_options options;
      vbm_build_options_init(&options, sizeof options);
      options.balls = balls;
      vbm_model *model = nullptr;
      const vbm_status status = build(context, &options, &model);
      EXPECT_EQ(status == VBM_OK, model != nullptr);
      if (shown && model) *shown = snapshot(model);
      vbm_model_free(model);
      return status;
    };
  }

  const shapes::Shape torus = shapes::torus(12, 6, 2, .7, .2);
  const shapes::Shape sphere = shapes::sphere_mesh(6, 10); // exact arithmetic is needed
  const shapes::Shape box = shapes::box({1, 1, .1});       // refined, as it is thin
};

TEST_F(Memory, ContextCreation) {
  const long before = failing_memory::blocks;
  vbm_context *context = reinterpret_cast<vbm_context *>(this);
  failing_memory::arm(1, Mode::once);
  const vbm_status status = vbm_context_create(&context);
  failing_memory::disarm();
  EXPECT_EQ(status, VBM_ERROR_MEMORY);
  EXPECT_EQ(context, nullptr);
  EXPECT_EQ(failing_memory::blocks, before);
}

TEST_F(Memory, Points) {
  fail_everywhere("points", model_of([&](auto *context, auto *options, auto **out) {
                    return vbm_build_points(context, torus.points.data(), torus.size(), nullptr,
                                            options, out);
                  }));
}

TEST_F(Memory, CospherePointsWithNormals) {
  fail_everywhere("cospherical points, Voronoi balls",
                  model_of(
                      [&](auto *context, auto *options, auto **out) {
                        return vbm_build_points(context, sphere.points.data(), sphere.size(),
                                                sphere.normals.data(), options, out);
                      },
                      VBM_BALLS_VORONOI));
}

TEST_F(Memory, MeshWithRefinement) {
  fail_everywhere("mesh", model_of([&](auto *context, auto *given, auto **out) {
                    vbm_build_options options = *given;
                    options.spacing = .5;
                    return vbm_build_mesh(context, box.points.data(), box.size(), nullptr,
                                          box.triangles.data(), box.triangles.size(), box.faces(),
                                          &options, out);
                  }));
}

TEST_F(Memory, Volume) {
  std::vector<float> values;
  for (int i = 0; i < 216; ++i)
    values.push_back(
        float(2.1 - shapes::distance({double(i / 36), double(i / 6 % 6), double(i % 6)},
                                     {2.6, 2.4, 2.5})));
  const double voxel[3] = {1, 1, 1};
  fail_everywhere("volume", model_of([&](auto *context, auto *options, auto **out) {
                    return vbm_build_volume(context, values.data(), VBM_SCALAR_FLOAT, 6, 6, 6,
                                            voxel, nullptr, 0, options, out);
                  }));
}

TEST_F(Memory, RangeScan) {
  const std::vector<double> scanners = {9, 0, 0, -9, 0, 0};
  std::vector<int32_t> scanner;
  for (std::size_t i = 0; i < sphere.size(); ++i) scanner.push_back(sphere.points[3 * i] < 0);
  fail_everywhere("range scan", model_of([&](auto *context, auto *options, auto **out) {
                    return vbm_build_range_scan(context, sphere.points.data(), sphere.size(),
                                                scanners.data(), 2, scanner.data(), options, out);
                  }));
}

TEST_F(Memory, Errors) {
  // Where there is no memory even for the message, there is a status.
  shapes::Shape bad = torus;
  for (std::size_t i = 0; i < bad.points.size(); i += 2) bad.points[i] = 0. / 0.;
  for (long k = 1; k < 20; ++k) {
    const long before = failing_memory::blocks;
    vbm_context *context = nullptr;
    ASSERT_EQ(vbm_context_create(&context), VBM_OK);
    vbm_model *model = nullptr;
    failing_memory::arm(k, Mode::from_then_on);
    const vbm_status status =
        vbm_build_points(context, bad.points.data(), bad.size(), nullptr, nullptr, &model);
    failing_memory::disarm();
    EXPECT_TRUE(status == VBM_ERROR_INPUT || status == VBM_ERROR_MEMORY) << status;
    EXPECT_NE(std::string(vbm_context_message(context)), "");
    vbm_context_free(context);
    EXPECT_EQ(failing_memory::blocks, before);
  }
}

TEST_F(Memory, Clusters) {
  std::vector<double> centers, radii;
  for (int i = 0; i < 60; ++i) {
    centers.insert(centers.end(), {i % 5 * .3, i / 5 % 4 * .4, i / 20 * .2});
    radii.push_back(.3 + .01 * (i * 7 % 10));
  }
  for (const int32_t measure : {VBM_CLUSTER_ENCLOSING, VBM_CLUSTER_UNION})
    for (const uint64_t count : {0, 9})
      fail_everywhere("clusters", [&](vbm_context *context, std::string *shown) {
        vbm_cluster_options options;
        vbm_cluster_options_init(&options, sizeof options);
        options.sphericity = .7;
        options.count = count;
        options.measure = measure;
        vbm_clusters *clusters = nullptr;
        vbm_status status = vbm_cluster_balls(context, centers.data(), radii.data(), radii.size(),
                                              &options, &clusters);
        EXPECT_EQ(status == VBM_OK, clusters != nullptr);
        vbm_cluster_error error;
        error.struct_size = sizeof error;
        if (clusters) status = vbm_clusters_measure(context, clusters, 100, &error);
        if (shown && status == VBM_OK) {
          size_t n = 0;
          const double *made = vbm_clusters_radii(clusters, &n);
          *shown = std::string(reinterpret_cast<const char *>(made), n * sizeof *made) +
                   std::string(reinterpret_cast<const char *>(&error), sizeof error);
        }
        vbm_clusters_free(clusters);
        return status;
      });
}

TEST_F(Memory, BallSurfaces) {
  std::vector<double> centers, radii; // a ring, so that there is a tunnel, and one apart
  for (int i = 0; i < 8; ++i) {
    centers.insert(centers.end(), {std::cos(i * .7854), std::sin(i * .7854), .01 * i});
    radii.push_back(.45 + .01 * (i * 3 % 8));
  }
  centers.insert(centers.end(), {0, 0, 2});
  radii.push_back(.3);
  for (const int32_t style :
       {VBM_BALL_STYLE_SINGULAR_POINTS, VBM_BALL_STYLE_SKIN, VBM_BALL_STYLE_POWER_CRUST})
    fail_everywhere("surface from balls", [&](vbm_context *context, std::string *shown) {
      vbm_ball_surface_options options;
      vbm_ball_surface_options_init(&options, sizeof options);
      options.style = style;
      options.errors = style == VBM_BALL_STYLE_SINGULAR_POINTS;
      vbm_surface *surface = nullptr;
      const vbm_status status = vbm_surface_from_balls(context, centers.data(), radii.data(),
                                                       radii.size(), &options, &surface);
      EXPECT_EQ(status == VBM_OK, surface != nullptr);
      if (shown && surface) *shown = snapshot(surface);
      vbm_surface_free(surface);
      return status;
    });
  fail_everywhere("measures", [&](vbm_context *context, std::string *shown) {
    vbm_measures *measures = nullptr;
    const vbm_status status =
        vbm_union_measures(context, centers.data(), radii.data(), radii.size(), &measures);
    EXPECT_EQ(status == VBM_OK, measures != nullptr);
    std::size_t count = 0;
    if (const double *shares = vbm_measures_ball_volumes(measures, &count); shown && shares)
      shown->assign(reinterpret_cast<const char *>(shares), count * sizeof *shares);
    vbm_measures_free(measures);
    return status;
  });
}

TEST_F(Memory, Surfaces) {
  vbm_context *maker = nullptr;
  vbm_model *model = nullptr;
  ASSERT_EQ(vbm_context_create(&maker), VBM_OK);
  ASSERT_EQ(vbm_build_points(maker, torus.points.data(), torus.size(), nullptr, nullptr, &model),
            VBM_OK);
  const auto surface_of = [&](auto make) {
    return [make](vbm_context *context, std::string *shown) {
      vbm_surface *surface = nullptr;
      const vbm_status status = make(context, &surface);
      EXPECT_EQ(status == VBM_OK, surface != nullptr);
      if (shown && surface) *shown = snapshot(surface);
      vbm_surface_free(surface);
      return status;
    };
  };
  fail_everywhere("surface", surface_of([&](vbm_context *context, vbm_surface **out) {
                    return vbm_model_surface(context, model, out);
                  }));
  std::vector<uint8_t> keep(vbm_model_inner_count(model), 1);
  keep[0] = 0;
  fail_everywhere("power crust", surface_of([&](vbm_context *context, vbm_surface **out) {
                    return vbm_model_power_crust(context, model, keep.data(), keep.size(), out);
                  }));
  vbm_model_free(model);
  vbm_context_free(maker);
}

TEST_F(Memory, Axes) {
  vbm_context *maker = nullptr;
  vbm_model *model = nullptr;
  ASSERT_EQ(vbm_context_create(&maker), VBM_OK);
  ASSERT_EQ(vbm_build_points(maker, torus.points.data(), torus.size(), nullptr, nullptr, &model),
            VBM_OK);
  const auto axis_of = [&](auto make) {
    return [make](vbm_context *context, std::string *shown) {
      vbm_axis *axis = nullptr;
      const vbm_status status = make(context, &axis);
      EXPECT_EQ(status == VBM_OK, axis != nullptr);
      if (shown && axis) *shown = snapshot(axis);
      vbm_axis_free(axis);
      return status;
    };
  };
  fail_everywhere("axis", axis_of([&](vbm_context *context, vbm_axis **out) {
                    return vbm_model_medial_axis(context, model, nullptr, out);
                  }));
  vbm_prune_options options;
  vbm_prune_options_init(&options, sizeof options);
  options.measure = VBM_MEASURE_BALLS;
  options.threshold = 0.02;
  fail_everywhere("axis, volumes of balls, pruning",
                  axis_of([&](vbm_context *context, vbm_axis **out) {
                    vbm_axis *whole = nullptr;
                    vbm_status status = vbm_model_medial_axis(context, model, nullptr, &whole);
                    const double *shares = nullptr;
                    size_t count = 0;
                    if (status == VBM_OK)
                      status = vbm_axis_part_ball_volumes(context, whole, &shares, &count);
                    EXPECT_EQ(status == VBM_OK, shares != nullptr);
                    if (status == VBM_OK) status = vbm_axis_prune(context, whole, &options, out);
                    vbm_axis_free(whole);
                    return status;
                  }));
  vbm_axis *axis = nullptr;
  ASSERT_EQ(vbm_model_medial_axis(maker, model, nullptr, &axis), VBM_OK);
  size_t count = 0;
  const vbm_part *parts = vbm_axis_parts(axis, &count);
  int32_t part = -1;
  for (size_t p = 0; p < count && part < 0; ++p)
    if (parts[p].lock == VBM_LOCK_NONE) part = int32_t(p);
  if (part >= 0)
    fail_everywhere("removing a part", axis_of([&](vbm_context *context, vbm_axis **out) {
                      return vbm_axis_remove_parts(context, axis, &part, 1, out);
                    }));
  fail_everywhere("surface of an axis", [&](vbm_context *context, std::string *shown) {
    vbm_surface *surface = nullptr;
    const vbm_status status = vbm_axis_surface(context, axis, nullptr, &surface);
    EXPECT_EQ(status == VBM_OK, surface != nullptr);
    if (shown && surface) *shown = snapshot(surface);
    vbm_surface_free(surface);
    return status;
  });
  vbm_axis_free(axis);
  vbm_model_free(model);
  vbm_context_free(maker);
}

TEST_F(Memory, MedialMeshes) {
  vbm_context *maker = nullptr;
  vbm_model *model = nullptr;
  vbm_axis *axis = nullptr;
  ASSERT_EQ(vbm_context_create(&maker), VBM_OK);
  ASSERT_EQ(vbm_build_points(maker, torus.points.data(), torus.size(), nullptr, nullptr, &model),
            VBM_OK);
  ASSERT_EQ(vbm_model_medial_axis(maker, model, nullptr, &axis), VBM_OK);
  const auto mesh_of = [&](auto make) {
    return [make](vbm_context *context, std::string *shown) {
      vbm_medial_mesh *mesh = nullptr;
      const vbm_status status = make(context, &mesh);
      EXPECT_EQ(status == VBM_OK, mesh != nullptr);
      if (shown && mesh) {
        std::size_t count = 0;
        const double *at = vbm_medial_mesh_vertices(mesh, &count);
        shown->assign(reinterpret_cast<const char *>(at), 24 * count);
        const int32_t *edges = vbm_medial_mesh_edges(mesh, &count);
        shown->append(reinterpret_cast<const char *>(edges), 8 * count);
      }
      vbm_medial_mesh_free(mesh);
      return status;
    };
  };
  vbm_simplify_options options;
  vbm_simplify_options_init(&options, sizeof options);
  options.count = 12;
  options.iterations = 2;
  fail_everywhere("axis of N balls", mesh_of([&](vbm_context *context, vbm_medial_mesh **out) {
                    return vbm_axis_simplify(context, axis, &options, out);
                  }));
  fail_everywhere("curve skeleton", mesh_of([&](vbm_context *context, vbm_medial_mesh **out) {
                    return vbm_axis_curve_skeleton(context, axis, nullptr, out);
                  }));
  vbm_axis_free(axis);
  vbm_model_free(model);
  vbm_context_free(maker);
}

} // namespace
