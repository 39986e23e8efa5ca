# SPDX-License-Identifier: GPL-3.0-or-later
"""Balls as an object: a vertex at every centre, with the ball's radius, shown as spheres by nodes."""

import bpy
import numpy as np
from bpy.props import BoolProperty, FloatProperty, IntProperty

from . import ball_nodes, compat, creation, options

#: Real spheres beyond so many vertices would fill the memory: instances are shown instead.
_MOST_VERTICES = 6_000_000
#: If nothing else is asked for: so many are made again at once, when a slider is drawn; and so many for spheres that
#: are not too coarse to look at.
_QUICK_VERTICES, _DECENT_VERTICES = 250_000, 2_000_000
#: Vertices of an icosphere by subdivisions.
_SPHERE_VERTICES = (0, 12, 42, 162, 642, 2562)


class DisplayOptions:
    """How an operator's balls are shown."""

    __annotations__ = {
        "scale": FloatProperty(name="Ball Scale", default=1.0, min=0.0, soft_max=1.0,
                               description="Size of the spheres shown, times their radius"),
        "detail": IntProperty(name="Detail", default=0, min=0, max=5,
                              description="Subdivisions of the spheres; 0 chooses by their number"),
        "solid_colors": BoolProperty(
            name="Colors in Solid Mode", default=True,
            description="Make the spheres real, so that Solid mode can colour them. Very many balls "
            "stay instances, which only rendered views colour"),
    }


def draw_display(layout, owner):
    for name in DisplayOptions.__annotations__:
        options.draw_property(layout, owner, name)


def automatic_detail(count):
    """The finest spheres, up to 642 vertices each, that the budgets of vertices allow."""
    for detail, budget in ((4, _QUICK_VERTICES), (3, _QUICK_VERTICES), (2, _DECENT_VERTICES)):
        if count * _SPHERE_VERTICES[detail] <= budget:
            return detail
    return 1


def make(made, name, centers, radii, display, triangles=None, edges=()):
    """A new object, not placed or linked yet. `display` has the properties of DisplayOptions; faces and
    edges, if given, join the balls (a medial mesh) and are kept, not shown."""
    mesh = bpy.data.meshes.new(name)
    made.append((bpy.data.meshes, mesh))
    if triangles is not None and len(triangles):
        triangles = np.asarray(triangles)
        creation.fill_mesh(mesh, centers, np.arange(0, 3 * len(triangles) + 1, 3),
                           triangles.ravel(), edges)
    else:
        creation.fill_mesh(mesh, centers, edges=edges)
    creation.add_attribute(mesh, "radius", "FLOAT", radii)
    mesh.color_attributes.new(ball_nodes.COLOR, "FLOAT_COLOR", "POINT")  # filled by the nodes
    compat.set_active_color(mesh, ball_nodes.COLOR)
    material, is_new = ball_nodes.material()
    if is_new:
        made.append((bpy.data.materials, material))
    group, is_new = ball_nodes.node_group()
    if is_new:
        made.append((bpy.data.node_groups, group))
    mesh.materials.append(material)
    obj = bpy.data.objects.new(name, mesh)
    made.append((bpy.data.objects, obj))
    _add_modifier(obj, group, material, np.asarray(radii), display)
    return obj


def _add_modifier(obj, group, material, radii, display):
    modifier = obj.modifiers.new(ball_nodes.NAME, "NODES")
    modifier.node_group = group
    detail = display.detail or automatic_detail(len(radii))
    real = display.solid_colors and len(radii) * _SPHERE_VERTICES[detail] <= _MOST_VERTICES
    # A few very large or small balls would leave one colour to all others.
    low, high = np.percentile(radii, (2, 98))
    for name, value in ((ball_nodes.SCALE, display.scale), (ball_nodes.DETAIL, detail),
                        (ball_nodes.LOW, float(low)), (ball_nodes.HIGH, float(high)),
                        (ball_nodes.SOLID, real), (ball_nodes.MATERIAL, material)):
        compat.set_modifier_input(modifier, name, value)
