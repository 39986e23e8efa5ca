// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"
#include "bind.h"
#include "reports.h"
#include "signature.h"

namespace vbm::python {

namespace {

const char *const kSurfaceDoc = "A closed surface, oriented outward and manifold: every edge has "
                                "two faces, every vertex a disk\n"
                                "round it.\n\n"
                                "Made by Model.surface() and Model.power_crust(); never changes "
                                "afterwards. Arrays are read-only\n"
                                "views of the surface's own memory, and keep it alive. v stands "
                                "for vertices, t for triangles, q\n"
                                "for polygons.";

const char *const kPolygonsDoc = "The polygons of a surface: a sequence of int32 arrays of "
                                 "vertices, counter-clockwise seen from\n"
                                 "outside. len(), indices and iteration work as for a list.";

// What Surface.polygons gives; a class so that iterating over it gives polygons.
struct Polygons {
  py::object surface;
  Lists lists;
};

template <class Get> auto viewed(Get get) {
  return
      [get](const py::object &self) { return output((self.cast<const Surface &>().*get)(), self); };
}

void bind_polygons(py::module_ &module) {
  py::class_<Polygons> type(module, "Polygons", kPolygonsDoc);
  type.def_property_readonly(
      "offsets", [](const Polygons &p) { return output(p.lists.offsets, p.surface); },
      "Where in corners each polygon begins, and where the last one ends: (q + 1,) uint64.");
  type.def_property_readonly(
      "corners", [](const Polygons &p) { return output(p.lists.indices, p.surface); },
      "The vertices of all polygons, one polygon after another, int32: polygon i is\n"
      "corners[offsets[i]:offsets[i + 1]].");
  type.def("__len__", [](const Polygons &p) { return p.lists.size(); });
  // Python iterates over whatever has this and raises IndexError at its end.
  type.def("__getitem__", [](const Polygons &p, py::ssize_t index) {
    return output_row(p.lists, p.surface, index, "polygon");
  });
  type.def("__repr__", [](const Polygons &p) {
    return "<vbm.Polygons: " + counted(p.lists.size(), "polygon", "polygons") + ">";
  });
}

} // namespace

void bind_surface(py::module_ &module) {
  bind_polygons(module);
  py::class_<Surface> type(module, "Surface", kSurfaceDoc);
  type.def_property_readonly("vertices", viewed(&Surface::vertices), "Vertices, (v, 3) float64.");
  type.def_property_readonly(
      "triangles", viewed(&Surface::triangles),
      "Triangles, (t, 3) int32 vertex indices, counter-clockwise seen from outside.");
  type.def_property_readonly(
      "polygons",
      [](const py::object &self) {
        return Polygons{self, self.cast<const Surface &>().polygons()};
      },
      "The faces, as Polygons: for the interpolating surface its triangles, for the power crust "
      "the\n"
      "faces of the power diagram. The triangles are these polygons cut up.");
  type.def_property_readonly("triangle_polygon", viewed(&Surface::triangle_polygon),
                             "For every triangle its polygon, (t,) int32.");
  type.def_property_readonly(
      "polygon_ball", viewed(&Surface::polygon_ball),
      "For every polygon the inner ball behind it, an index into the model's "
      "balls; -1 where there\nis none. (q,) int32.");
  type.def_property_readonly("vertex_sample", viewed(&Surface::vertex_sample),
                             "For every vertex the sample it coincides with, or -1; (v,) int32.");
  type.def_property_readonly(
      "vertex_input", viewed(&Surface::vertex_input),
      "For every vertex the input point it coincides with, or -1; (v,) int32.");
  type.def_property_readonly(
      "vertex_radius", viewed(&Surface::vertex_radius),
      "For every vertex the radius of an inner ball it touches: the polar ball "
      "of its sample, or\nthe largest ball of the polygons round it. (v,) "
      "float64.");
  type.def_property_readonly(
      "report", [](const Surface &surface) { return to_python(surface.report()); },
      "Counts and measures: a SurfaceReport.");
  type.def_property_readonly(
      "notes", [](const Surface &surface) { return lines_of(surface.notes()); },
      "What a user should know about this surface: a list of sentences, empty if there is nothing "
      "to\nsay.");
  type.def("__repr__", [](const Surface &surface) {
    const vbm_surface_report report = surface.report();
    return "<vbm.Surface: " + counted(report.vertices, "vertex", "vertices") + ", " +
           counted(report.triangles, "triangle", "triangles") + ", " +
           counted(report.components, "component", "components") + ", genus " +
           std::to_string(report.genus) + ">";
  });
}

} // namespace vbm::python
