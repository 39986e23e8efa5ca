// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind.h"
#include "cluster.h"
#include "files.h"
#include "errors.h"
#include "options.h"
#include "progress.h"
#include "reports.h"

namespace {

const char *const kDoc =
    "Voronoi ball models of shapes, and closed surfaces back from them.\n\n"
    "    import vbm\n"
    "    model = vbm.build(points)              # (n, 3) array; triangles too, if there are any\n"
    "    model.centers, model.radii             # the balls, inner ones first\n"
    "    model.thickness                        # one number for each point\n"
    "    surface = model.surface()              # closed, through the points\n"
    "    surface.vertices, surface.triangles\n\n"
    "build(), build_volume() and build_range_scan() make a Model; Model.surface() and\n"
    "Model.power_crust() make a Surface. What goes wrong is raised as a subclass of Error, whose\n"
    "message says what and where. cluster() makes few balls of many, read_balls() and write_balls()\n"
    "keep balls in files. \"Thesis\" in the help texts is R. Tam, \"Voronoi Ball Models "
    "for\n"
    "Computational Shape Applications\".";

} // namespace

PYBIND11_MODULE(vbm, module) {
  using namespace vbm::python;
  if (vbm_abi_version() != VBM_ABI_VERSION)
    throw py::import_error("the vbm module was built for ABI version " +
                           std::to_string(VBM_ABI_VERSION) + " of libvbm, but found version " +
                           std::to_string(vbm_abi_version()));
  py::options options;
  options.disable_function_signatures(); // ours are in the form help() and inspect understand
  module.doc() = kDoc;
  module.attr("__version__") = vbm_version();
  module.attr("abi_version") = vbm_abi_version();
  bind_errors(module);
  bind_reports(module);
  bind_threads(module);
  bind_surface(module);
  bind_axis(module);
  bind_medial_mesh(module);
  bind_cluster(module);
  bind_files(module);
  bind_model(module);
  bind_build(module);
  bind_balls(module);
  bind_parameters(module);
}
