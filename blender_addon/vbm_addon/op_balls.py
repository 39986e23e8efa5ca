# SPDX-License-Identifier: GPL-3.0-or-later
"""Operator: balls from the active object, shown as one object."""

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

from . import ball_nodes, compat, creation, model, options, session, source
from .job_operator import JobOperator

#: Real spheres beyond so many vertices would fill the memory: instances are shown instead.
_MOST_VERTICES = 6_000_000
#: Vertices of an icosphere by subdivisions.
_SPHERE_VERTICES = (0, 12, 42, 162, 642, 2562)

SOURCE_DISPLAY = EnumProperty(
    name="Source Object", default="HIDE",
    description="What becomes of the object that this was computed from",
    items=[("KEEP", "Keep", "Leave it as it is"),
           ("WIRE", "Wireframe", "Draw it as a wireframe"),
           ("HIDE", "Hide", "Hide it in viewports and renders; Alt H shows it again")])


def automatic_detail(count):
    """The finest spheres, up to 642 vertices each, that the vertex budget allows."""
    fits = [detail for detail in (4, 3, 2) if count * _SPHERE_VERTICES[detail] <= _MOST_VERTICES / 3]
    return fits[0] if fits else 1


class VBM_OT_build_balls(JobOperator, options.BuildOptions, bpy.types.Operator):
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
    scale: FloatProperty(name="Ball Scale", default=1.0, min=0.0, soft_max=1.0,
                         description="Size of the spheres shown, times their radius")
    detail: IntProperty(name="Detail", default=0, min=0, max=5,
                        description="Subdivisions of the spheres; 0 chooses by their number")
    solid_colors: BoolProperty(
        name="Colors in Solid Mode", default=True,
        description="Make the spheres real, so that Solid mode can colour them. Very many balls "
        "stay instances, which only rendered views colour")
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
                 f"{balls.report.samples:,} samples of {obj.name}"]
        return session.Outcome(f"{shown.name}: {count:,} balls", lines, list(balls.notes))

    def _choose(self, balls, inside, radii):
        if self.side == "INNER":
            return inside
        limit = self.outer_limit * balls.report.diagonal
        outer = ~inside & (radii <= limit)
        return outer if self.side == "OUTER" else inside | outer

    def _make(self, made, origin, balls, radii, inside, centers):
        mesh = bpy.data.meshes.new(f"{origin.name} Balls")
        made.append((bpy.data.meshes, mesh))
        creation.fill_mesh(mesh, centers)
        creation.add_attribute(mesh, "radius", "FLOAT", radii)
        creation.add_attribute(mesh, "inside", "BOOLEAN", inside)
        material, is_new = ball_nodes.material()
        if is_new:
            made.append((bpy.data.materials, material))
        group, is_new = ball_nodes.node_group()
        if is_new:
            made.append((bpy.data.node_groups, group))
        mesh.materials.append(material)
        obj = bpy.data.objects.new(f"{origin.name} Balls", mesh)
        made.append((bpy.data.objects, obj))
        creation.place_like(obj, origin)
        obj[source.SOURCE_KEY] = origin.name
        creation.describe(obj, balls.report, balls.notes)
        self._add_modifier(obj, group, material, radii)
        return obj

    def _add_modifier(self, obj, group, material, radii):
        modifier = obj.modifiers.new(ball_nodes.NAME, "NODES")
        modifier.node_group = group
        detail = self.detail or automatic_detail(len(radii))
        real = self.solid_colors and len(radii) * _SPHERE_VERTICES[detail] <= _MOST_VERTICES
        # A few very large or small balls would leave one colour to all others.
        low, high = np.percentile(radii, (2, 98))
        for name, value in ((ball_nodes.SCALE, self.scale), (ball_nodes.DETAIL, detail),
                            (ball_nodes.LOW, float(low)), (ball_nodes.HIGH, float(high)),
                            (ball_nodes.SOLID, real), (ball_nodes.MATERIAL, material)):
            compat.set_modifier_input(modifier, name, value)

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
    options.draw_property(layout, owner, "scale")
    options.draw_property(layout, owner, "detail")
    options.draw_property(layout, owner, "solid_colors")
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
