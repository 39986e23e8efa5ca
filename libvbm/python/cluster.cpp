// SPDX-License-Identifier: GPL-3.0-or-later
#include "cluster.h"

#include "arrays.h"
#include "errors.h"
#include "options.h"
#include "progress.h"
#include "reports.h"

namespace vbm::python {

namespace {

const char *const kClustersDoc =
    "Fewer balls that stand for many, each for the cluster of balls it encloses.\n\n"
    "Made by cluster() and Model.cluster(); never changes afterwards. Arrays are read-only views of "
    "its own\nmemory, and keep it alive. k stands for clusters, n for the balls given.";

const char *const kParametersDoc =
    "  sphericity      how much of a ball that replaces others one of them fills, by radius, at\n"
    "                  least: 0.01 to 1. 0.95 leaves out what is redundant, 0.8 keeps the rough shape\n"
    "  count           instead: the best so many balls. 0: as many as the sphericity makes\n"
    "  measure         what tells how well one ball stands for others. 'enclosing': the largest of\n"
    "                  them; 'union': all balls round its sphere; as exact, fewer balls, takes\n"
    "                  longer\n";

const char *const kSource =
    "\nReturns Clusters. Raises InputError for what is no ball, naming it; ArgumentError, "
    "OutOfMemory,\nCancelled. Source: thesis 4.4.1; Ranjan, Fournier, \"Matching and interpolation "
    "of shapes using\nunions of circles\" (1996).";

const char *const kErrorDoc =
    "How far the boundary moved, measured both ways: from the boundary of the clusters' balls to "
    "that of the\nunion of the balls given, and back.\n\n"
    "  points          about how many points of each boundary to look at; at least one for every ball\n";

std::vector<Parameter> options_after(std::vector<Parameter> first) {
  for (Parameter &p : std::vector<Parameter>{{"sphericity", "0.95"},
                                             {"count", "0", true},
                                             {"measure", "'enclosing'", true},
                                             {"progress", "None", true}})
    first.push_back(std::move(p));
  return first;
}

ClusterOptions options_of(const Arguments &given) {
  ClusterOptions options;
  options.sphericity = number_option(table_row("cluster", "sphericity"), given);
  options.count = count_option(table_row("cluster", "count"), given);
  options.measure = enum_option(table_row("cluster", "measure"), given);
  return options;
}

template <class Get> auto viewed(Get get) {
  return [get](const py::object &self) {
    return output((self.cast<const Clusters &>().*get)(), self);
  };
}

void bind_arrays(py::class_<Clusters> &type) {
  type.def_property_readonly("centers", viewed(&Clusters::centers),
                             "Centres of the balls, one a cluster, (k, 3) float64.");
  type.def_property_readonly("radii", viewed(&Clusters::radii), "Their radii, (k,) float64.");
  type.def_property_readonly(
      "sphericity", viewed(&Clusters::sphericity),
      "How well each ball stands for its cluster, up to 1, (k,) float64.\nSource: Figure 4.2.");
  type.def_property_readonly(
      "gap", viewed(&Clusters::gap),
      "For every cluster a length that no point of its ball's sphere is farther than from the union "
      "of\nthe balls given, (k,) float64.");
  type.def_property_readonly("ball_cluster", viewed(&Clusters::ball_cluster),
                             "For every ball given its cluster, (n,) int32.");
  type.def_property_readonly(
      "balls", viewed(&Clusters::balls),
      "The balls of each cluster, as a pair (offsets, indices): cluster i has\n"
      "indices[offsets[i]:offsets[i + 1]], the largest first. (k + 1,) uint64 and int32.");
}

} // namespace

const Signature &model_cluster_signature() {
  static const Signature signature("cluster", options_after({}), true);
  return signature;
}

std::string model_cluster_doc() {
  return "Fewer balls: each stands for a cluster of the inner balls, which it encloses.\n\n" +
         std::string(kParametersDoc) + kProgressDoc + kSource;
}

Clusters cluster_model(const Model &model, const Arguments &given) {
  const ClusterOptions options = options_of(given);
  return run(given["progress"],
             [&](Context &context) { return cluster(context, model, options); });
}

void bind_cluster(py::module_ &module) {
  py::class_<Clusters> type(module, "Clusters", kClustersDoc);
  bind_arrays(type);
  type.def_property_readonly(
      "report", [](const Clusters &self) { return to_python(self.report()); },
      "Counts and errors: a ClustersReport.");
  type.def_property_readonly(
      "notes", [](const Clusters &self) { return lines_of(self.notes()); },
      "What a user should know about these clusters: a list of sentences.");
  const Signature error("error", {{"points", "20000"}, {"progress", "None", true}}, true);
  type.def(
      "error",
      [error](const Clusters &self, const py::args &args, const py::kwargs &kwargs) {
        const Arguments given = error.bind(args, kwargs);
        const py::object points = given.given("points") ? given["points"] : py::int_(20000);
        if (!PyIndex_Check(points.ptr()) || py::isinstance<py::bool_>(points))
          throw py::type_error("points must be a whole number");
        const auto wide = points.cast<long long>();
        if (wide < 1) bad_argument("points must be at least 1, not " + std::to_string(wide));
        return to_python(run(given["progress"], [&](Context &context) {
          return self.measure(context, std::size_t(wide));
        }));
      },
      error
          .doc(std::string(kErrorDoc) + kProgressDoc +
               "\nReturns a ClusterError. Theorem 3.3 bounds its outward, not its inward. Raises "
               "ArgumentError,\nOutOfMemory, Cancelled.")
          .c_str());
  type.def("__repr__", [](const Clusters &self) {
    const vbm_clusters_report report = self.report();
    return "<vbm.Clusters: " + counted(report.clusters, "ball", "balls") + " for " +
           std::to_string(report.balls) + ">";
  });

  const Signature signature("cluster", options_after({{"centers"}, {"radii"}}));
  module.def(
      "cluster",
      [signature](const py::args &args, const py::kwargs &kwargs) {
        const Arguments given = signature.bind(args, kwargs);
        const Doubles centers = rows_of_3(given["centers"], "centers");
        const Doubles radii = radii_of(given["radii"], centers.shape(0));
        const ClusterOptions options = options_of(given);
        return run(given["progress"], [&](Context &context) {
          return cluster_balls(context, view_of_3(centers),
                               View<double>{radii.data(), std::size_t(radii.size())}, options);
        });
      },
      signature
          .doc(std::string("Fewer balls: each stands for a cluster of those given, which it "
                           "encloses.\n\n"
                           "  centers         (n, 3) array; for disks of a plane with a common z\n"
                           "  radii           (n,) array\n") +
               kParametersDoc + kProgressDoc + kSource)
          .c_str());
}

} // namespace vbm::python
