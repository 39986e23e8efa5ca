# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi ball models in Blender: balls from a shape, a closed surface back, wall thickness.

The computing is libvbm's, reached through its Python module; this package reads meshes from Blender,
runs the work beside the interface, and writes the results as objects and attributes.
"""

bl_info = {
    "name": "Voronoi Ball Models",
    "author": "The libvbm developers",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D Viewport > Sidebar > VBM, and Object > Ball Model",
    "description": "Balls from a scan or mesh, a closed surface back, and wall thickness",
    "category": "Mesh",
}

import bpy
from bpy.app.handlers import persistent

from . import (ball_operator, cache, menus, op_armature, op_axis_of_balls, op_ball_surface, op_balls,
               op_cluster, op_files, op_graphs, op_groups, op_parts, op_pick, op_select, op_simplify, op_surface,
               op_thickness, options, panel, panel_axis, panel_balls, part_overlay, recipe, session)

_MODULES = (options, recipe, op_balls, op_surface, op_thickness, op_select, op_simplify, op_parts,
            op_graphs, op_axis_of_balls, op_armature, op_groups, op_cluster, op_ball_surface, op_files, op_pick,
            part_overlay, panel, panel_axis, panel_balls, menus)


@persistent
def _forget(*_unused):
    """Another file is open: what was computed for the last one is of no use."""
    if session.job is not None:
        session.job.cancel()
    cache.clear()
    ball_operator.clear()
    session.clear()


def register():
    for module in _MODULES:
        module.register()
    bpy.app.handlers.load_pre.append(_forget)


def unregister():
    bpy.app.handlers.load_pre.remove(_forget)
    for module in reversed(_MODULES):
        module.unregister()
    _forget()
