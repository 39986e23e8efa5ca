# SPDX-License-Identifier: GPL-3.0-or-later
"""Operator: an axis of as many balls as asked for, of a shape or of an axis object's parts that are left."""

import bpy

from . import (axis_model, axis_operator, axis_options, ball_object, build_text, creation, op_balls,
               options, session, source)
from .job_operator import JobOperator
from .recipe import Recipe

_NAMES = tuple(row["name"] for row in options.table("simplify_axis"))


class FewOptions:
    """The library's parameters of simplifying an axis, and of the axis itself."""

    __annotations__ = {**options.properties_of("simplify_axis", set()),
                       **options.properties_of("medial_axis", {"SKIP_SAVE"})}


class VBM_OT_axis_of_balls(JobOperator, options.BuildOptions, FewOptions, ball_object.DisplayOptions,
                           bpy.types.Operator):
    """Make a medial axis of a number of balls that stand for the shape, with the same tunnels, cavities \
and pieces. Of a medial axis selected: of its parts that are left"""

    bl_idname = "vbm.axis_of_balls"
    bl_label = "Axis of N Balls"
    doing = "Making an axis of few balls"

    source_display: op_balls.SOURCE_DISPLAY

    def _prepare(self, context):
        axis, _ = axis_operator.find(context)
        few = options.arguments_of(self, _NAMES)
        if axis is None:
            obj, request = super()._prepare(context)
            request.wanted = axis_model.Wanted(axis_options.axis_arguments(self), (), few=few)
            return obj, request
        recipe = Recipe.of(axis)
        obj, request = axis_operator.request_for(context, axis, recipe)
        request.wanted = axis_model.Wanted(recipe.axis, recipe.steps, few=few)
        return obj, request

    def work(self, request, progress):
        return axis_model.compute(request, request.wanted, progress)

    def is_quick(self, request):
        return axis_model.is_quick(request, request.wanted)

    def finish(self, context, obj, request, result):
        mesh, model = result.few, result.built.model
        count = len(mesh.radii)
        balls = f"{count:,} ball{'s' * (count != 1)}"
        with creation.undone_on_failure() as made:
            new = ball_object.make(made, f"{obj.name} Axis of {count}", mesh.vertices, mesh.radii, self,
                                   mesh.triangles, mesh.edges)
            creation.place_like(new, obj)
            new[source.SOURCE_KEY] = obj.name
            creation.describe(new, mesh.report, mesh.notes)
            creation.show_result(context, new, obj, self.source_display)
        op_balls.color_viewport(context)
        share = 100.0 / mesh.report.diagonal if mesh.report.diagonal > 0.0 else 0.0
        lines = [f"{len(mesh.triangles):,} triangles, {len(mesh.edges):,} edges of curves",
                 f"The shape is off by at most {share * mesh.report.error_max:.2g} % of its diagonal, "
                 f"on average {share * mesh.report.error_mean:.2g} %",
                 build_text.line(model.report)]
        return session.Outcome(f"{new.name}: {balls}", lines, [*mesh.notes, *model.notes])

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        draw_own(layout, self)
        layout.separator()
        axis_options.draw_axis(layout, self)
        options.draw_source(layout, self)
        options.draw_build(layout, self, rare=False)
        options.draw_build(layout, self, rare=True)


def draw_own(layout, owner):
    """The operator's own choices, here and in the sidebar."""
    for name in _NAMES:
        options.draw_property(layout, owner, name)
    layout.separator()
    ball_object.draw_display(layout, owner)
    options.draw_property(layout, owner, "source_display")


def register():
    bpy.utils.register_class(VBM_OT_axis_of_balls)


def unregister():
    bpy.utils.unregister_class(VBM_OT_axis_of_balls)
