# SPDX-License-Identifier: GPL-3.0-or-later
"""Operator: balls from the active object, shown as one object."""

import bpy
import numpy as np
from bpy.props import EnumProperty, FloatProperty

from . import ball_object, build_text, creation, model, options, session, source
from .job_operator import JobOperator

SOURCE_DISPLAY = EnumProperty(
    name="Source Object", default="HIDE",
    description="What becomes of the object that this was computed from",
    items=[("KEEP", "Keep", "Leave it as it is"),
           ("WIRE", "Wireframe", "Draw it as a wireframe"),
           ("HIDE", "Hide", "Hide it in viewports and renders; Alt H shows it again")])


class VBM_OT_build_balls(JobOperator, options.BuildOptions, ball_object.DisplayOptions,
                         bpy.types.Operator):
    """Fill the active object with balls: one at every sample of its surface, as large as fits"""

    bl_idname = "vbm.build_balls"
    bl_label = "Build Balls"
    doing = "Building balls"

    side: EnumProperty(
        name="Show", default="INNER", description="Which balls the new object gets",
        items=[("INNER", "Inner", "The balls that fill the shape"),
               ("OUTER", "Outer", "The balls that fill the space around it"),
               ("BOTH", "Both", "All balls; the attribute `inside` tells them apart")])
    outer_limit: FloatProperty(
        name="Largest Outer Ball", default=0.5, min=0.0, soft_max=2.0,
        description="Leave out outer balls of a larger radius, as a part of the shape's diagonal")
    source_display: SOURCE_DISPLAY

    def work(self, request, progress):
        return model.build(request, progress)

    def finish(self, context, obj, request, built):
        balls = built.model
        inside = np.asarray(balls.inside, dtype=bool)
        radii = np.asarray(balls.radii)
        chosen = self._choose(balls, inside, radii)
        if not chosen.any():
            raise LookupError("no ball is left to show")
        with creation.undone_on_failure() as made:
            shown = self._make(made, obj, balls, radii[chosen], inside[chosen],
                               np.asarray(balls.centers)[chosen])
            creation.show_result(context, shown, obj, self.source_display)
        color_viewport(context)
        count = int(chosen.sum())
        lines = [f"Radius {radii[chosen].min():.4g} to {radii[chosen].max():.4g}",
                 f"{balls.report.samples:,} samples of {obj.name}", build_text.line(balls.report)]
        return session.Outcome(f"{shown.name}: {count:,} balls", lines, list(balls.notes))

    def _choose(self, balls, inside, radii):
        if self.side == "INNER":
            return inside
        limit = self.outer_limit * balls.report.diagonal
        outer = ~inside & (radii <= limit)
        return outer if self.side == "OUTER" else inside | outer

    def _make(self, made, origin, balls, radii, inside, centers):
        obj = ball_object.make(made, f"{origin.name} Balls", centers, radii, self)
        creation.add_attribute(obj.data, "inside", "BOOLEAN", inside)
        creation.place_like(obj, origin)
        obj[source.SOURCE_KEY] = origin.name
        creation.describe(obj, balls.report, balls.notes)
        return obj

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
    options.draw_property(layout, owner, "side")
    if owner.side != "INNER":
        options.draw_property(layout, owner, "outer_limit")
    ball_object.draw_display(layout, owner)
    options.draw_property(layout, owner, "source_display")


def color_viewport(context):
    """Let the Solid mode of the viewport it was asked from show colour attributes."""
    space = context.space_data
    if space is not None and space.type == "VIEW_3D" and space.shading.type == "SOLID":
        space.shading.color_type = "VERTEX"


def register():
    bpy.utils.register_class(VBM_OT_build_balls)


def unregister():
    bpy.utils.unregister_class(VBM_OT_build_balls)
