// SPDX-License-Identifier: GPL-3.0-or-later
// Callers with older or newer structs, with NULL, with nothing, and with impossible sizes.
#include "outcome.h"
#include "snapshot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace {

class Abi : public testing::Test {
protected:
  void SetUp() override { ASSERT_EQ(vbm_context_create(&context), VBM_OK); }
  void TearDown() override {
    vbm_model_free(model);
    vbm_surface_free(surface);
    vbm_context_free(context);
  }
  void build() { ASSERT_EQ(points_of(torus)(context, nullptr, &model), VBM_OK) << message(); }
  std::string message() const { return vbm_context_message(context); }

  /// A failed call: its status, a message, and no handle left in the way.
  void expect_error(vbm_status got, vbm_status wanted, const char *what) {
    EXPECT_EQ(got, wanted) << what << ": " << message();
    EXPECT_NE(message(), "") << what;
    EXPECT_EQ(model, nullptr) << what;
    vbm_model_free(model);
    model = reinterpret_cast<vbm_model *>(this); // must not be kept by the next failure
  }

  const shapes::Shape torus = shapes::torus(20, 10, 2, .6, .2);
  const shapes::Shape box = shapes::box({1, 1, 1});
  vbm_context *context = nullptr;
  vbm_model *model = nullptr;
  vbm_surface *surface = nullptr;
};

TEST_F(Abi, Version) {
  EXPECT_EQ(vbm_abi_version(), VBM_ABI_VERSION);
  EXPECT_NE(std::string(vbm_version()), "");
  for (int status = -1; status <= VBM_ERROR_INTERNAL + 1; ++status)
    EXPECT_NE(std::string(vbm_status_name(vbm_status(status))), "");
  EXPECT_STREQ(vbm_status_name(vbm_status(1000)), "unknown status");
}

TEST_F(Abi, FreeingNothing) {
  vbm_context_free(nullptr);
  vbm_model_free(nullptr);
  vbm_surface_free(nullptr);
}

