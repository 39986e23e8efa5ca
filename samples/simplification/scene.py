# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of shapes with a line of text below each, rendered with Workbench."""

import colorsys
import math
import os
import sys

import bpy
import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../demo"))
import picture  # noqa: E402


GLASS = (0.62, 0.66, 0.72, 0.3)  # the last: how little light goes through


def clear():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def part_color(part):
    """Colours far apart for parts whose numbers are near."""
    hue = (part * 0.6180339887) % 1.0
    return (*colorsys.hsv_to_rgb(hue, 0.45 + 0.3 * (part % 3) / 2, 0.95 - 0.2 * (part % 2)), 1.0)


def _mesh(name, vertices, triangles, edges=()):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(np.asarray(vertices).tolist(), np.asarray(edges).tolist(), np.asarray(triangles).tolist())
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def surface(shape):
    obj = _mesh("Surface", shape.vertices, shape.triangles)
    obj.data.polygons.foreach_set("use_smooth", np.ones(len(obj.data.polygons), dtype=bool))
    if hasattr(obj.data, "use_auto_smooth"):  # so that sharp edges stay sharp
        obj.data.use_auto_smooth, obj.data.auto_smooth_angle = True, math.radians(40)
    obj.color = picture.CLAY
    return obj


def axis(shape, thickness=0.0):
    """The axis, coloured by part; curves are drawn as thin tubes. Sheets seen from the side want a thickness, a
    share of the axis's size."""
    vertices, triangles = np.asarray(shape.vertices), np.asarray(shape.triangles)
    part = np.asarray(shape.triangle_part)
    obj = _mesh("Axis", vertices, triangles)
    colors = np.array([part_color(p) for p in part]).repeat(3, axis=0)
    layer = obj.data.color_attributes.new("part", "BYTE_COLOR", "CORNER")
    layer.data.foreach_set("color", colors.astype(np.float32).ravel())
    if thickness:
        solid = obj.modifiers.new("Thickness", "SOLIDIFY")
        solid.thickness, solid.offset = thickness * float(np.ptp(vertices, axis=0).max()), 0.0
    if len(shape.edges):
        curve = bpy.data.curves.new("Curves", "CURVE")
        curve.dimensions, curve.bevel_depth = "3D", 0.004 * float(np.ptp(vertices, axis=0).max())
        for edge in np.asarray(shape.edges):
            spline = curve.splines.new("POLY")
            spline.points.add(1)
            for point, vertex in zip(spline.points, edge):
                point.co = (*vertices[vertex], 1.0)
        tubes = bpy.data.objects.new("Curves", curve)
        bpy.context.scene.collection.objects.link(tubes)
        tubes.parent, tubes.color = obj, picture.INK
    return obj


def graph(shape, whole):
    """The topology graph over the translucent shape: a red ball at every node, and a stick from it to a blue
    one amid every part that touches it. Shapes are made to be of one size, about the origin."""
    low, high = whole.vertices.min(axis=0), whole.vertices.max(axis=0)
    size = (high - low).max()
    at = {kind: (np.asarray(shape[kind]) - (low + high) / 2) / size for kind in ("nodes", "parts")}
    obj = _mesh("Shape", (whole.vertices - (low + high) / 2) / size, whole.triangles)
    obj.data.polygons.foreach_set("use_smooth", np.ones(len(obj.data.polygons), dtype=bool))
    if hasattr(obj.data, "use_auto_smooth"):
        obj.data.use_auto_smooth, obj.data.auto_smooth_angle = True, math.radians(40)
    obj.color = GLASS
    curve = bpy.data.curves.new("Sticks", "CURVE")
    curve.dimensions, curve.bevel_depth = "3D", 0.0055
    for part, node in np.asarray(shape["edges"]):
        spline = curve.splines.new("POLY")
        spline.points.add(1)
        spline.points[0].co, spline.points[1].co = (*at["parts"][part], 1.0), (*at["nodes"][node], 1.0)
    sticks = bpy.data.objects.new("Sticks", curve)
    bpy.context.scene.collection.objects.link(sticks)
    sticks.parent, sticks.color = obj, picture.INK
    for kind, radius, color in (("nodes", 0.022, (0.8, 0.1, 0.1, 1)), ("parts", 0.014, (0.1, 0.3, 0.8, 1))):
        for point in at[kind]:
            bpy.ops.mesh.primitive_uv_sphere_add(radius=radius, location=point, segments=16, ring_count=8)
            ball = bpy.context.object
            ball.parent, ball.color = obj, color
            for polygon in ball.data.polygons:
                polygon.use_smooth = True
    return obj


def render_rows(rows, path, width=1800, turn=0.0):
    """`rows`: lists of (object, text); all in one place, turned `turn` degrees about the upright."""
    scene = bpy.context.scene
    angle = math.radians(turn)
    for row in rows:
        for obj, _ in row:
            obj.rotation_euler[2] = angle
    bpy.context.view_layer.update()
    boxes = [picture.world_box(obj) for row in rows for obj, _ in row]
    low, high = np.min([b[0] for b in boxes], axis=0), np.max([b[1] for b in boxes], axis=0)
    size, middle = high - low, (low + high) / 2
    tilt = math.radians(80)
    columns = max(map(len, rows))
    tall = math.sin(tilt) * size[2] + math.cos(tilt) * size[1]  # as the camera sees it
    text = 0.045 * size[0]
    step = (1.12 * size[0], 1.06 * tall + 2.4 * text)
    # Heights are those of the picture; an upright stretch of one is 1 / sin(tilt) long.
    up = 1 / math.sin(tilt)
    for r, row in enumerate(rows):
        for c, (obj, line) in enumerate(row):
            x = (c - (len(row) - 1) / 2) * step[0]
            height = ((len(rows) - 1) / 2 - r) * step[1] + 0.8 * text
            obj.location = (x - middle[0], -middle[1], height * up - middle[2])
            picture.write(line, (x, 0, (height - tall / 2 - 1.6 * text) * up), text, scene, tilt)
    data = bpy.data.cameras.new("Camera")
    extent = (columns * step[0], len(rows) * step[1])
    data.type, data.ortho_scale, data.clip_end = "ORTHO", max(extent), 1000 * max(size)
    camera = bpy.data.objects.new("Camera", data)
    scene.collection.objects.link(camera)
    scene.camera = camera
    camera.rotation_euler = (tilt, 0, 0)
    far = 20 * float(max(size))
    camera.location = (0, -math.sin(tilt) * far, math.cos(tilt) * far)
    scene.render.resolution_x, scene.render.resolution_y = width, int(width * extent[1] / extent[0])
    picture.use_workbench(scene)
    picture.render(scene, path)
