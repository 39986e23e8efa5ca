// libvbm for C++: clustering. Included by vbm.hpp; adds no logic to cluster.h.
//
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VBM_CLUSTER_HPP
#define VBM_CLUSTER_HPP

#include <vbm/vbm.hpp>

namespace vbm {

struct ClusterOptions : vbm_cluster_options {
  ClusterOptions() { vbm_cluster_options_init(this, sizeof(vbm_cluster_options)); }
};

/// Fewer balls that stand for many.
class Clusters {
public:
  explicit Clusters(vbm_clusters *owned = nullptr) : handle_(owned) {}
  const vbm_clusters *handle() const { return handle_.get(); }

  View<double, 3> centers() const { return view<3>(vbm_clusters_centers); }
  View<double> radii() const { return view(vbm_clusters_radii); }
  View<double> sphericity() const { return view(vbm_clusters_sphericity); }
  View<double> gap() const { return view(vbm_clusters_gap); }
  View<std::int32_t> ball_cluster() const { return view(vbm_clusters_ball_cluster); }
  Lists balls() const {
    Lists lists;
    lists.indices.data = vbm_clusters_balls(handle(), &lists.offsets.data, &lists.indices.size);
    if (lists.offsets.data) lists.offsets.size = radii().size + 1;
    return lists;
  }
  const char *notes() const { return vbm_clusters_notes(handle()); }

  vbm_clusters_report report() const {
    vbm_clusters_report report{};
    report.struct_size = sizeof report;
    if (vbm_status status = vbm_clusters_get_report(handle(), &report))
      throw Error(status, "cannot read the clusters' report");
    return report;
  }

  vbm_cluster_error measure(Context &context, std::size_t points) const {
    vbm_cluster_error error{};
    error.struct_size = sizeof error;
    context.check(vbm_clusters_measure(context.handle(), handle(), points, &error));
    return error;
  }

private:
  template <std::size_t Width = 1, class T>
  View<T, Width> view(const T *(*get)(const vbm_clusters *, std::size_t *)) const {
    View<T, Width> result;
    result.data = get(handle(), &result.size);
    return result;
  }
  struct Free {
    void operator()(vbm_clusters *clusters) const { vbm_clusters_free(clusters); }
  };
  std::unique_ptr<vbm_clusters, Free> handle_;
};

/// `centers` and `radii` must be as long as each other.
inline Clusters cluster_balls(Context &context, View<double, 3> centers, View<double> radii,
                              const vbm_cluster_options &options = ClusterOptions()) {
  if (centers.size != radii.size)
    throw Error(VBM_ERROR_ARGUMENT, std::to_string(centers.size) + " centres, but " +
                                        std::to_string(radii.size) + " radii");
  vbm_clusters *out = nullptr;
  const vbm_status status = vbm_cluster_balls(context.handle(), centers.data, radii.data,
                                              centers.size, &options, &out);
  Clusters clusters(out);
  context.check(status);
  return clusters;
}

inline Clusters cluster(Context &context, const Model &model,
                        const vbm_cluster_options &options = ClusterOptions()) {
  vbm_clusters *out = nullptr;
  const vbm_status status = vbm_model_cluster(context.handle(), model.handle(), &options, &out);
  Clusters clusters(out);
  context.check(status);
  return clusters;
}

} // namespace vbm

#endif // VBM_CLUSTER_HPP
