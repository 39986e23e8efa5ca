// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target: bytes become an input and options for the C interface, and whatever comes out
// is checked as strictly as any other result. Coordinates are drawn from few values, so that points
// coincide, lie on lines, planes and spheres, or nearly do.
#include "check_axis.h"
#include "check_model.h"
#include "check_surface.h"
#include "snapshot.h"

#include <vbm/vbm.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace {

/// The fuzzer's bytes, then zeros.
class Bytes {
public:
  Bytes(const uint8_t *data, size_t size) : data_(data), end_(data + size) {}
  size_t left() const { return size_t(end_ - data_); }
  uint8_t byte() { return data_ < end_ ? *data_++ : 0; }
  uint32_t below(uint32_t n) { return byte() % n; }
  double raw() {
    double x = 0;
    uint8_t b[sizeof x];
    for (uint8_t &c : b) c = byte();
    std::memcpy(&x, b, sizeof x);
    return x;
  }

private:
  const uint8_t *data_, *end_;
};

[[noreturn]] void defect(const std::string &what) {
  std::fprintf(stderr, "DEFECT: %s\n", what.c_str());
  std::abort();
}

/// Samples times balls that brute force may take.
constexpr double kBruteForce = 2e5;

class Fuzz {
public:
  Fuzz(const uint8_t *data, size_t size) : in_(data, size) {}

  void run() {
    const uint8_t kind = in_.byte(), flags = in_.byte();
    again_ = (flags & 3) == 3;
    choose_options(flags);
    if (vbm_context_create(&context_) != VBM_OK) defect("no context");
    switch (kind % 5) {
    case 0:
      points(false);
      break;
    case 1:
      points(true);
      break;
    case 2:
      mesh();
      break;
    case 3:
      volume();
      break;
    default:
      scan();
    }
    vbm_context_free(context_);
  }

private:
  void choose_options(uint8_t flags) {
    vbm_build_options_init(&options_, sizeof options_);
    options_.balls = flags >> 2 & 1;
    options_.drop_invalid = flags >> 3 & 1;
    options_.refine = flags >> 4 & 1;
    const double spacings[] = {0, -1, 1, .25, 1e-3, 1e9, 3e-1, -0.};
    options_.spacing = spacings[flags >> 5];
    const uint8_t more = in_.byte();
    options_.labels = more % 8 < 5 ? more % 8 : VBM_LABELS_AUTO;
    options_.undersampling = .05 + .95 * (more >> 3) / 31.;
    options_.sample_limit = 2000;
    options_.cell_limit = 40000;
  }

  /// One of few values, or any double at all.
  double number() {
    const uint8_t b = in_.byte();
    switch (style_) {
    case 0: // a lattice
      return b % 5;
    case 1: // a finer one
      return b / 16.;
    case 2: // a lattice with the least of differences
      return b % 4 + (b >> 6) * 0x1p-52;
    case 3: // a lattice with small differences
      return b % 4 + (b >> 4) * 1e-9;
    case 4: // every magnitude
      return (b & 1 ? -1 : 1) * std::ldexp(1 + (b >> 6), int(b >> 1 & 31) * 60 - 930);
    case 5: // some are no numbers
      return b < 250 ? b % 7 : in_.raw();
    case 6:
      return in_.raw();
    default: // on a sphere, see vector()
      return b;
    }
  }

  void vector(double *out) {
    if (style_ == 7) {
      const double u = in_.byte() * std::acos(-1.) / 24, v = in_.byte() * std::acos(-1.) / 12;
      out[0] = std::sin(u) * std::cos(v), out[1] = std::sin(u) * std::sin(v), out[2] = std::cos(u);
      return;
    }
    for (int a = 0; a < 3; ++a) out[a] = number();
  }

  std::vector<double> vectors(size_t most) {
    style_ = in_.below(8);
    const size_t count = std::min<size_t>(in_.byte(), most);
    std::vector<double> out(3 * count);
    for (size_t i = 0; i < count; ++i) vector(&out[3 * i]);
    return out;
  }

  template <class Build> void build(Build &&call) {
    std::string first;
    for (int round = 0; round < (again_ ? 2 : 1); ++round) {
      vbm_model *model = reinterpret_cast<vbm_model *>(this);
      const vbm_status status = call(&model);
      const std::string shown = finish(status, model);
      if (round == 0)
        first = shown;
      else if (shown != first)
        defect("another result the second time");
    }
  }

  void expect_sane(vbm_status status, bool handle) {
    if (status < VBM_OK || status >= VBM_ERROR_INTERNAL || status == VBM_ERROR_CANCELLED ||
        status == VBM_ERROR_MEMORY)
      defect(std::string(vbm_status_name(status)) + ": " + vbm_context_message(context_));
    if ((status == VBM_OK) != handle) defect("a handle beside a failure, or none beside success");
    if ((status == VBM_OK) != (*vbm_context_message(context_) == 0)) defect("message and status");
  }

