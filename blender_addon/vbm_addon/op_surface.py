# SPDX-License-Identifier: GPL-3.0-or-later
"""Operator: a closed surface from the active object, by way of its balls."""

import bpy
from bpy.props import BoolProperty, EnumProperty

from . import build_text, creation, model, options, session, surface_object
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
    faces: surface_object.FACES
    shading: surface_object.SHADING
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
            shown = surface_object.make(made, f"{obj.name} Surface", obj, request.source, surface,
                                        surface_object.Choices.of(self))
            creation.describe(shown, surface.report, built.model.notes)
            creation.show_result(context, shown, obj, self.source_display)
        report = surface.report
        parts = report.components
        closed = "closed" if parts == 1 else f"closed, {parts:,} parts"
        title = (f"{shown.name}: {len(shown.data.vertices):,} vertices, "
                 f"{len(shown.data.polygons):,} faces, genus {report.genus}, {closed}")
        lines = [f"Area {report.area:.4g}, volume {report.volume:.4g}",
                 build_text.line(built.model.report)]
        return session.Outcome(title, lines, [*built.model.notes, *surface.notes])

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
