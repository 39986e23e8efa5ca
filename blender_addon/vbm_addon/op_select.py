# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators: select what an error was about, and the vertices where the sampling is too thin."""

import bpy
import numpy as np
from mathutils import kdtree

from . import build_text, creation, model, options, session
from .job_operator import JobOperator


def select_elements(context, obj, kind, indices):
    """Select nothing but these vertices or faces of a mesh object, in Edit Mode."""
    if obj.mode == "EDIT":
        bpy.ops.object.mode_set(mode="OBJECT")
    obj.hide_set(False)
    creation.select_alone(context, obj)
    mesh = obj.data
    for elements in (mesh.vertices, mesh.edges, mesh.polygons):
        elements.foreach_set("select", np.zeros(len(elements), dtype=bool))
    chosen = mesh.vertices if kind == "vertex" else mesh.polygons
    for index in indices:
        chosen[index].hide = False
        chosen[index].select = True
        if kind == "face":
            for vertex in chosen[index].vertices:
                mesh.vertices[vertex].hide = False
                mesh.vertices[vertex].select = True
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_mode(type="VERT" if kind == "vertex" else "FACE")


class VBM_OT_select_faulty(bpy.types.Operator):
    """Select the vertices or faces that the last error is about"""

    bl_idname = "vbm.select_faulty"
    bl_label = "Select What Is Wrong"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        last = session.last
        obj = context.view_layer.objects.get(last.object_name)
        if not last.elements:
            cls.poll_message_set("The last run did not end with an error about parts of the mesh")
        elif obj is None or obj.type != "MESH":
            cls.poll_message_set(f"{last.object_name} is gone")
        elif context.mode not in {"OBJECT", "EDIT_MESH"}:
            cls.poll_message_set("Works in Object Mode and Edit Mode")
        else:
            return True
        return False

    def execute(self, context):
        last = session.last
        obj = context.view_layer.objects[last.object_name]
        count = len(obj.data.vertices if last.kind == "vertex" else obj.data.polygons)
        if max(last.elements) >= count:
            self.report({"ERROR"}, f"{obj.name} has changed since: run the operator again")
            return {"CANCELLED"}
        select_elements(context, obj, last.kind, last.elements)
        noun = {"vertex": "vertices", "face": "faces"}[last.kind]
        more = f", the first of {last.total:,}" if last.total > len(last.elements) else ""
        self.report({"INFO"}, f"Selected {len(last.elements):,} {noun}{more}")
        return {"FINISHED"}


class VBM_OT_select_undersampled(JobOperator, options.OwnMeshOptions, bpy.types.Operator):
    """Select the vertices of the active mesh round which its sampling is too thin to trust a \
surface rebuilt from it"""

    bl_idname = "vbm.select_undersampled"
    bl_label = "Select Undersampled Vertices"
    doing = "Looking for thin sampling"
    source_types = {"MESH"}
    modes = {"OBJECT", "EDIT_MESH"}

    def work(self, request, progress):
        return model.build(request, progress)

    def finish(self, context, obj, request, built):
        vertices = _undersampled_vertices(built.model, request.source.points)
        select_elements(context, obj, "vertex", vertices)
        count = len(vertices)
        title = (f"{obj.name}: {count:,} vertices are undersampled" if count
                 else f"{obj.name} is sampled densely enough everywhere")
        lines = [] if not count else ["Refine the mesh there, or take a smaller sample spacing"]
        return session.Outcome(title, lines + [build_text.line(built.model.report)])

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        options.draw_source(layout, self)
        options.draw_build(layout, self, rare=False)


def _undersampled_vertices(ball_model, points):
    """Input vertices that are undersampled, or the nearest one to an added sample that is."""
    samples = np.asarray(ball_model.undersampled)
    vertices = np.asarray(ball_model.sample_input)[samples]
    chosen = set(vertices[vertices >= 0].tolist())
    added = np.asarray(ball_model.samples)[samples[vertices < 0]]
    if len(added):
        tree = kdtree.KDTree(len(points))
        for index, point in enumerate(points.tolist()):
            tree.insert(point, index)
        tree.balance()
        chosen.update(tree.find(point)[1] for point in added.tolist())
    return sorted(chosen)


_CLASSES = (VBM_OT_select_faulty, VBM_OT_select_undersampled)


def register():
    for cls in _CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