TEST_F(Abi, NoContext) {
  EXPECT_EQ(vbm_context_create(nullptr), VBM_ERROR_ARGUMENT);
  EXPECT_STREQ(vbm_context_message(nullptr), "");
  const char *kind = nullptr;
  size_t count = 1, total = 1;
  vbm_context_bad_elements(nullptr, &kind, &count, &total);
  EXPECT_STREQ(kind, "");
  EXPECT_EQ(count, 0u);
  EXPECT_EQ(total, 0u);
  vbm_context_bad_elements(nullptr, nullptr, nullptr, nullptr);
  vbm_context_bad_elements(context, nullptr, nullptr, nullptr);
  vbm_context_set_progress(nullptr, nullptr, nullptr);
  vbm_context_set_threads(nullptr, 1);
  model = reinterpret_cast<vbm_model *>(this);
  EXPECT_EQ(points_of(torus)(nullptr, nullptr, &model), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(model, nullptr);
  EXPECT_EQ(points_of(torus)(nullptr, nullptr, nullptr), VBM_ERROR_ARGUMENT);
  surface = reinterpret_cast<vbm_surface *>(this);
  EXPECT_EQ(vbm_model_surface(nullptr, nullptr, &surface), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(surface, nullptr);
}

TEST_F(Abi, NoOut) {
  EXPECT_EQ(points_of(torus)(context, nullptr, nullptr), VBM_ERROR_ARGUMENT);
  EXPECT_NE(message(), "");
  EXPECT_EQ(mesh_of(box)(context, nullptr, nullptr), VBM_ERROR_ARGUMENT);
  build();
  EXPECT_EQ(message(), "");
  EXPECT_EQ(vbm_model_surface(context, model, nullptr), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(vbm_model_power_crust(context, model, nullptr, 0, nullptr), VBM_ERROR_ARGUMENT);
  EXPECT_NE(message(), "");
}

TEST_F(Abi, NullArrays) {
  const double *p = torus.points.data();
  const size_t n = torus.size();
  expect_error(vbm_build_points(context, nullptr, n, nullptr, nullptr, &model), VBM_ERROR_ARGUMENT,
               "points");
  expect_error(
      vbm_build_mesh(context, nullptr, 8, nullptr, box.triangles.data(), 36, 12, nullptr, &model),
      VBM_ERROR_ARGUMENT, "vertices");
  expect_error(
      vbm_build_mesh(context, box.points.data(), 8, nullptr, nullptr, 36, 12, nullptr, &model),
      VBM_ERROR_ARGUMENT, "corners");
  const double voxel[3] = {1, 1, 1}, origin[3] = {0, 0, 0};
  const uint8_t values[27] = {0};
  expect_error(vbm_build_volume(context, nullptr, VBM_SCALAR_UINT8, 3, 3, 3, voxel, origin, 1,
                                nullptr, &model),
               VBM_ERROR_ARGUMENT, "values");
  expect_error(vbm_build_volume(context, values, VBM_SCALAR_UINT8, 3, 3, 3, nullptr, origin, 1,
                                nullptr, &model),
               VBM_ERROR_ARGUMENT, "voxel_size");
  expect_error(vbm_build_range_scan(context, nullptr, n, p, 1, nullptr, nullptr, &model),
               VBM_ERROR_ARGUMENT, "scan points");
  expect_error(vbm_build_range_scan(context, p, n, nullptr, 1, nullptr, nullptr, &model),
               VBM_ERROR_ARGUMENT, "scanners");
  expect_error(vbm_build_range_scan(context, p, n, p, 2, nullptr, nullptr, &model),
               VBM_ERROR_ARGUMENT, "two scanners and nobody says whose points are whose");
  model = nullptr;
  EXPECT_EQ(vbm_model_surface(context, nullptr, &surface), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(vbm_model_power_crust(context, nullptr, nullptr, 0, &surface), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(surface, nullptr);
}

TEST_F(Abi, NothingAtAll) {
  expect_error(vbm_build_points(context, nullptr, 0, nullptr, nullptr, &model),
               VBM_ERROR_DEGENERATE, "no points");
  EXPECT_NE(message().find("0 points"), std::string::npos) << message();
  expect_error(vbm_build_mesh(context, nullptr, 0, nullptr, nullptr, 0, 0, nullptr, &model),
               VBM_ERROR_DEGENERATE, "no mesh");
  expect_error(
      vbm_build_mesh(context, box.points.data(), 8, nullptr, nullptr, 0, 0, nullptr, &model),
      VBM_ERROR_DEGENERATE, "no faces");
  const double voxel[3] = {1, 1, 1};
  const uint8_t value = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const size_t n[3] = {size_t(axis != 0), size_t(axis != 1), size_t(axis != 2)};
    const vbm_status status = vbm_build_volume(context, &value, VBM_SCALAR_UINT8, n[0], n[1], n[2],
                                               voxel, nullptr, 1, nullptr, &model);
    EXPECT_TRUE(status == VBM_ERROR_ARGUMENT || status == VBM_ERROR_DEGENERATE) << status;
    EXPECT_EQ(model, nullptr);
  }
  expect_error(
      vbm_build_range_scan(context, nullptr, 0, torus.points.data(), 1, nullptr, nullptr, &model),
      VBM_ERROR_DEGENERATE, "an empty scan");
  model = nullptr;
}

TEST_F(Abi, ImpossibleSizes) {
  const double *p = torus.points.data();
  const double voxel[3] = {1, 1, 1};
  const uint8_t value = 1;
  const size_t huge = SIZE_MAX, wraps = SIZE_MAX / 3 + 2; // 3 * wraps is 3 or so
  for (size_t n : {huge, huge / 24, wraps}) {
    const auto refused = [&](vbm_status status, const char *what) {
      EXPECT_TRUE(status == VBM_ERROR_ARGUMENT || status == VBM_ERROR_LIMIT) << what << status;
      EXPECT_EQ(model, nullptr) << what;
      EXPECT_NE(message(), "") << what;
    };
    refused(vbm_build_points(context, nullptr, n, nullptr, nullptr, &model), "NULL points");
    refused(vbm_build_points(context, p, n, nullptr, nullptr, &model), "points");
    refused(vbm_build_mesh(context, p, n, nullptr, box.triangles.data(), 36, 12, nullptr, &model),
            "vertices");
    refused(vbm_build_mesh(context, p, 8, nullptr, box.triangles.data(), 36, n, nullptr, &model),
            "faces");
    refused(vbm_build_mesh(context, nullptr, n, nullptr, nullptr, n, n, nullptr, &model), "mesh");
    refused(vbm_build_volume(context, nullptr, VBM_SCALAR_DOUBLE, n, n, n, voxel, nullptr, 1,
                             nullptr, &model),
            "NULL volume");
    refused(vbm_build_range_scan(context, nullptr, n, nullptr, n, nullptr, nullptr, &model),
            "scan");
  }
  // 2^64 voxels are 0 if one does not look.
  const size_t half = size_t(1) << 32;
  const vbm_status status = vbm_build_volume(context, &value, VBM_SCALAR_UINT8, half, half, 1,
                                             voxel, nullptr, 1, nullptr, &model);
  EXPECT_TRUE(status == VBM_ERROR_ARGUMENT || status == VBM_ERROR_LIMIT) << status;
  EXPECT_EQ(model, nullptr);
}

TEST_F(Abi, CornerCountsAreChecked) {
  const uint32_t sizes[12] = {3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4};
  expect_error(vbm_build_mesh(context, box.points.data(), 8, sizes, box.triangles.data(), 36, 12,
                              nullptr, &model),
               VBM_ERROR_ARGUMENT, "more corners than there are");
  expect_error(vbm_build_mesh(context, box.points.data(), 8, nullptr, box.triangles.data(), 35, 12,
                              nullptr, &model),
               VBM_ERROR_ARGUMENT, "fewer corners than faces need");
  const uint32_t most[12] = {UINT32_MAX, UINT32_MAX, UINT32_MAX, UINT32_MAX};
  expect_error(vbm_build_mesh(context, box.points.data(), 8, most, box.triangles.data(), 36, 12,
                              nullptr, &model),
               VBM_ERROR_ARGUMENT, "face sizes whose sum is too much");
  model = nullptr;
}

TEST_F(Abi, OptionsOutOfRange) {
  const auto refused = [&](const char *name, auto vbm_build_options::*field, auto value) {
    vbm_build_options options = make_options();
    options.*field = value;
    expect_error(points_of(torus)(context, &options, &model), VBM_ERROR_ARGUMENT, name);
    EXPECT_NE(message().find(name), std::string::npos) << message();
    const char *kind = nullptr;
    vbm_context_bad_elements(context, &kind, nullptr, nullptr);
    EXPECT_STREQ(kind, "option");
  };
  refused("balls", &vbm_build_options::balls, -1);
  refused("balls", &vbm_build_options::balls, 2);
  refused("labels", &vbm_build_options::labels, -1);
  refused("labels", &vbm_build_options::labels, 5);
  refused("labels", &vbm_build_options::labels, int(VBM_LABELS_VOXELS));
  refused("labels", &vbm_build_options::labels, int(VBM_LABELS_SCAN));
  refused("labels", &vbm_build_options::labels, int(VBM_LABELS_NORMALS)); // none were given
  refused("undersampling", &vbm_build_options::undersampling, 0.0);
  refused("undersampling", &vbm_build_options::undersampling, 1.5);
  refused("undersampling", &vbm_build_options::undersampling, std::nan(""));
  refused("spacing", &vbm_build_options::spacing, std::nan(""));
  refused("spacing", &vbm_build_options::spacing, HUGE_VAL);
  refused("struct_size", &vbm_build_options::struct_size, size_t(0));
  model = nullptr;
}

TEST_F(Abi, LimitsAreKept) {
  vbm_build_options options = make_options();
  options.sample_limit = 10;
  expect_error(points_of(torus)(context, &options, &model), VBM_ERROR_LIMIT, "sample_limit");
  expect_error(mesh_of(torus)(context, &options, &model), VBM_ERROR_LIMIT, "sample_limit, mesh");
  options = make_options();
  options.cell_limit = 50;
  expect_error(points_of(torus)(context, &options, &model), VBM_ERROR_LIMIT, "cell_limit");
  EXPECT_NE(message().find("50"), std::string::npos) << message();
  options = make_options();
  options.spacing = 1e-7; // 10^14 samples
  expect_error(mesh_of(box)(context, &options, &model), VBM_ERROR_LIMIT, "spacing");
  model = nullptr;
}

TEST_F(Abi, ViewsOfNothing) {
  size_t count = 7;
  const uint64_t *offsets = reinterpret_cast<const uint64_t *>(this);
  for (auto view : {vbm_model_centers, vbm_model_radii, vbm_model_samples, vbm_model_inner_radius,
                    vbm_model_outer_radius}) {
    EXPECT_EQ(view(nullptr, &count), nullptr);
    EXPECT_EQ(count, 0u);
    EXPECT_EQ(view(nullptr, nullptr), nullptr);
  }
  for (auto view : {vbm_model_sample_input, vbm_model_input_sample, vbm_model_undersampled})
    EXPECT_EQ(view(nullptr, &count), nullptr);
  EXPECT_EQ(vbm_model_inside(nullptr, nullptr), nullptr);
  EXPECT_EQ(vbm_model_inner_count(nullptr), 0u);
  EXPECT_EQ(vbm_model_ball_samples(nullptr, &offsets, &count), nullptr);
  EXPECT_EQ(offsets, nullptr);
  EXPECT_EQ(vbm_model_ball_neighbors(nullptr, nullptr, nullptr), nullptr);
  EXPECT_STREQ(vbm_model_notes(nullptr), "");
  for (auto view : {vbm_surface_triangles, vbm_surface_triangle_polygon, vbm_surface_polygon_ball,
                    vbm_surface_vertex_sample, vbm_surface_vertex_input}) {
    count = 7;
    EXPECT_EQ(view(nullptr, &count), nullptr);
    EXPECT_EQ(count, 0u);
  }
  EXPECT_EQ(vbm_surface_vertices(nullptr, nullptr), nullptr);
  EXPECT_EQ(vbm_surface_vertex_radius(nullptr, nullptr), nullptr);
  EXPECT_EQ(vbm_surface_polygons(nullptr, nullptr, nullptr), nullptr);
  vbm_model_report report{};
  report.struct_size = sizeof report;
  EXPECT_EQ(vbm_model_get_report(nullptr, &report), VBM_ERROR_ARGUMENT);
  vbm_surface_report surface_report{};
  surface_report.struct_size = sizeof surface_report;
  EXPECT_EQ(vbm_surface_get_report(nullptr, &surface_report), VBM_ERROR_ARGUMENT);
  build(); // counts and offsets are not needed on a model either
  EXPECT_NE(vbm_model_centers(model, nullptr), nullptr);
  EXPECT_NE(vbm_model_ball_samples(model, nullptr, nullptr), nullptr);
  EXPECT_EQ(vbm_model_get_report(model, nullptr), VBM_ERROR_ARGUMENT);
}

TEST_F(Abi, KeepMustFit) {
  build();
  std::vector<uint8_t> keep(vbm_model_inner_count(model) + 1, 1);
  const auto crust = [&](const uint8_t *data, size_t count) {
    surface = reinterpret_cast<vbm_surface *>(this);
    const vbm_status status = vbm_model_power_crust(context, model, data, count, &surface);
    if (status != VBM_OK) {
      EXPECT_EQ(surface, nullptr);
    }
    vbm_surface_free(surface);
    surface = nullptr;
    return status;
  };
  EXPECT_EQ(crust(keep.data(), keep.size()), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(crust(keep.data(), keep.size() - 2), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(crust(keep.data(), 0), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(crust(keep.data(), keep.size() - 1), VBM_OK);
  EXPECT_EQ(crust(nullptr, 12345), VBM_OK) << "without keep its count says nothing";
  keep.assign(keep.size(), 0);
  EXPECT_EQ(crust(keep.data(), keep.size() - 1), VBM_ERROR_NO_INTERIOR);
}

TEST_F(Abi, MessagesGoWithTheirCall) {
  const std::vector<double> bad = {0, 0, 0, 1, 0, 0, 0, std::nan(""), 0, 0, 0, 1, HUGE_VAL, 1, 1};
  EXPECT_EQ(vbm_build_points(context, bad.data(), 5, nullptr, nullptr, &model), VBM_ERROR_INPUT);
  const char *kind = nullptr;
  size_t count = 0, total = 0;
  const int64_t *elements = vbm_context_bad_elements(context, &kind, &count, &total);
  ASSERT_EQ(count, 2u);
  EXPECT_EQ(total, 2u);
  EXPECT_EQ(elements[0], 2);
  EXPECT_EQ(elements[1], 4);
  EXPECT_STREQ(kind, "vertex");
  build();
  EXPECT_EQ(message(), "");
  vbm_context_bad_elements(context, &kind, &count, &total);
  EXPECT_EQ(count + total, 0u);
  EXPECT_STREQ(kind, "");
  // A long list is cut, its total is not.
  const std::vector<double> many(3 * 10000, std::nan(""));
  vbm_model *none = nullptr;
  EXPECT_EQ(vbm_build_points(context, many.data(), 10000, nullptr, nullptr, &none),
            VBM_ERROR_INPUT);
  vbm_context_bad_elements(context, &kind, &count, &total);
  EXPECT_EQ(count, 4096u);
  EXPECT_EQ(total, 10000u);
}

} // namespace
