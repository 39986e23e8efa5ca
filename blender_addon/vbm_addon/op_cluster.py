# SPDX-License-Identifier: GPL-3.0-or-later
"""Operator: fewer balls, each for a cluster of those there were (thesis 4.4.1)."""

import bpy
from bpy.props import EnumProperty, IntProperty

from . import ball_object, creation, op_balls, options, session, text
from .ball_operator import BallOperator, place

_NAMES = tuple(row["name"] for row in options.table("cluster"))


class ClusterOptions:
    """The library's parameters of clustering."""

    __annotations__ = options.properties_of("cluster", set())


class VBM_OT_cluster_balls(BallOperator, ClusterOptions, ball_object.DisplayOptions,
                           bpy.types.Operator):
    """Replace many balls by few: each new ball encloses a cluster of the selected ones"""

    bl_idname = "vbm.cluster_balls"
    bl_label = "Cluster Balls"
    doing = "Clustering balls"
    call = "cluster"

    by: EnumProperty(
        name="By", default="SPHERICITY", description="What the number of balls follows from",
        items=[("SPHERICITY", "Sphericity", "How well a ball has to stand for those it replaces"),
               ("COUNT", "Number of Balls", "A number of balls: the best so many")])
    source_display: op_balls.SOURCE_DISPLAY
    #: How many there are now: where a number begins that was not chosen.
    made: IntProperty(options={"HIDDEN", "SKIP_SAVE"})

    def arguments(self):
        given = options.arguments_of(self, _NAMES)
        if self.by == "SPHERICITY":
            given["count"] = 0
        else:
            if self.count < 1:
                self.count = self.made or 100
            given["count"] = self.count
        return given

    def finish(self, context, obj, request, clusters):
        balls = request.source
        with creation.undone_on_failure() as made:
            new = ball_object.make(made, f"{balls.name} Clusters", clusters.centers, clusters.radii,
                                   self)
            creation.add_attribute(new.data, "sphericity", "FLOAT", clusters.sphericity)
            place(context, obj, new, balls, self.source_display)
        creation.describe(new, clusters.report, clusters.notes)
        op_balls.color_viewport(context)
        self.made = len(clusters.radii)
        return session.Outcome(f"{new.name}: {text.counted(self.made, 'ball')} for {len(balls.radii):,}",
                               [], list(clusters.notes) + balls.notes)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        draw_own(layout, self)


def draw_own(layout, owner):
    options.draw_property(layout, owner, "by")
    for name in _NAMES:
        if name != ("count" if owner.by == "SPHERICITY" else "sphericity"):
            options.draw_property(layout, owner, name, slider=name == "sphericity")
    layout.separator()
    ball_object.draw_display(layout, owner)
    options.draw_property(layout, owner, "source_display")


def register():
    bpy.utils.register_class(VBM_OT_cluster_balls)


def unregister():
    bpy.utils.unregister_class(VBM_OT_cluster_balls)
