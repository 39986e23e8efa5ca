# SPDX-License-Identifier: GPL-3.0-or-later
"""Operator: balls, medial axis, pruning and the simplified surface in one (thesis 7)."""

import bpy
from bpy.props import BoolProperty, EnumProperty

from . import (axis_model, axis_object, axis_options, build_text, creation, graph_object, options,
               op_balls, session, skeleton_object, source, surface_object)
from .job_operator import JobOperator
from .recipe import Recipe


class VBM_OT_simplify_shape(JobOperator, options.BuildOptions, axis_options.AxisOptions,
                            axis_options.SchemeOptions, bpy.types.Operator):
    """Take small features off the active object and keep every tunnel, cavity and piece: its medial \
axis is cut into parts, those that matter least go, and what is left is given a surface"""

    bl_idname = "vbm.simplify_shape"
    bl_label = "Simplify Shape"
    doing = "Simplifying the shape"

    create: EnumProperty(
        name="Create", options={"ENUM_FLAG"}, default={"SURFACE", "AXIS"},
        description="What is made; Shift-click for several",
        items=[("SURFACE", "Surface", "The simplified shape, closed"),
               ("AXIS", "Axis", "The medial axis, coloured by part. Its parts can be removed one "
                "by one"),
               ("GRAPH", "Graph", "The topology graph: how the parts hang together"),
               ("SKELETON", "Skeleton", "The axis shrunk to curves, as a curve object")])
    shading: surface_object.SHADING
    copy_data: BoolProperty(
        name="Copy Attributes", default=False,
        description="Give the surface the attributes, vertex groups and materials of the "
        "source's vertices. Takes longer; UV maps stay behind")
    source_display: op_balls.SOURCE_DISPLAY

    def _prepare(self, context):
        if not self.create:
            raise source.SourceError("There is nothing to create: choose at least the surface")
        obj, request = super()._prepare(context)
        # Read here, on the main thread: a job must not touch the operator's properties.
        request.wanted = axis_model.Wanted(
            axis_options.axis_arguments(self), axis_options.scheme(self), self.drop_outer,
            "SURFACE" in self.create, {} if "SKELETON" in self.create else None)
        return obj, request

    def work(self, request, progress):
        return axis_model.compute(request, request.wanted, progress)

    def is_quick(self, request):
        return axis_model.is_quick(request, request.wanted)

    def finish(self, context, obj, request, result):
        axis, model = result.axis, result.built.model
        diagonal = model.report.diagonal
        choices = surface_object.Choices.of(self)
        shown = {}
        with creation.undone_on_failure() as made:
            if result.surface is not None:
                shown["surface"] = surface_object.make(
                    made, f"{obj.name} Simplified", obj, request.source, result.surface, choices)
                creation.describe(shown["surface"], result.surface.report, axis.notes)
            if "GRAPH" in self.create:
                shown["graph"] = graph_object.make(made, axis, obj, diagonal)
            if result.skeleton is not None:
                shown["skeleton"] = skeleton_object.make(made, result.skeleton, obj)
            if "AXIS" in self.create:
                shown["axis"] = axis_object.make(made, axis, obj, diagonal,
                                                 self._recipe(request, choices).dumps())
                axis_object.tie(shown)
            creation.show_results(context, list(shown.values()), obj, self.source_display)
        op_balls.color_viewport(context)
        said = outcome(shown, result)
        if result.skeleton is not None:
            said.notes += skeleton_object.notes(result.skeleton)
        said.lines.append(build_text.line(model.report))
        said.notes += model.notes
        return said

    def _recipe(self, request, choices):
        reading = {name: getattr(self, name)
                   for name in ("use_modifiers", "ignore_faces", "normals_attribute")}
        surface = {"drop_outer": self.drop_outer, "shading": choices.shading,
                   "copy_data": choices.copy_data}
        return Recipe(reading, request.arguments, request.wanted.axis_arguments, surface, {},
                      request.source.digest.hex(), request.wanted.steps)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        draw_own(layout, self)
        layout.separator()
        axis_options.draw_axis(layout, self)
        options.draw_source(layout, self)
        options.draw_build(layout, self, rare=False)
        options.draw_build(layout, self, rare=True)


def outcome(shown, result):
    """What came of it, in words."""
    report = result.axis.report
    first = next(iter(shown.values()))
    title = f"{first.name}: {report.parts:,} part{'s' if report.parts != 1 else ''} left"
    lines = [f"Balls for {100.0 * report.volume:.3g} % of the volume are left"]
    if result.surface is not None:
        solid = result.surface.report
        pieces = "" if solid.components == 1 else f", {solid.components:,} pieces"
        lines.append(f"Surface of {len(result.surface.triangles):,} triangles, "
                     f"genus {solid.genus}{pieces}")
    return session.Outcome(title, lines, list(result.axis.notes))


def draw_own(layout, owner):
    """The operator's own choices, here and in the sidebar."""
    axis_options.draw_scheme(layout, owner)
    layout.separator()
    row = layout.row(align=True)
    row.prop(owner, "create")
    if "SURFACE" in owner.create:
        for name in axis_options.SURFACE_NAMES:
            options.draw_property(layout, owner, name)
        options.draw_property(layout, owner, "shading")
        options.draw_property(layout, owner, "copy_data")
    options.draw_property(layout, owner, "source_display")


def register():
    bpy.utils.register_class(VBM_OT_simplify_shape)


def unregister():
    bpy.utils.unregister_class(VBM_OT_simplify_shape)
