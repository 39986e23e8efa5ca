# SPDX-License-Identifier: GPL-3.0-or-later
"""The curve skeleton as a curve object: a poly spline a branch, each point with its ball's radius."""

import bpy
import numpy as np

from . import creation, skeleton

#: How thick the curve is drawn, times the radius of the ball at each point.
_BEVEL = 0.08
_DRAWN_ORANGE = (1.0, 0.45, 0.1, 1.0)


def make(made, medial_mesh, origin):
    """A new object where `origin` stands, not linked yet."""
    curve = new_curve(made, f"{origin.name} Skeleton", medial_mesh)
    obj = bpy.data.objects.new(curve.name, curve)
    made.append((bpy.data.objects, obj))
    creation.place_like(obj, origin)
    obj.show_in_front = True
    obj.color = _DRAWN_ORANGE
    obj.vbm_axis.follows = True
    return obj


def new_curve(made, name, medial_mesh):
    curve = bpy.data.curves.new(name, "CURVE")
    made.append((bpy.data.curves, curve))
    curve.dimensions = "3D"
    curve.bevel_depth = _BEVEL
    curve.bevel_resolution = 2
    curve.use_fill_caps = True
    vertices = np.asarray(medial_mesh.vertices, dtype=np.float32)
    radii = np.asarray(medial_mesh.radii, dtype=np.float32)
    for path in skeleton.branches(medial_mesh.edges):
        closed = path[0] == path[-1]
        if closed:
            path = path[:-1]
        spline = curve.splines.new("POLY")
        spline.points.add(len(path) - 1)
        at = np.ones((len(path), 4), dtype=np.float32)
        at[:, :3] = vertices[path]
        spline.points.foreach_set("co", at.ravel())
        spline.points.foreach_set("radius", radii[path])
        spline.use_cyclic_u = closed
        spline.use_smooth = True
    return curve


def notes(medial_mesh):
    """What does not become a curve."""
    sheets = len(medial_mesh.triangles)
    return [f"{sheets:,} triangles round a cavity of the shape cannot become curves and are left "
            "out"] if sheets else []
