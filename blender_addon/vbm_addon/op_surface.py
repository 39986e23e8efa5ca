# SPDX-License-Identifier: GPL-3.0-or-later
"""Operator: a closed surface from the active object, by way of its balls."""

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty

from . import creation, model, options, session, transfer
from .job_operator import JobOperator
from .op_balls import SOURCE_DISPLAY


class VBM_OT_rebuild_surface(JobOperator, options.BuildOptions, bpy.types.Operator):
    """Rebuild the active object as a closed surface without holes, from its faces or loose vertices"""

    bl_idname = "vbm.rebuild_surface"
    bl_label = "Rebuild Surface"
    doing = "Rebuilding the surface"

    style: EnumProperty(
        name="Surface", default="INTERPOLATING", description="How the surface is made",
        items=[("INTERPOLATING", "Through the Samples", "Its vertices are the input's vertices (and "
                "samples added between them), so their attributes come along"),
               ("POWER_CRUST", "Power Crust", "The faces between the inner and the outer balls: "
                "more vertices, follows the balls more closely")])
    faces: EnumProperty(
        name="Faces", default="TRIANGLES", description="Faces of a power crust",
        items=[("TRIANGLES", "Triangles", "Every face cut into triangles"),
               ("POLYGONS", "Polygons", "The faces as they are; not quite flat")])
    shading: EnumProperty(
        name="Shading", default="SOURCE", description="How the faces are shaded",
        items=[("SOURCE", "As the Source", "As most of the source's faces; smooth for loose points"),
               ("SMOOTH", "Smooth", "All smooth"), ("FLAT", "Flat", "All flat")])
    copy_data: BoolProperty(
        name="Copy Attributes", default=True,
        description="Carry over attributes and vertex groups of the source's vertices, and its "
        "materials. UV maps belong to face corners and stay behind")
    source_display: SOURCE_DISPLAY

    def work(self, request, progress):
        return model.surface(request, self.style, progress)

    def is_quick(self, request):
        return request.cached is not None and self.style in request.cached.surfaces

    def finish(self, context, obj, request, result):
        built, surface = result
        with creation.undone_on_failure() as made:
            shown = self._make(made, obj, request.source, built.model, surface)
            creation.show_result(context, shown, obj, self.source_display)
        report = surface.report
        parts = report.components
        closed = "closed" if parts == 1 else f"closed, {parts:,} parts"
        title = (f"{shown.name}: {len(shown.data.vertices):,} vertices, "
                 f"{len(shown.data.polygons):,} faces, genus {report.genus}, {closed}")
        lines = [f"Area {report.area:.4g}, volume {report.volume:.4g}"]
        return session.Outcome(title, lines, [*built.model.notes, *surface.notes])

    def _make(self, made, origin, data, balls, surface):
        mesh = bpy.data.meshes.new(f"{origin.name} Surface")
        made.append((bpy.data.meshes, mesh))
        triangles = np.asarray(surface.triangles)
        if self.faces == "POLYGONS":
            offsets, corners = surface.polygons.offsets, surface.polygons.corners
        else:
            offsets, corners = np.arange(0, 3 * len(triangles) + 1, 3), triangles.ravel()
        creation.fill_mesh(mesh, surface.vertices, offsets, corners)
        mesh.polygons.foreach_set("use_smooth", np.full(len(mesh.polygons), self._smooth(origin)))
        creation.add_attribute(mesh, "radius", "FLOAT", surface.vertex_radius)
        creation.add_attribute(mesh, "input_vertex", "INT", surface.vertex_input)
        obj = bpy.data.objects.new(f"{origin.name} Surface", mesh)
        made.append((bpy.data.objects, obj))
        creation.place_like(obj, origin)
        creation.describe(obj, surface.report, balls.notes)
        if self.copy_data:
            transfer.copy_materials(origin, mesh)
            if data.own:
                edges = np.concatenate([triangles[:, (0, 1)], triangles[:, (1, 2)],
                                        triangles[:, (2, 0)]])
                vertices = transfer.fill_unknown(surface.vertex_input, edges)
                transfer.copy_attributes(origin.data, mesh, vertices)
                transfer.copy_vertex_groups(origin, obj, vertices)
        return obj

    def _smooth(self, origin):
        if self.shading != "SOURCE":
            return self.shading == "SMOOTH"
        if origin.type != "MESH" or self.ignore_faces or not origin.data.polygons:
            return True
        smooth = np.empty(len(origin.data.polygons), dtype=bool)
        origin.data.polygons.foreach_get("use_smooth", smooth)
        return bool(smooth.mean() > 0.5)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        draw_own(layout, self)
        layout.separator()
        options.draw_source(layout, self)
        options.draw_build(layout, self, rare=False)
        options.draw_build(layout, self, rare=True)


def draw_own(layout, owner):
    """The operator's own choices, here and in the sidebar."""
    options.draw_property(layout, owner, "style")
    if owner.style == "POWER_CRUST":
        options.draw_property(layout, owner, "faces")
    options.draw_property(layout, owner, "shading")
    options.draw_property(layout, owner, "copy_data")
    options.draw_property(layout, owner, "source_display")


def register():
    bpy.utils.register_class(VBM_OT_rebuild_surface)


def unregister():
    bpy.utils.unregister_class(VBM_OT_rebuild_surface)
