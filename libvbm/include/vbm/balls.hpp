// libvbm for C++: unions of balls. Included by vbm.hpp; adds no logic to balls.h.
//
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VBM_BALLS_HPP
#define VBM_BALLS_HPP

#include <vbm/vbm.hpp>

namespace vbm {

/// Exact measures of a union of balls.
class Measures {
public:
  explicit Measures(vbm_measures *owned = nullptr) : handle_(owned) {}
  const vbm_measures *handle() const { return handle_.get(); }

  View<double> ball_volumes() const { return view(vbm_measures_ball_volumes); }
  View<double> ball_areas() const { return view(vbm_measures_ball_areas); }

  vbm_measures_report report() const {
    vbm_measures_report report{};
    report.struct_size = sizeof report;
    if (vbm_status status = vbm_measures_get_report(handle(), &report))
      throw Error(status, "cannot read the measures' report");
    return report;
  }

private:
  View<double> view(const double *(*get)(const vbm_measures *, std::size_t *)) const {
    View<double> result;
    result.data = get(handle(), &result.size);
    return result;
  }
  struct Free {
    void operator()(vbm_measures *measures) const { vbm_measures_free(measures); }
  };
  std::unique_ptr<vbm_measures, Free> handle_;
};

inline Measures union_measures(Context &context, View<double, 3> centers, View<double> radii) {
  if (centers.size != radii.size)
    throw Error(VBM_ERROR_ARGUMENT, "there must be as many radii as centres", "ball");
  vbm_measures *out = nullptr;
  const vbm_status status =
      vbm_union_measures(context.handle(), centers.data, radii.data, centers.size, &out);
  Measures measures(out);
  context.check(status);
  return measures;
}

struct BallSurfaceOptions : vbm_ball_surface_options {
  BallSurfaceOptions() { vbm_ball_surface_options_init(this, sizeof(vbm_ball_surface_options)); }
};

inline Surface surface_from_balls(Context &context, View<double, 3> centers, View<double> radii,
                                  const vbm_ball_surface_options &options = BallSurfaceOptions()) {
  if (centers.size != radii.size)
    throw Error(VBM_ERROR_ARGUMENT, "there must be as many radii as centres", "ball");
  vbm_surface *out = nullptr;
  const vbm_status status = vbm_surface_from_balls(context.handle(), centers.data, radii.data,
                                                   centers.size, &options, &out);
  Surface surface(out);
  context.check(status);
  return surface;
}

/// Empty `keep`: all inner balls.
inline Surface surface_from_balls(Context &context, const Model &model,
                                  View<std::uint8_t> keep = {},
                                  const vbm_ball_surface_options &options = BallSurfaceOptions()) {
  vbm_surface *out = nullptr;
  const vbm_status status = vbm_model_ball_surface(context.handle(), model.handle(), keep.data,
                                                   keep.size, &options, &out);
  Surface surface(out);
  context.check(status);
  return surface;
}

} // namespace vbm

#endif // VBM_BALLS_HPP
