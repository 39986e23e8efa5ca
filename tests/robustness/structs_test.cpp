// SPDX-License-Identifier: GPL-3.0-or-later
// Option and report structs of other sizes than this header's: a caller built with an older or a
// newer one. And the parameter table against the options.
#include "outcome.h"
#include "snapshot.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace {

constexpr unsigned char kUntouched = 0xa5;

/// Memory of a caller's struct of `size` bytes with a guard behind it.
template <class Struct> class Sized {
public:
  explicit Sized(size_t size) : size_(size), bytes_(size + 64, kUntouched) {}
  Struct *get() { return reinterpret_cast<Struct *>(bytes_.data()); }
  void set_size() { std::memcpy(bytes_.data(), &size_, sizeof size_); }
  size_t stated() const {
    size_t size;
    std::memcpy(&size, bytes_.data(), sizeof size);
    return size;
  }
  bool guard_untouched() const {
    for (size_t i = size_; i < bytes_.size(); ++i)
      if (bytes_[i] != kUntouched) return false;
    return true;
  }
  unsigned char at(size_t i) const { return bytes_[i]; }
  const unsigned char *data() const { return bytes_.data(); }

private:
  size_t size_;
  std::vector<unsigned char> bytes_;
};

class Structs : public testing::Test {
protected:
  void SetUp() override { ASSERT_EQ(vbm_context_create(&context), VBM_OK); }
  void TearDown() override { vbm_context_free(context); }
  const shapes::Shape torus = shapes::torus(16, 8, 2, .6, .2);
  vbm_context *context = nullptr;
};

TEST_F(Structs, OptionsOfEverySize) {
  const std::string usual = run(points_of(torus)).bytes;
  ASSERT_NE(usual, "");
  vbm_build_options defaults = make_options();
  for (size_t size = sizeof(size_t); size <= sizeof defaults + 40; ++size) {
    Sized<vbm_build_options> options(size);
    vbm_build_options_init(options.get(), size);
    EXPECT_TRUE(options.guard_untouched()) << size;
    EXPECT_EQ(options.stated(), size);
    const size_t known = std::min(size, sizeof defaults);
    EXPECT_EQ(0, std::memcmp(options.data() + sizeof(size_t),
                             reinterpret_cast<unsigned char *>(&defaults) + sizeof(size_t),
                             known - sizeof(size_t)))
        << size;
    for (size_t i = known; i < size; ++i) EXPECT_EQ(options.at(i), 0) << size;
    vbm_model *model = nullptr;
    ASSERT_EQ(points_of(torus)(context, options.get(), &model), VBM_OK)
        << size << vbm_context_message(context);
    EXPECT_EQ(usual.rfind(snapshot(model), 0), 0u) << "another result with struct size " << size;
    vbm_model_free(model);
  }
}

TEST_F(Structs, OldOptionsKeepWhatTheySay) {
  // Of a header that ended with `balls`; what follows in memory is not the library's.
  const size_t size = offsetof(vbm_build_options, balls) + sizeof(int32_t);
  Sized<vbm_build_options> options(size);
  vbm_build_options_init(options.get(), size);
  const int32_t voronoi = VBM_BALLS_VORONOI;
  std::memcpy(reinterpret_cast<unsigned char *>(options.get()) + offsetof(vbm_build_options, balls),
              &voronoi, sizeof voronoi);
  vbm_model *model = nullptr;
  ASSERT_EQ(points_of(torus)(context, options.get(), &model), VBM_OK);
  EXPECT_EQ(run(points_of(torus), make_options(VBM_BALLS_VORONOI)).bytes.rfind(snapshot(model), 0),
            0u);
  EXPECT_NE(run(points_of(torus)).bytes.rfind(snapshot(model), 0), 0u);
  vbm_model_free(model);
}

TEST_F(Structs, OptionsTooSmallForTheirSize) {
  vbm_build_options options;
  std::memset(&options, kUntouched, sizeof options);
  const vbm_build_options before = options;
  for (size_t size = 0; size < sizeof(size_t); ++size) vbm_build_options_init(&options, size);
  EXPECT_EQ(0, std::memcmp(&options, &before, sizeof options));
  vbm_build_options_init(nullptr, sizeof options);
  for (size_t size = 0; size < sizeof(size_t); ++size) {
    options.struct_size = size;
    vbm_model *model = nullptr;
    EXPECT_EQ(points_of(torus)(context, &options, &model), VBM_ERROR_ARGUMENT);
    EXPECT_EQ(model, nullptr);
  }
}

