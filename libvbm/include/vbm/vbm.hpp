// libvbm for C++: owning handles, views and one exception over vbm.h. Header-only, C++17.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nothing is decided here: every function is the one of the same name in vbm.h, whose comments say
// what it does, in which units, and what can go wrong. A failed call throws vbm::Error.
//
//   vbm::Context context;
//   vbm::Model model = vbm::build_points(context, {xyz.data(), xyz.size() / 3});
//   vbm::Surface surface = model.surface(context);
//   for (std::size_t i = 0; i < surface.triangles().size; ++i) use(surface.triangles()[i]);
#ifndef VBM_VBM_HPP
#define VBM_VBM_HPP

#include <vbm/vbm.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace vbm {

/// A failed call. what() is the library's sentence; `elements` are the input elements it is about
/// (at most the first 4096 of `total`), `kind` what they are: "vertex", "face", "normal", "option"
/// or "".
class Error : public std::runtime_error {
public:
  Error(vbm_status status, const std::string &message, std::string kind = {},
        std::vector<std::int64_t> elements = {}, std::size_t total = 0)
      : std::runtime_error(message), status(status), kind(std::move(kind)),
        elements(std::move(elements)), total(total) {}

  vbm_status status;
  std::string kind;
  std::vector<std::int64_t> elements;
  std::size_t total;
};

/// `size` rows of `Width` numbers each, owned by somebody else: by the caller for input, by the
/// handle it was read from for output. Row i is view[i]: a number, or a pointer to the first of
/// `Width`.
template <class T, std::size_t Width = 1> struct View {
  const T *data = nullptr;
  std::size_t size = 0;

  bool empty() const { return size == 0; }
  const T *begin() const { return data; }
  const T *end() const { return data ? data + size * Width : data; }
  decltype(auto) operator[](std::size_t i) const {
    if constexpr (Width == 1)
      return (data[i]); // a reference
    else
      return data + i * Width;
  }
};

/// A list of lists: list i is indices[offsets[i]] to indices[offsets[i + 1] - 1].
struct Lists {
  View<std::uint64_t> offsets;
  View<std::int32_t> indices;

  std::size_t size() const { return offsets.empty() ? 0 : offsets.size - 1; }
  View<std::int32_t> operator[](std::size_t i) const {
    return {indices.data + offsets[i], std::size_t(offsets[i + 1] - offsets[i])};
  }
};

/// vbm_build_options with its defaults filled in.
struct BuildOptions : vbm_build_options {
  BuildOptions() { vbm_build_options_init(this, sizeof(vbm_build_options)); }
};

/// What every call needs: errors and progress. One thread at a time.
class Context {
public:
  /// Return true to cancel. An exception thrown here cancels too, and comes out of the call.
  using Progress = std::function<bool(double fraction, const char *stage)>;

  Context() : state_(new State) {
    switch (vbm_context_create(&state_->handle)) {
    case VBM_OK:
      break;
    case VBM_ERROR_MEMORY:
      throw std::bad_alloc();
    default:
      throw Error(VBM_ERROR_INTERNAL, "cannot create a context");
    }
  }

  vbm_context *handle() const { return state_->handle; }

  void set_progress(Progress progress) {
    state_->progress = std::move(progress);
    vbm_context_set_progress(handle(), state_->progress ? &State::call : nullptr, state_.get());
  }

  /// See vbm_context_set_threads().
  void set_threads(int most) { vbm_context_set_threads(handle(), most); }

  /// Throw what a finished call has to say, if anything: the functions below do it themselves.
  void check(vbm_status status) {
    if (std::exception_ptr thrown = std::exchange(state_->thrown, nullptr))
      std::rethrow_exception(thrown);
    if (status == VBM_OK) return;
    const char *kind = "";
    std::size_t count = 0, total = 0;
    const std::int64_t *elements = vbm_context_bad_elements(handle(), &kind, &count, &total);
    throw Error(status, vbm_context_message(handle()), kind ? kind : "",
                std::vector<std::int64_t>(elements, elements + count), total);
  }

private:
  struct State {
    vbm_context *handle = nullptr;
    Progress progress;
    std::exception_ptr thrown;

    State() = default;
    State(const State &) = delete;
    State &operator=(const State &) = delete;
    ~State() { vbm_context_free(handle); }

