// libvbm for C++: medial meshes. Included by axis.hpp; adds no logic to medial_mesh.h.
//
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VBM_MEDIAL_MESH_HPP
#define VBM_MEDIAL_MESH_HPP

#include <vbm/axis.hpp>

namespace vbm {

struct SimplifyOptions : vbm_simplify_options {
  SimplifyOptions() { vbm_simplify_options_init(this, sizeof(vbm_simplify_options)); }
};
struct CurveSkeletonOptions : vbm_curve_skeleton_options {
  CurveSkeletonOptions() {
    vbm_curve_skeleton_options_init(this, sizeof(vbm_curve_skeleton_options));
  }
};

/// A simplicial complex whose vertices are balls.
class MedialMesh {
public:
  explicit MedialMesh(vbm_medial_mesh *owned = nullptr) : handle_(owned) {}
  const vbm_medial_mesh *handle() const { return handle_.get(); }

  View<double, 3> vertices() const { return view<3>(vbm_medial_mesh_vertices); }
  View<double> radii() const { return view(vbm_medial_mesh_radii); }
  View<std::int32_t, 3> triangles() const { return view<3>(vbm_medial_mesh_triangles); }
  View<std::int32_t, 2> edges() const { return view<2>(vbm_medial_mesh_edges); }
  const char *notes() const { return vbm_medial_mesh_notes(handle()); }

  vbm_medial_mesh_report report() const {
    vbm_medial_mesh_report report{};
    report.struct_size = sizeof report;
    if (vbm_status status = vbm_medial_mesh_get_report(handle(), &report))
      throw Error(status, "cannot read the medial mesh's report");
    return report;
  }

private:
  template <std::size_t Width = 1, class T>
  View<T, Width> view(const T *(*get)(const vbm_medial_mesh *, std::size_t *)) const {
    View<T, Width> result;
    result.data = get(handle(), &result.size);
    return result;
  }
  struct Free {
    void operator()(vbm_medial_mesh *mesh) const { vbm_medial_mesh_free(mesh); }
  };
  std::unique_ptr<vbm_medial_mesh, Free> handle_;
};

inline MedialMesh simplify(Context &context, const Axis &axis,
                           const vbm_simplify_options &options = SimplifyOptions()) {
  vbm_medial_mesh *out = nullptr;
  const vbm_status status = vbm_axis_simplify(context.handle(), axis.handle(), &options, &out);
  MedialMesh mesh(out);
  context.check(status);
  return mesh;
}

inline MedialMesh
curve_skeleton(Context &context, const Axis &axis,
               const vbm_curve_skeleton_options &options = CurveSkeletonOptions()) {
  vbm_medial_mesh *out = nullptr;
  const vbm_status status =
      vbm_axis_curve_skeleton(context.handle(), axis.handle(), &options, &out);
  MedialMesh mesh(out);
  context.check(status);
  return mesh;
}

} // namespace vbm

#endif // VBM_MEDIAL_MESH_HPP
