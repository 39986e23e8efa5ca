# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators: the topology graph and the curve skeleton of a medial axis as objects."""

import bpy

from . import axis_object, creation, graph_object, options, session, skeleton_object
from .axis_operator import AxisOperator, follower


class _Graphs(AxisOperator):
    """Mixin: makes the object of one kind, or brings the one there is up to date."""

    kind = ""

    def new_steps(self, context, obj, done):
        return done

    def _prepare(self, context):
        obj, request = super()._prepare(context)
        request.wanted.surface = False  # it stays as it is
        request.wanted.skeleton = self.skeleton_arguments()
        return obj, request

    def skeleton_arguments(self):
        return None

    def finish(self, context, obj, request, result):
        old = follower(context, obj, self.kind)
        with creation.undone_on_failure() as made:
            if old is None:
                new = self.make(made, obj.vbm_axis.source, result)
                creation.show_results(context, [new], obj, "KEEP")
            else:
                data = self.make(made, obj.vbm_axis.source, result, old.data.name)
        if old is None:
            axis_object.tie({"axis": obj, self.kind: new})
        else:
            creation.swap_data(old, data)
            creation.select_alone(context, old)
        return session.Outcome(*self.told(old or new, result), self.notes(result))

    def notes(self, result):
        return []


class VBM_OT_topology_graph(_Graphs, bpy.types.Operator):
    """Make an object of the topology graph: a ball where parts of the medial axis meet, and a line \
from there to the middle of each part. A loop of it is a tunnel of the shape"""

    bl_idname = "vbm.topology_graph"
    bl_label = "Topology Graph"
    doing = "Making the topology graph"
    kind = "graph"

    def make(self, made, origin, result, mesh_name=None):
        diagonal = result.built.model.report.diagonal
        if mesh_name is None:
            return graph_object.make(made, result.axis, origin, diagonal)
        return graph_object.new_mesh(made, mesh_name, result.axis, diagonal)

    def told(self, obj, result):
        graph = result.axis.topology_graph()
        return (f"{obj.name}: {len(graph['nodes']):,} nodes, {len(graph['parts']):,} parts",
                ["Nodes are white; parts have the colours of the axis"])


class SkeletonOptions:
    """For operators that compute a curve skeleton."""

    __annotations__ = options.properties_of("curve_skeleton", set())


SKELETON_NAMES = tuple(SkeletonOptions.__annotations__)


class VBM_OT_curve_skeleton(SkeletonOptions, _Graphs, bpy.types.Operator):
    """Make a curve object of the medial axis shrunk to curves, with all tunnels kept. The radius of \
each point is that of its ball"""

    bl_idname = "vbm.curve_skeleton"
    bl_label = "Curve Skeleton"
    doing = "Shrinking the axis to curves"
    kind = "skeleton"

    def skeleton_arguments(self):
        return options.arguments_of(self, SKELETON_NAMES)

    def finish(self, context, obj, request, result):
        outcome = super().finish(context, obj, request, result)
        # As it is made anew when the axis changes.
        request.recipe.skeleton = request.wanted.skeleton
        obj.vbm_axis.recipe = request.recipe.dumps()
        return outcome

    def notes(self, result):
        return skeleton_object.notes(result.skeleton)

    def make(self, made, origin, result, curve_name=None):
        if curve_name is None:
            return skeleton_object.make(made, result.skeleton, origin)
        return skeleton_object.new_curve(made, curve_name, result.skeleton)

    def told(self, obj, result):
        return (f"{obj.name}: {len(obj.data.splines):,} branches",
                [f"{len(result.skeleton.vertices):,} points"])


_CLASSES = (VBM_OT_topology_graph, VBM_OT_curve_skeleton)


def register():
    for cls in _CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