  std::string finish(vbm_status status, vbm_model *model) {
    expect_sane(status, model != nullptr);
    if (!model) return vbm_context_message(context_);
    size_t balls = 0, samples = 0;
    vbm_model_radii(model, &balls);
    vbm_model_samples(model, &samples);
    const Problems problems = check_model(model, double(balls) * double(samples) < kBruteForce);
    if (!problems.none()) defect("model: " + problems.text());
    std::string shown = snapshot(model);
    vbm_surface *surface = nullptr;
    status = vbm_model_surface(context_, model, &surface);
    shown += finish(status, surface, model, "surface");
    status = vbm_model_power_crust(context_, model, nullptr, 0, &surface);
    shown += finish(status, surface, model, "power crust");
    // Some of the inner balls, by the model's own bytes.
    std::vector<uint8_t> keep(vbm_model_inner_count(model));
    bool any = false;
    for (size_t b = 0; b < keep.size(); ++b)
      any |= keep[b] = uint8_t(shown[(b * 37 + 11) % shown.size()]) % 3 != 0;
    status = vbm_model_power_crust(context_, model, keep.data(), keep.size(), &surface);
    if (!any != (status == VBM_ERROR_NO_INTERIOR)) defect("a crust of no balls");
    shown += finish(status, surface, model, "power crust of some balls");
    const Problems of_axis = exercise_axis(context_, model, &shown);
    if (!of_axis.none()) defect("axis: " + of_axis.text());
    vbm_model_free(model);
    return shown;
  }

  std::string finish(vbm_status status, vbm_surface *surface, const vbm_model *model,
                     const char *what) {
    expect_sane(status, surface != nullptr);
    if (!surface) {
      if (status != VBM_ERROR_NO_INTERIOR) defect(std::string(what) + " failed");
      return "";
    }
    const Problems problems = check_surface(surface, model);
    if (!problems.none()) defect(std::string(what) + ": " + problems.text());
    const std::string shown = snapshot(surface);
    vbm_surface_free(surface);
    return shown;
  }

  void points(bool with_normals) {
    const std::vector<double> p = vectors(160);
    std::vector<double> n;
    if (with_normals) {
      style_ = in_.below(8);
      n.resize(p.size());
      for (size_t i = 0; i < p.size(); i += 3) vector(&n[i]);
    }
    build([&](vbm_model **out) {
      return vbm_build_points(context_, p.data(), p.size() / 3, with_normals ? n.data() : nullptr,
                              &options_, out);
    });
  }

  void mesh() {
    const std::vector<double> p = vectors(40);
    const uint32_t n = uint32_t(p.size() / 3);
    const bool polygons = in_.byte() & 1;
    std::vector<uint32_t> sizes;
    std::vector<int32_t> corners;
    while (in_.left() && sizes.size() < 80) {
      const uint32_t size = polygons ? in_.below(7) : 3;
      sizes.push_back(size);
      for (uint32_t c = 0; c < size; ++c) {
        const uint8_t b = in_.byte(); // rarely one that is not there
        corners.push_back(b == 255 ? int32_t(n) : n ? int32_t(b % n) : 0);
      }
    }
    build([&](vbm_model **out) {
      return vbm_build_mesh(context_, p.data(), n, polygons ? sizes.data() : nullptr,
                            corners.data(), corners.size(), sizes.size(), &options_, out);
    });
  }

  void volume() {
    style_ = in_.below(7);
    const size_t n[3] = {in_.below(8), in_.below(8), in_.below(8)};
    double voxel[3], origin[3];
    for (int a = 0; a < 3; ++a) {
      voxel[a] = 1 + in_.below(3);
      origin[a] = in_.byte() & 1 ? number() : 0;
    }
    const double level = number();
    const auto type = vbm_scalar(in_.below(6));        // one of them unknown
    std::vector<double> reals(n[0] * n[1] * n[2] + 1); // never NULL
    for (double &x : reals) x = number();
    std::vector<uint8_t> bytes;
    std::vector<uint16_t> words;
    std::vector<int16_t> signed_words;
    std::vector<float> floats;
    const void *values = reals.data();
    const auto convert = [&](auto &to) {
      using T = typename std::decay_t<decltype(to)>::value_type;
      for (double x : reals) to.push_back(T(std::fabs(x) < 100 ? x : 100));
      values = to.data();
    };
    if (type == VBM_SCALAR_UINT8) {
      for (double x : reals) bytes.push_back(uint8_t(std::fabs(x) < 100 ? std::fabs(x) : 100));
      values = bytes.data();
    } else if (type == VBM_SCALAR_UINT16) {
      for (double x : reals) words.push_back(uint16_t(std::fabs(x) < 100 ? std::fabs(x) : 100));
      values = words.data();
    } else if (type == VBM_SCALAR_INT16) {
      convert(signed_words);
    } else if (type == VBM_SCALAR_FLOAT) {
      convert(floats);
    }
    build([&](vbm_model **out) {
      return vbm_build_volume(context_, values, type, n[0], n[1], n[2], voxel, origin, level,
                              &options_, out);
    });
  }

  void scan() {
    const std::vector<double> p = vectors(120), s = vectors(5);
    std::vector<int32_t> of;
    for (size_t i = 0; i < p.size() / 3; ++i) {
      const uint8_t b = in_.byte();
      of.push_back(b == 255 ? -1 : s.empty() ? 0 : int32_t(b % (s.size() / 3)));
    }
    const bool none = in_.byte() % 8 == 7;
    build([&](vbm_model **out) {
      return vbm_build_range_scan(context_, p.data(), p.size() / 3, s.data(), s.size() / 3,
                                  none ? nullptr : of.data(), &options_, out);
    });
  }

  Bytes in_;
  uint32_t style_ = 0;
  bool again_ = false;
  vbm_build_options options_;
  vbm_context *context_ = nullptr;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  Fuzz(data, size).run();
  return 0;
}
