# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets objects side by side, each with a line of text below, and renders them with Workbench."""

import math

import bpy
import numpy as np
from mathutils import Vector

INK = (0.02, 0.05, 0.12, 1.0)
CLAY = (0.72, 0.70, 0.66, 1.0)


def show_points(obj, radius):
    """Give loose vertices, which a render leaves out, the look of small dots."""
    from vbm_addon import compat  # once the add-on is there

    group = bpy.data.node_groups.new("Dots", "GeometryNodeTree")
    compat.new_group_socket(group, "INPUT", "NodeSocketGeometry", "Geometry")
    compat.new_group_socket(group, "OUTPUT", "NodeSocketGeometry", "Geometry")
    entry, leave = group.nodes.new("NodeGroupInput"), group.nodes.new("NodeGroupOutput")
    dots = group.nodes.new("GeometryNodeMeshToPoints")
    dots.inputs["Radius"].default_value = radius
    group.links.new(entry.outputs[0], dots.inputs["Mesh"])
    group.links.new(dots.outputs["Points"], leave.inputs[0])
    obj.modifiers.new("Dots", "NODES").node_group = group
    obj.color = INK


def set_input(modifier, name, value):
    """Set an input of a Geometry Nodes modifier by the name that its panel shows."""
    from vbm_addon import compat

    compat.set_modifier_input(modifier, name, value)


def world_box(obj):
    """Lowest and highest corner of an object's own vertices, in the world."""
    flat = np.empty(3 * len(obj.data.vertices), dtype=np.float32)
    obj.data.vertices.foreach_get("co", flat)
    matrix = np.array(obj.matrix_world)
    points = flat.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]
    return points.min(axis=0), points.max(axis=0)


def write(text, position, size, scene, tilt):
    """A line of text, centred at a position."""
    curve = bpy.data.curves.new(text, "FONT")
    curve.body, curve.size, curve.align_x = text, size, "CENTER"
    label = bpy.data.objects.new(text, curve)
    label.location, label.rotation_euler, label.color = position, (tilt, 0, 0), INK
    scene.collection.objects.link(label)


def lay_out(shown, scene, width, height):
    """Move each of [(object, text)], which stand in one place, into a row of their own under a camera."""
    low, high = world_box(shown[0][0])
    size, middle = high - low, (low + high) / 2
    tilt = math.radians(81)
    # What fills the picture: the row's width, or with tall objects the height.
    tall = 1.3 * (size[2] + math.cos(tilt) * size[1]) * width / height
    step = max(1.12 * size[0], tall / len(shown))
    # Text stands below the feet, in front of them as the camera looks down a little.
    below = Vector((0.0, low[1], low[2] - 0.07 * size[2]))
    for i, (obj, text) in enumerate(shown):
        shift = (i - (len(shown) - 1) / 2) * step - middle[0]
        obj.matrix_world.translation.x += shift
        write(text, below + Vector((middle[0] + shift, 0.0, -0.05 * size[2])), 0.067 * step, scene, tilt)

    data = bpy.data.cameras.new("Camera")
    data.type, data.ortho_scale, data.clip_end = "ORTHO", len(shown) * step * 1.02, 100 * max(size)
    camera = bpy.data.objects.new("Camera", data)
    scene.collection.objects.link(camera)
    scene.camera = camera
    camera.rotation_euler = (tilt, 0, 0)
    away = Vector((0, -math.sin(tilt), math.cos(tilt))) * 5 * float(max(size))
    camera.location = Vector((0, middle[1], middle[2] - 0.07 * size[2])) + away
    scene.render.resolution_x, scene.render.resolution_y = width, height


def use_workbench(scene):
    """White background, even light, the objects' own colours: in the render and in the file's viewports."""
    scene.render.engine = "BLENDER_WORKBENCH"
    scene.display.render_aa = "8"
    scene.view_settings.view_transform = "Standard"
    scene.world = bpy.data.worlds.new("White")
    scene.world.color = (1, 1, 1)
    views = [space for screen in bpy.data.screens for area in screen.areas for space in area.spaces
             if space.type == "VIEW_3D" and space.shading.type == "SOLID"]
    for shading in [scene.display.shading] + [view.shading for view in views]:
        shading.light, shading.studio_light = "STUDIO", "outdoor.sl"
        shading.color_type = "VERTEX"
        shading.show_cavity, shading.cavity_type = True, "BOTH"
        shading.background_type = "WORLD"
    for view in views:
        view.region_3d.view_perspective = "CAMERA"


def render(scene, path):
    scene.render.filepath = path
    scene.render.image_settings.file_format = "PNG"
    bpy.ops.render.render(write_still=True, scene=scene.name)
