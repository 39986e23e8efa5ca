// SPDX-License-Identifier: GPL-3.0-or-later
#include "model.h"

#include "options.h"
#include "text.h"

namespace vbm_filters {

std::vector<Param> model_params(const std::vector<std::string> &without) {
  std::vector<Param> params = library_params("build", without);
  params.insert(
      params.begin(),
      {bool_param("ignore_faces", "Ignore Faces",
                  "Forget the layer's faces and use its vertices as bare points, as for a scan",
                  false),
       bool_param("use_normals", "Use Vertex Normals",
                  "Bare points: tell inside from outside by the vertex normals, which must point "
                  "outwards. Leave this off if the file came without normals",
                  false)});
  return params;
}

Param hide_param() {
  return bool_param("hide", "Hide This Layer",
                    "Hide the layer that the new one is made from, which would cover it", true);
}

vbm::Model build_model(vbm::Context &context, const Layer &layer, const Values &values) {
  vbm::BuildOptions options;
  set_options(options, "build", values);

  const vbm::View<double, 3> points{layer.points.data(), layer.vertex_count()};
  if (!layer.triangles.empty() && !values.flag("ignore_faces"))
    return vbm::build_mesh(
        context, points,
        vbm::View<std::int32_t, 3>{layer.triangles.data(), layer.triangles.size() / 3}, options);
  vbm::View<double, 3> normals;
  if (values.flag("use_normals") && !layer.normals.empty())
    normals = {layer.normals.data(), layer.vertex_count()};
  return vbm::build_points(context, points, normals, options);
}

void describe(const vbm::Model &model, const Layer &layer, std::vector<std::string> &log) {
  const vbm_model_report report = model.report();
  std::string input = "Took " + count(report.input_points, "vertex", "vertices");
  if (report.merged) input += ", merged " + count(report.merged);
  if (report.dropped) input += ", left out " + count(report.dropped);
  if (report.added)
    input += ", added " + count(report.added, "sample", "samples") + " on faces at a spacing of " +
             number(report.spacing);
  log.push_back(input + ": " + count(report.samples, "sample", "samples") + ".");
  log.push_back(count(report.inner_balls, "inner ball", "inner balls") + ", " +
                count(report.outer_balls, "outer ball", "outer balls") +
                "; inside told from outside by " +
                (report.rule == VBM_LABELS_NORMALS ? "normals." : "propagation from the outside."));
  add_notes(model.notes(), log);
  if (layer.transformed)
    log.push_back("The layer has a transformation matrix: lengths are those before it is applied.");
}

} // namespace vbm_filters