    // No exception may pass through the C interface: keep it for check().
    static int call(void *user, double fraction, const char *stage) noexcept {
      State &self = *static_cast<State *>(user);
      try {
        return self.progress(fraction, stage);
      } catch (...) {
        self.thrown = std::current_exception();
        return 1;
      }
    }
  };
  std::unique_ptr<State> state_; // on the heap, so that the library's pointer to it survives a move
};

/// A closed triangle and polygon surface.
class Surface {
public:
  explicit Surface(vbm_surface *owned = nullptr) : handle_(owned) {}
  const vbm_surface *handle() const { return handle_.get(); }

  View<double, 3> vertices() const { return view<3>(vbm_surface_vertices); }
  View<std::int32_t, 3> triangles() const { return view<3>(vbm_surface_triangles); }
  Lists polygons() const {
    Lists lists;
    lists.indices.data = vbm_surface_polygons(handle(), &lists.offsets.data, &lists.indices.size);
    if (lists.offsets.data) lists.offsets.size = std::size_t(report().polygons) + 1;
    return lists;
  }
  View<std::int32_t> triangle_polygon() const { return view(vbm_surface_triangle_polygon); }
  View<std::int32_t> polygon_ball() const { return view(vbm_surface_polygon_ball); }
  View<std::int32_t> vertex_sample() const { return view(vbm_surface_vertex_sample); }
  View<std::int32_t> vertex_input() const { return view(vbm_surface_vertex_input); }
  View<double> vertex_radius() const { return view(vbm_surface_vertex_radius); }
  const char *notes() const { return vbm_surface_notes(handle()); }

  vbm_surface_report report() const {
    vbm_surface_report report{};
    report.struct_size = sizeof report;
    if (vbm_status status = vbm_surface_get_report(handle(), &report))
      throw Error(status, "cannot read the surface's report");
    return report;
  }

private:
  template <std::size_t Width = 1, class T>
  View<T, Width> view(const T *(*get)(const vbm_surface *, std::size_t *)) const {
    View<T, Width> result;
    result.data = get(handle(), &result.size);
    return result;
  }
  struct Free {
    void operator()(vbm_surface *surface) const { vbm_surface_free(surface); }
  };
  std::unique_ptr<vbm_surface, Free> handle_;
};

/// A Voronoi ball model.
class Model {
public:
  explicit Model(vbm_model *owned = nullptr) : handle_(owned) {}
  const vbm_model *handle() const { return handle_.get(); }

  View<double, 3> centers() const { return view<3>(vbm_model_centers); }
  View<double> radii() const { return view(vbm_model_radii); }
  View<std::uint8_t> inside() const { return view(vbm_model_inside); }
  std::size_t inner_count() const { return vbm_model_inner_count(handle()); }
  Lists ball_samples() const { return lists(vbm_model_ball_samples); }
  Lists ball_neighbors() const { return lists(vbm_model_ball_neighbors); }
  View<double, 3> samples() const { return view<3>(vbm_model_samples); }
  View<std::int32_t> sample_input() const { return view(vbm_model_sample_input); }
  View<std::int32_t> input_sample() const { return view(vbm_model_input_sample); }
  View<std::int32_t> undersampled() const { return view(vbm_model_undersampled); }
  View<double> inner_radius() const { return view(vbm_model_inner_radius); }
  View<double> outer_radius() const { return view(vbm_model_outer_radius); }
  const char *notes() const { return vbm_model_notes(handle()); }

  vbm_model_report report() const {
    vbm_model_report report{};
    report.struct_size = sizeof report;
    if (vbm_status status = vbm_model_get_report(handle(), &report))
      throw Error(status, "cannot read the model's report");
    return report;
  }

  Surface surface(Context &context) const {
    vbm_surface *out = nullptr;
    const vbm_status status = vbm_model_surface(context.handle(), handle(), &out);
    Surface surface(out);
    context.check(status);
    return surface;
  }
  Surface power_crust(Context &context) const { return crust(context, {}); }
  Surface power_crust(Context &context, View<std::uint8_t> keep) const {
    static const std::uint8_t nothing = 0; // an empty mask is not the same as no mask
    if (!keep.data) keep.data = &nothing;
    return crust(context, keep);
  }

private:
  Surface crust(Context &context, View<std::uint8_t> keep) const {
    vbm_surface *out = nullptr;
    const vbm_status status =
        vbm_model_power_crust(context.handle(), handle(), keep.data, keep.size, &out);
    Surface surface(out);
    context.check(status);
    return surface;
  }
  template <std::size_t Width = 1, class T>
  View<T, Width> view(const T *(*get)(const vbm_model *, std::size_t *)) const {
    View<T, Width> result;
    result.data = get(handle(), &result.size);
    return result;
  }
  Lists lists(const std::int32_t *(*get)(const vbm_model *, const std::uint64_t **,
                                         std::size_t *)) const {
    Lists lists;
    lists.indices.data = get(handle(), &lists.offsets.data, &lists.indices.size);
    if (lists.offsets.data) lists.offsets.size = radii().size + 1;
    return lists;
  }
  struct Free {
    void operator()(vbm_model *model) const { vbm_model_free(model); }
  };
  std::unique_ptr<vbm_model, Free> handle_;
};

