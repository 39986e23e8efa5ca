// libvbm for C++: the medial axis. Included by vbm.hpp; adds no logic to axis.h.
//
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VBM_AXIS_HPP
#define VBM_AXIS_HPP

#include <vbm/vbm.hpp>

namespace vbm {

struct AxisOptions : vbm_axis_options {
  AxisOptions() { vbm_axis_options_init(this, sizeof(vbm_axis_options)); }
};
struct PruneOptions : vbm_prune_options {
  PruneOptions() { vbm_prune_options_init(this, sizeof(vbm_prune_options)); }
};
struct AxisSurfaceOptions : vbm_axis_surface_options {
  AxisSurfaceOptions() { vbm_axis_surface_options_init(this, sizeof(vbm_axis_surface_options)); }
};

/// The medial axis of a ball model, as far as it is pruned.
class Axis {
public:
  explicit Axis(vbm_axis *owned = nullptr) : handle_(owned) {}
  const vbm_axis *handle() const { return handle_.get(); }

  View<double, 3> vertices() const { return view<3>(vbm_axis_vertices); }
  View<double> radii() const { return view(vbm_axis_radii); }
  View<std::int32_t, 3> triangles() const { return view<3>(vbm_axis_triangles); }
  View<std::int32_t, 2> triangle_samples() const { return view<2>(vbm_axis_triangle_samples); }
  View<double, 6> triangle_points() const { return view<6>(vbm_axis_triangle_points); }
  View<std::int32_t> triangle_part() const { return view(vbm_axis_triangle_part); }
  View<double> triangle_width() const { return view(vbm_axis_triangle_width); }
  View<double> triangle_angle() const { return view(vbm_axis_triangle_angle); }
  View<std::int32_t, 2> curves() const { return view<2>(vbm_axis_curves); }
  View<std::int32_t> curve_part() const { return view(vbm_axis_curve_part); }
  View<double> curve_width() const { return view(vbm_axis_curve_width); }
  View<double> curve_angle() const { return view(vbm_axis_curve_angle); }
  View<vbm_part> parts() const { return view(vbm_axis_parts); }
  Lists part_balls() const { return lists(vbm_axis_part_balls); }
  View<double, 3> nodes() const { return view<3>(vbm_axis_nodes); }
  Lists part_nodes() const { return lists(vbm_axis_part_nodes); }
  View<std::int32_t, 2> contact_edges() const { return view<2>(vbm_axis_contact_edges); }
  View<std::int32_t> contact_node() const { return view(vbm_axis_contact_node); }
  View<std::uint8_t> kept_balls() const { return view(vbm_axis_kept_balls); }
  /// Parts that pruning left below its threshold, and for each a vbm_lock.
  View<std::int32_t> stayed() const {
    View<std::int32_t> parts;
    parts.data = vbm_axis_stayed(handle(), nullptr, &parts.size);
    return parts;
  }
  View<std::int32_t> stayed_locks() const {
    View<std::int32_t> locks;
    vbm_axis_stayed(handle(), &locks.data, &locks.size);
    return locks;
  }
  View<double> part_ball_volumes(Context &context) const {
    View<double> shares;
    context.check(
        vbm_axis_part_ball_volumes(context.handle(), handle(), &shares.data, &shares.size));
    return shares;
  }
  const char *notes() const { return vbm_axis_notes(handle()); }

  vbm_axis_report report() const {
    vbm_axis_report report{};
    report.struct_size = sizeof report;
    if (vbm_status status = vbm_axis_get_report(handle(), &report))
      throw Error(status, "cannot read the axis's report");
    return report;
  }

  Axis prune(Context &context, const vbm_prune_options &options = PruneOptions()) const {
    vbm_axis *out = nullptr;
    const vbm_status status = vbm_axis_prune(context.handle(), handle(), &options, &out);
    Axis axis(out);
    context.check(status);
    return axis;
  }
  Axis prune_steps(Context &context, const std::vector<PruneOptions> &steps) const {
    std::vector<const vbm_prune_options *> pointers;
    for (const PruneOptions &step : steps) pointers.push_back(&step);
    vbm_axis *out = nullptr;
    const vbm_status status =
        vbm_axis_prune_steps(context.handle(), handle(), pointers.data(), pointers.size(), &out);
    Axis axis(out);
    context.check(status);
    return axis;
  }
  Axis remove_parts(Context &context, View<std::int32_t> parts) const {
    vbm_axis *out = nullptr;
    const vbm_status status =
        vbm_axis_remove_parts(context.handle(), handle(), parts.data, parts.size, &out);
    Axis axis(out);
    context.check(status);
    return axis;
  }
  Axis remove_triangles(Context &context, View<std::int32_t> triangles) const {
    vbm_axis *out = nullptr;
    const vbm_status status =
        vbm_axis_remove_triangles(context.handle(), handle(), triangles.data, triangles.size, &out);
    Axis axis(out);
    context.check(status);
    return axis;
  }
  Surface surface(Context &context,
                  const vbm_axis_surface_options &options = AxisSurfaceOptions()) const {
    vbm_surface *out = nullptr;
    const vbm_status status = vbm_axis_surface(context.handle(), handle(), &options, &out);
    Surface surface(out);
    context.check(status);
    return surface;
  }

private:
  template <std::size_t Width = 1, class T>
  View<T, Width> view(const T *(*get)(const vbm_axis *, std::size_t *)) const {
    View<T, Width> result;
    result.data = get(handle(), &result.size);
    return result;
  }
  Lists lists(const std::int32_t *(*get)(const vbm_axis *, const std::uint64_t **,
                                         std::size_t *)) const {
    Lists lists;
    lists.indices.data = get(handle(), &lists.offsets.data, &lists.indices.size);
    if (lists.offsets.data) lists.offsets.size = parts().size + 1;
    return lists;
  }
  struct Free {
    void operator()(vbm_axis *axis) const { vbm_axis_free(axis); }
  };
  std::unique_ptr<vbm_axis, Free> handle_;
};

inline Axis medial_axis(Context &context, const Model &model,
                        const vbm_axis_options &options = AxisOptions()) {
  vbm_axis *out = nullptr;
  const vbm_status status = vbm_model_medial_axis(context.handle(), model.handle(), &options, &out);
  Axis axis(out);
  context.check(status);
  return axis;
}

} // namespace vbm

#include <vbm/medial_mesh.hpp>

#endif // VBM_AXIS_HPP