/// A report asked for in every size holds the same first bytes, zeros beyond, and nothing behind.
template <class Report, class Handle>
void every_size(const Handle *handle, vbm_status (*get)(const Handle *, Report *)) {
  Report full;
  full.struct_size = sizeof full;
  ASSERT_EQ(get(handle, &full), VBM_OK);
  for (size_t size = sizeof(size_t); size <= sizeof full + 40; ++size) {
    Sized<Report> report(size);
    report.set_size();
    ASSERT_EQ(get(handle, report.get()), VBM_OK) << size;
    EXPECT_EQ(report.stated(), size);
    EXPECT_TRUE(report.guard_untouched()) << size;
    const size_t known = std::min(size, sizeof full);
    EXPECT_EQ(0, std::memcmp(report.data() + sizeof(size_t),
                             reinterpret_cast<unsigned char *>(&full) + sizeof(size_t),
                             known - sizeof(size_t)))
        << size;
    for (size_t i = known; i < size; ++i) EXPECT_EQ(report.at(i), 0) << size;
  }
  for (size_t size = 0; size < sizeof(size_t); ++size) {
    Sized<Report> report(64);
    std::memcpy(report.get(), &size, sizeof size);
    EXPECT_EQ(get(handle, report.get()), VBM_ERROR_ARGUMENT);
  }
}

TEST_F(Structs, ReportsOfEverySize) {
  vbm_model *model = nullptr;
  ASSERT_EQ(points_of(torus)(context, nullptr, &model), VBM_OK);
  every_size(model, vbm_model_get_report);
  vbm_surface *surface = nullptr;
  ASSERT_EQ(vbm_model_surface(context, model, &surface), VBM_OK);
  every_size(surface, vbm_surface_get_report);
  vbm_surface_free(surface);
  vbm_axis *axis = nullptr;
  ASSERT_EQ(vbm_model_medial_axis(context, model, nullptr, &axis), VBM_OK);
  every_size(axis, vbm_axis_get_report);
  vbm_axis_free(axis);
  vbm_model_free(model);
}

/// Options of every size are filled and read as far as they go, and give the usual result.
template <class Options>
void every_size_of(void (*init)(Options *, size_t),
                   const std::function<std::string(const Options *)> &shown_with) {
  Options defaults;
  init(&defaults, sizeof defaults);
  const std::string usual = shown_with(nullptr);
  ASSERT_NE(usual, "");
  for (size_t size = sizeof(size_t); size <= sizeof defaults + 40; ++size) {
    Sized<Options> options(size);
    init(options.get(), size);
    EXPECT_TRUE(options.guard_untouched()) << size;
    EXPECT_EQ(options.stated(), size);
    const size_t known = std::min(size, sizeof defaults);
    EXPECT_EQ(0, std::memcmp(options.data() + sizeof(size_t),
                             reinterpret_cast<unsigned char *>(&defaults) + sizeof(size_t),
                             known - sizeof(size_t)))
        << size;
    EXPECT_TRUE(shown_with(options.get()) == usual) << "another result with struct size " << size;
  }
  Options small = defaults;
  for (size_t size = 0; size < sizeof(size_t); ++size) {
    small.struct_size = size;
    EXPECT_EQ(shown_with(&small), "") << "a struct of " << size << " bytes was taken";
  }
}