/// Empty `normals`: none are known.
inline Model build_points(Context &context, View<double, 3> points, View<double, 3> normals = {},
                          const vbm_build_options &options = BuildOptions()) {
  if (normals.data && normals.size != points.size)
    throw Error(VBM_ERROR_ARGUMENT, "there must be as many normals as points", "normal");
  vbm_model *out = nullptr;
  const vbm_status status =
      vbm_build_points(context.handle(), points.data, points.size, normals.data, &options, &out);
  Model model(out);
  context.check(status);
  return model;
}

/// Polygons: how many corners each face has, and the corners of all faces, one after another.
inline Model build_mesh(Context &context, View<double, 3> vertices, View<std::uint32_t> face_sizes,
                        View<std::int32_t> corners,
                        const vbm_build_options &options = BuildOptions()) {
  static const std::uint32_t nothing = 0; // no faces at all is not the same as triangles
  vbm_model *out = nullptr;
  const vbm_status status = vbm_build_mesh(
      context.handle(), vertices.data, vertices.size, face_sizes.data ? face_sizes.data : &nothing,
      corners.data, corners.size, face_sizes.size, &options, &out);
  Model model(out);
  context.check(status);
  return model;
}

/// Triangles.
inline Model build_mesh(Context &context, View<double, 3> vertices, View<std::int32_t, 3> triangles,
                        const vbm_build_options &options = BuildOptions()) {
  vbm_model *out = nullptr;
  const vbm_status status =
      vbm_build_mesh(context.handle(), vertices.data, vertices.size, nullptr, triangles.data,
                     3 * triangles.size, triangles.size, &options, &out);
  Model model(out);
  context.check(status);
  return model;
}

/// A box of voxels: voxel (i, j, k) is values[(i * size[1] + j) * size[2] + k].
struct Volume {
  const void *values = nullptr;
  vbm_scalar type = VBM_SCALAR_DOUBLE;
  std::size_t size[3] = {0, 0, 0};
  double voxel_size[3] = {1, 1, 1};
  double origin[3] = {0, 0, 0};
  double level = 0.5;
};

inline Model build_volume(Context &context, const Volume &volume,
                          const vbm_build_options &options = BuildOptions()) {
  vbm_model *out = nullptr;
  const vbm_status status = vbm_build_volume(
      context.handle(), volume.values, volume.type, volume.size[0], volume.size[1], volume.size[2],
      volume.voxel_size, volume.origin, volume.level, &options, &out);
  Model model(out);
  context.check(status);
  return model;
}

/// Empty `scanner_of_point`: one scanner for all points, or one for each.
inline Model build_range_scan(Context &context, View<double, 3> points, View<double, 3> scanners,
                              View<std::int32_t> scanner_of_point = {},
                              const vbm_build_options &options = BuildOptions()) {
  if (scanner_of_point.data && scanner_of_point.size != points.size)
    throw Error(VBM_ERROR_ARGUMENT, "there must be as many scanner indices as points");
  vbm_model *out = nullptr;
  const vbm_status status =
      vbm_build_range_scan(context.handle(), points.data, points.size, scanners.data, scanners.size,
                           scanner_of_point.data, &options, &out);
  Model model(out);
  context.check(status);
  return model;
}

/// The parameter table, all of it.
inline std::vector<vbm_param> parameters() {
  std::vector<vbm_param> table(vbm_param_count());
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i].struct_size = sizeof(vbm_param);
    if (vbm_status status = vbm_param_describe(i, &table[i]))
      throw Error(status, "cannot read the parameter table");
  }
  return table;
}

} // namespace vbm

#include <vbm/axis.hpp>
#include <vbm/balls.hpp>
#include <vbm/cluster.hpp>

#endif // VBM_VBM_HPP
