# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the picked part of the active medial axis over the viewport, so that list and view agree.

Nothing of the file changes by picking but the number of the part.
"""

import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from . import axis_object, compat
from .axis_operator import find

_FILL = (1.0, 1.0, 1.0, 0.45)
_LINE = (1.0, 1.0, 1.0, 0.9)
_handle = None
#: (what it was made for, its colours and batches): the last part's geometry on the graphics card.
_last = (None, ())


def _batches(obj, part):
    global _last
    mesh = obj.data
    key = (obj.name, mesh.name, len(mesh.vertices), obj.vbm_axis.recipe, part)
    if _last[0] != key:
        _last = (key, tuple(_make(obj, mesh, part)))
    return _last[1]


def _make(obj, mesh, part):
    points = compat.read_positions(mesh)
    numbers = mesh.attributes.get(axis_object.PART)
    shader = compat.plain_shader()
    if numbers is not None and len(numbers.data) == len(mesh.polygons) > 0:
        parts = np.empty(len(mesh.polygons), dtype=np.int32)
        numbers.data.foreach_get("value", parts)
        corners = np.empty(len(mesh.loops), dtype=np.int32)
        mesh.loops.foreach_get("vertex_index", corners)
        if len(corners) == 3 * len(parts):
            chosen = corners.reshape(-1, 3)[parts == part]
            for kind, color, indices in (("TRIS", _FILL, chosen), ("LINES", _LINE, _border(chosen))):
                yield color, batch_for_shader(shader, kind, {"pos": points[indices.ravel()]})
    ends, curve_parts = axis_object.curve_edges(obj)
    curve = ends[curve_parts == part].astype(np.float32)
    if len(curve):
        yield _LINE, batch_for_shader(shader, "LINES", {"pos": curve.reshape(-1, 3)})


def _border(triangles):
    """The edges that exactly one of the triangles has."""
    edges = np.concatenate([triangles[:, (0, 1)], triangles[:, (1, 2)], triangles[:, (2, 0)]])
    edges.sort(axis=1)
    unique, counts = np.unique(edges, axis=0, return_counts=True)
    return unique[counts == 1]


def _draw():
    obj, _ = find(bpy.context)
    if obj is None or obj.mode != "OBJECT" or not obj.visible_get():
        return
    part = obj.vbm_axis.active_part
    if not 0 <= part < len(obj.vbm_axis.parts):
        return
    shader = compat.plain_shader()
    gpu.state.blend_set("ALPHA")
    gpu.state.depth_test_set("NONE")
    gpu.state.line_width_set(2.0)
    with gpu.matrix.push_pop():
        gpu.matrix.multiply_matrix(obj.matrix_world)
        for color, batch in _batches(obj, part):
            shader.bind()
            shader.uniform_float("color", color)
            batch.draw(shader)
    gpu.state.line_width_set(1.0)
    gpu.state.blend_set("NONE")


def register():
    global _handle
    if not bpy.app.background:
        _handle = bpy.types.SpaceView3D.draw_handler_add(_draw, (), "WINDOW", "POST_VIEW")


def unregister():
    global _handle, _last
    if _handle is not None:
        bpy.types.SpaceView3D.draw_handler_remove(_handle, "WINDOW")
    _handle, _last = None, (None, ())