TEST_F(Structs, AxisOptionsOfEverySize) {
  vbm_model *model = nullptr;
  ASSERT_EQ(points_of(torus)(context, nullptr, &model), VBM_OK);
  const auto shown = [](auto *handle, void (*free)(decltype(handle))) {
    const std::string bytes = handle ? snapshot(handle) : "";
    free(handle);
    return bytes;
  };
  vbm_axis *axis = nullptr;
  ASSERT_EQ(vbm_model_medial_axis(context, model, nullptr, &axis), VBM_OK);
  every_size_of<vbm_axis_options>(vbm_axis_options_init, [&](const vbm_axis_options *options) {
    vbm_axis *out = nullptr;
    vbm_model_medial_axis(context, model, options, &out);
    return shown(out, vbm_axis_free);
  });
  every_size_of<vbm_prune_options>(vbm_prune_options_init, [&](const vbm_prune_options *options) {
    vbm_axis *out = nullptr;
    vbm_axis_prune(context, axis, options, &out);
    return shown(out, vbm_axis_free);
  });
  every_size_of<vbm_axis_surface_options>(vbm_axis_surface_options_init,
                                          [&](const vbm_axis_surface_options *options) {
                                            vbm_surface *out = nullptr;
                                            vbm_axis_surface(context, axis, options, &out);
                                            return shown(out, vbm_surface_free);
                                          });
  vbm_axis_free(axis);
  vbm_model_free(model);
}

TEST_F(Structs, ParametersOfEverySize) {
  ASSERT_GT(vbm_param_count(), 0u);
  for (size_t size = sizeof(size_t); size <= sizeof(vbm_param) + 40; ++size) {
    Sized<vbm_param> param(size);
    param.set_size();
    ASSERT_EQ(vbm_param_describe(0, param.get()), VBM_OK);
    EXPECT_EQ(param.stated(), size);
    EXPECT_TRUE(param.guard_untouched()) << size;
  }
  vbm_param param{};
  EXPECT_EQ(vbm_param_describe(0, &param), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(vbm_param_describe(0, nullptr), VBM_ERROR_ARGUMENT);
  param.struct_size = sizeof param;
  EXPECT_EQ(vbm_param_describe(vbm_param_count(), &param), VBM_ERROR_ARGUMENT);
  EXPECT_EQ(vbm_param_describe(SIZE_MAX, &param), VBM_ERROR_ARGUMENT);
}

/// The field of that name as a number.
double field(const vbm_build_options &o, const std::string &name) {
  if (name == "balls") return o.balls;
  if (name == "labels") return o.labels;
  if (name == "spacing") return o.spacing;
  if (name == "undersampling") return o.undersampling;
  if (name == "drop_invalid") return o.drop_invalid;
  if (name == "refine") return o.refine;
  if (name == "sample_limit") return double(o.sample_limit);
  if (name == "cell_limit") return double(o.cell_limit);
  ADD_FAILURE() << "no option " << name;
  return 0;
}

TEST_F(Structs, ParameterTableAgreesWithDefaults) {
  const vbm_build_options defaults = make_options();
  size_t build = 0;
  for (size_t i = 0; i < vbm_param_count(); ++i) {
    vbm_param p{};
    p.struct_size = sizeof p;
    ASSERT_EQ(vbm_param_describe(i, &p), VBM_OK);
    ASSERT_TRUE(p.operation && p.name && p.label && p.help && p.unit) << i;
    SCOPED_TRACE(p.name);
    EXPECT_NE(std::string(p.label), "");
    EXPECT_GT(std::strlen(p.help), 10u);
    EXPECT_EQ(std::string(p.help).find('\n'), std::string::npos) << "help is one line";
    EXPECT_LE(p.minimum, p.default_value);
    EXPECT_LE(p.default_value, p.maximum);
    if (std::string(p.operation) == "build") {
      ++build;
      EXPECT_EQ(field(defaults, p.name), p.default_value);
    }
    EXPECT_EQ(p.type == VBM_PARAM_LENGTH, std::string(p.unit) == "length");
    EXPECT_EQ(p.type == VBM_PARAM_ENUM, p.enum_count > 0);
    if (p.type == VBM_PARAM_BOOL) {
      EXPECT_EQ(p.maximum, 1);
    }
    if (p.type != VBM_PARAM_ENUM) continue;
    EXPECT_EQ(p.minimum, 0);
    EXPECT_EQ(p.maximum, p.enum_count - 1);
    ASSERT_TRUE(p.enum_names && p.enum_labels && p.enum_helps);
    for (int32_t e = 0; e < p.enum_count; ++e) {
      EXPECT_NE(std::string(p.enum_names[e]), "");
      EXPECT_NE(std::string(p.enum_labels[e]), "");
      EXPECT_GT(std::strlen(p.enum_helps[e]), 10u);
    }
  }
  EXPECT_EQ(build, 8u) << "every field of vbm_build_options is in the table";
}

} // namespace
