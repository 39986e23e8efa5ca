// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"
#include "bind.h"
#include "errors.h"
#include "progress.h"
#include "pruning.h"
#include "reports.h"
#include "signature.h"

#include <memory>

namespace vbm::python {

namespace {

const char *const kAxisDoc =
    "The medial axis of a shape, its parts, and what is left after pruning.\n\n"
    "Made by Model.medial_axis(). prune() and remove() take parts away, undo() brings back what "
    "the\n"
    "last of them took. Its topology is the shape's, always. Arrays are read-only views of the "
    "axis "
    "as\nit is now, and stay as they are when it changes. v stands for vertices, t for triangles, "
    "e "
    "for\nedges of curves.";

// One axis; what arrays keep alive.
struct State {
  Axis axis;
};

struct MedialAxis {
  std::vector<std::shared_ptr<State>> states; // the last is the current one
  State &now() const { return *states.back(); }
};

template <class Get> auto viewed(Get get) {
  return [get](const MedialAxis &self) {
    const auto state = self.states.back();
    return output((state->axis.*get)(), py::cast(state));
  };
}

// By the numbers of vbm_lock.
constexpr const char *kLocks[] = {"", "inner", "tunnel", "bridge", "last"};

const char *lock_name(int32_t lock) { return kLocks[lock < VBM_LOCK_LAST ? lock : VBM_LOCK_LAST]; }

const char *lock_text(const std::string &locked) {
  for (int32_t lock = VBM_LOCK_NONE; lock <= VBM_LOCK_LAST; ++lock)
    if (locked == kLocks[lock]) return vbm_lock_text(lock);
  bad_argument("'" + locked + "' is no lock: '', 'inner', 'tunnel', 'bridge' and 'last' are");
}

// A part, as a named tuple.
py::handle &part_class() {
  static py::handle type;
  return type;
}

struct PartField {
  const char *name, *doc;
};
const PartField kPartFields[] = {
    {"level", "1: it has a border; 2: it touches a part of level 1; ...; 0: no border is near."},
    {"locked", "'' if it can be removed now, else why not: 'inner', 'tunnel', 'bridge' or 'last';\n"
               "lock_text() has it in words."},
    {"triangles", "Triangles; 0 for a curve."},
    {"curve_edges", "Edges of a curve; 0 for a sheet."},
    {"area", "Area of a sheet."},
    {"length", "Length of a curve."},
    {"volume", "Share of the shape's volume that it stands for, 0 to 1."},
    {"width", "Largest triangle_width, or of a curve edge_width."},
    {"angle", "Largest triangle_angle, or of a curve edge_angle, in degrees."},
    {"position", "Its middle, (x, y, z)."},
    {"balls", "The model's inner balls that go with it, int32."},
};

void bind_part(py::module_ &module) {
  py::list names;
  for (const PartField &field : kPartFields) names.append(field.name);
  const py::object type = py::module_::import("collections")
                              .attr("namedtuple")("Part", names, py::arg("module") = "vbm");
  type.attr("__doc__") = "A part of a medial axis: a sheet or a curve; a named tuple.";
  for (const PartField &field : kPartFields) type.attr(field.name).attr("__doc__") = field.doc;
  module.add_object("Part", type);
  part_class() = py::object(type).release();
}

py::list parts(const MedialAxis &self) {
  const auto state = self.states.back();
  const py::object owner = py::cast(state);
  const View<vbm_part> all = state->axis.parts();
  const Lists balls = state->axis.part_balls();
  py::list out;
  for (std::size_t i = 0; i < all.size; ++i) {
    const vbm_part &p = all[i];
    out.append(part_class()(p.level, lock_name(p.lock), p.triangles, p.curve_edges, p.area,
                            p.length, p.volume, p.width, p.angle,
                            py::make_tuple(p.position[0], p.position[1], p.position[2]),
                            output(balls[i], owner)));
  }
  return out;
}

void prune(MedialAxis &self, const Arguments &given) {
  const std::vector<PruneOptions> steps = pruning_steps(given);
  const auto state = self.states.back();
  Axis left = run(given["progress"],
                  [&](Context &context) { return state->axis.prune_steps(context, steps); });
  self.states.push_back(std::make_shared<State>(State{std::move(left)}));
}

Indices one_or_more(const Arguments &given, const char *name, const char *element) {
  const py::object which = given[name];
  py::list one;
  if (PyIndex_Check(which.ptr())) one.append(which);
  return indices(one.empty() ? which : one, name, element);
}

void remove(MedialAxis &self, const Arguments &given) {
  const bool by_part = !given["part"].is_none();
  if (by_part == !given["triangles"].is_none())
    bad_argument("remove() needs either a part or triangles");
  const Indices numbers =
      by_part ? one_or_more(given, "part", "part") : one_or_more(given, "triangles", "triangle");
  const View<int32_t> view{numbers.data(), std::size_t(numbers.size())};
  Axis left = run(given["progress"], [&](Context &context) {
    const Axis &axis = self.now().axis;
    return by_part ? axis.remove_parts(context, view) : axis.remove_triangles(context, view);
  });
  self.states.push_back(std::make_shared<State>(State{std::move(left)}));
}

py::list stayed(const MedialAxis &self) {
  const View<int32_t> parts = self.now().axis.stayed(), locks = self.now().axis.stayed_locks();
  py::list out;
  for (std::size_t i = 0; i < parts.size; ++i)
    out.append(py::make_tuple(parts[i], lock_name(locks[i])));
  return out;
}

py::dict topology_graph(const MedialAxis &self) {
  const auto state = self.states.back();
  const Lists nodes = state->axis.part_nodes();
  py::array_t<int32_t> edges({py::ssize_t(nodes.indices.size), py::ssize_t(2)});
  py::ssize_t e = 0;
  for (std::size_t p = 0; p < nodes.size(); ++p)
    for (const int32_t node : nodes[p]) {
      edges.mutable_at(e, 0) = int32_t(p);
      edges.mutable_at(e++, 1) = node;
    }
  const View<vbm_part> all = state->axis.parts();
  py::array_t<double> middles({py::ssize_t(all.size), py::ssize_t(3)});
  for (std::size_t p = 0; p < all.size; ++p)
    for (int a = 0; a < 3; ++a) middles.mutable_at(py::ssize_t(p), a) = all[p].position[a];
  py::dict graph;
  graph["nodes"] = output(state->axis.nodes(), py::cast(state));
  graph["parts"] = middles;
  graph["edges"] = edges;
  return graph;
}

void bind_arrays(py::class_<MedialAxis> &type) {
  type.def_property_readonly("vertices", viewed(&Axis::vertices),
                             "Vertices, the centres of balls: (v, 3) float64.");
  type.def_property_readonly("radii", viewed(&Axis::radii), "Their balls' radii, (v,) float64.");
  type.def_property_readonly("triangles", viewed(&Axis::triangles),
                             "Triangles, (t, 3) int32 vertex indices.");
  type.def_property_readonly(
      "triangle_samples", viewed(&Axis::triangle_samples),
      "For every triangle the two samples of the model it is equidistant from, (t, 2) int32; with\n"
      "method 'power_shape' the ones nearest to its singular points.");
  type.def_property_readonly(
      "triangle_points",
      [](const MedialAxis &self) {
        const auto state = self.states.back();
        return output(state->axis.triangle_points(), py::cast(state)).attr("reshape")(-1, 2, 3);
      },
      "For every triangle the two places it is exactly equidistant from, (t, 2, 3).");
  type.def_property_readonly("triangle_part", viewed(&Axis::triangle_part),
                             "For every triangle its part, (t,) int32.");
  type.def_property_readonly(
      "triangle_width", viewed(&Axis::triangle_width),
      "For every triangle the distance of these places, the feature's width there, (t,) float64.");
  type.def_property_readonly(
      "triangle_angle", viewed(&Axis::triangle_angle),
      "For every triangle its object angle in degrees, 0 to 180: that under which these places are "
      "seen\nfrom its ball, the mean of its corners', (t,) float64.");
  type.def_property_readonly("edges", viewed(&Axis::curves),
                             "Curves: edges of no triangle, (e, 2) int32 vertex indices.");
  type.def_property_readonly("edge_part", viewed(&Axis::curve_part),
                             "For every such edge its part, (e,) int32.");
  type.def_property_readonly(
      "edge_width", viewed(&Axis::curve_width),
      "For every such edge the smallest distance of two of the three samples it is equidistant "
      "from,\n(e,) float64; about 1.7 radii in a round tube.");
  type.def_property_readonly(
      "edge_angle", viewed(&Axis::curve_angle),
      "For every such edge the angle in degrees under which these are seen from its ball, (e,) "
      "float64.");
  type.def_property_readonly(
      "contact_edges", viewed(&Axis::contact_edges),
      "Contact curves: edges at which triangles of two parts or more meet, (c, 2) int32 vertex "
      "indices.\nSource: thesis 7.5.1, 7.5.3.");
  type.def_property_readonly("contact_node", viewed(&Axis::contact_node),
                             "For every contact edge its node, a row of topology_graph()['nodes'], "
                             "(c,) int32. Nodes where "
                             "only\ncurves meet other parts have no edge.");
  type.def_property_readonly(
      "kept_balls",
      [](const MedialAxis &self) {
        const auto state = self.states.back();
        const View<uint8_t> kept = state->axis.kept_balls();
        return output(kept.data, py::dtype("?"), kept.size, 1, py::cast(state));
      },
      "For every inner ball of the model whether it is left, bool.");
}

} // namespace

py::object axis_to_python(Axis axis) {
  MedialAxis out;
  out.states.push_back(std::make_shared<State>(State{std::move(axis)}));
  return py::cast(std::move(out));
}

std::shared_ptr<const Axis> axis_of(const py::object &axis) {
  const auto state = axis.cast<const MedialAxis &>().states.back();
  return {state, &state->axis};
}

void bind_axis(py::module_ &module) {
  py::class_<State, std::shared_ptr<State>>(module, "_AxisState",
                                            "What arrays of an axis belong to.");
  bind_part(module);
  py::class_<MedialAxis> type(module, "MedialAxis", kAxisDoc);
  bind_arrays(type);
  type.def_property_readonly("parts", parts, "The parts: a list of Part.\nSource: thesis 7.5.1.");
  type.def_property_readonly(
      "report", [](const MedialAxis &self) { return to_python(self.now().axis.report()); },
      "Counts: an AxisReport.");
  type.def_property_readonly(
      "notes", [](const MedialAxis &self) { return lines_of(self.now().axis.notes()); },
      "What the last operation has to say, a list of sentences.");

  type.def_property_readonly(
      "stayed", stayed,
      "Parts of level 1 that are left though they are below the threshold of the last prune(), "
      "least significant\nfirst: a list of (part, why), why as in Part.locked. Of several "
      "thresholds "
      "or steps those of the first,\nthen of the next that are not listed yet, and so on.");
  const Signature volumes("part_ball_volumes", {{"progress", "None", true}}, true);
  type.def(
      "part_ball_volumes",
      [volumes](const MedialAxis &self, const py::args &args, const py::kwargs &kwargs) {
        const Arguments given = volumes.bind(args, kwargs);
        const auto state = self.states.back();
        const View<double> shares = run(given["progress"], [&](Context &context) {
          return state->axis.part_ball_volumes(context);
        });
        return output(shares, py::cast(state));
      },
      volumes
          .doc(std::string("For every part its share of the exact volume of the union of all inner "
                           "balls, (p,) float64.\n\nA ball's volume is that of the union's part in "
                           "its power cell. Found when first asked for.\n\n") +
               kProgressDoc +
               "\nRaises OutOfMemory, Cancelled. Source: thesis 7.9; Edelsbrunner, \"The union of "
               "balls and\nits dual shape\" (1995).")
          .c_str());

  const Signature pruning = pruning_signature();
  type.def(
      "prune",
      [pruning](MedialAxis &self, const py::args &args, const py::kwargs &kwargs) {
        prune(self, pruning.bind(args, kwargs));
      },
      pruning
          .doc(std::string(kPruneDoc) + kProgressDoc +
               "\nRaises ArgumentError, OutOfMemory, Cancelled; the axis is then as it was.\n"
               "Source: thesis 7.5.2, 7.5.3.")
          .c_str());
  const Signature removing(
      "remove", {{"part", "None"}, {"triangles", "None"}, {"progress", "None", true}}, true);
  type.def(
      "remove",
      [removing](MedialAxis &self, const py::args &args, const py::kwargs &kwargs) {
        remove(self, removing.bind(args, kwargs));
      },
      removing
          .doc(std::string("Remove a part, or several, where the topology stays.\n\n"
                           "  part       a number in parts, or a list of them\n"
                           "  triangles  instead: a triangle of the part, or a list of triangles "
                           "of parts\n") +
               kProgressDoc +
               "\nParts may go that only others named with them hold. Raises InputError for a part "
               "that is not there\nor cannot go, saying why; the axis is then as it was. Source: "
               "thesis 7.7, Figure 7.13.")
          .c_str());
  type.def(
      "undo",
      [](MedialAxis &self) {
        if (self.states.size() < 2) return false;
        self.states.pop_back();
        return true;
      },
      Signature("undo", {}, true)
          .doc("Bring back what the last prune() or remove() took. Returns whether there was one.")
          .c_str());
  type.def(
      "copy", [](const MedialAxis &self) { return MedialAxis(self); },
      Signature("copy", {}, true)
          .doc("A second axis in the same state, with the same past, in no time and memory.\n"
               "What is pruned from one stays in the other.")
          .c_str());
  type.def(
      "topology_graph", topology_graph,
      Signature("topology_graph", {}, true)
          .doc("The topology graph, as a dict: 'nodes' (k, 3), the middles of contact curves, "
               "connected\nones taken together; 'parts' (p, 3), the middles of the parts; "
               "'edges' (m, 2) int32, a part\nand a node it touches in each row. Source: thesis "
               "7.5.3, Figures 7.8 to 7.11.")
          .c_str());
  const Signature surface("surface", {{"drop_outer", "False", true}, {"progress", "None", true}},
                          true);
  type.def(
      "surface",
      [surface](const MedialAxis &self, const py::args &args, const py::kwargs &kwargs) {
        const Arguments given = surface.bind(args, kwargs);
        AxisSurfaceOptions options;
        options.drop_outer = given.given("drop_outer") && given["drop_outer"].cast<bool>();
        const auto state = self.states.back();
        return run(given["progress"],
                   [&](Context &context) { return state->axis.surface(context, options); });
      },
      surface
          .doc(std::string("The simplified shape: the power crust of the balls that are left, with "
                           "the components and\ntunnels of the whole shape.\n\n"
                           "  drop_outer  leave out outer balls at removed parts too, for sharper "
                           "corners\n") +
               kProgressDoc +
               "\nReturns a Surface. Raises OutOfMemory, Cancelled. Source: thesis 7.6.")
          .c_str());
  type.def("__repr__", [](const MedialAxis &self) {
    const vbm_axis_report report = self.now().axis.report();
    return "<vbm.MedialAxis: " + counted(report.vertices, "vertex", "vertices") + ", " +
           counted(report.triangles, "triangle", "triangles") + ", " +
           counted(report.parts, "part", "parts") + ">";
  });

  const Signature in_words("lock_text", {{"locked"}});
  module.def(
      "lock_text",
      [in_words](const py::args &args, const py::kwargs &kwargs) {
        const py::object locked = in_words.bind(args, kwargs)["locked"];
        if (!py::isinstance<py::str>(locked))
          throw py::type_error(std::string("locked must be a str, not ") +
                               Py_TYPE(locked.ptr())->tp_name);
        return lock_text(locked.cast<std::string>());
      },
      in_words
          .doc("Part.locked in words, for messages: \"the shape would fall apart\"; '' for ''.\n\n"
               "Raises ArgumentError for a word that is no lock.")
          .c_str());
}

} // namespace vbm::python
