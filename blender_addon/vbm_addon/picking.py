# SPDX-License-Identifier: GPL-3.0-or-later
"""Which part of which axis object lies under the mouse."""

import numpy as np
from bpy_extras import view3d_utils

from . import axis_object
from .recipe import is_axis

#: How near to a curve, which has no faces to be hit, a click must come; pixels at 100 % interface scale.
_NEAR = 8.0
#: Instead of a part: the tube that shows a curve was hit.
_TUBE = -2
#: How many walls of contact curves' tubes a click goes through.
_THROUGH = 16


def under_mouse(context, x, y):
    """(axis object, part) at a place of the region, or (None, -1). Sheets go before curves."""
    shown = [obj for obj in context.visible_objects if is_axis(obj)]
    best = (None, -1, np.inf)
    for obj in shown:
        part, distance = _sheet(context, obj, x, y)
        if part == _TUBE:
            part, _ = _curve(context, obj, x, y)
        if part >= 0 and distance < best[2]:
            best = (obj, part, distance)
    if best[0] is None:
        best = (None, -1, _NEAR * context.preferences.system.ui_scale)
        for obj in shown:
            part, distance = _curve(context, obj, x, y)
            if part >= 0 and distance < best[2]:
                best = (obj, part, distance)
    return best[:2]


def _sheet(context, obj, x, y):
    """(part of the face that is hit first, how far away it is)."""
    region, view = context.region, context.region_data
    start = view3d_utils.region_2d_to_origin_3d(region, view, (x, y))
    direction = view3d_utils.region_2d_to_vector_3d(region, view, (x, y))
    numbers = obj.data.attributes.get(axis_object.PART)
    try:
        inverse = obj.matrix_world.inverted()
    except ValueError:  # scaled to nothing
        return -1, np.inf
    depsgraph = context.evaluated_depsgraph_get()
    shown = obj.evaluated_get(depsgraph).data.attributes.get(axis_object.PART)
    origin, along = inverse @ start, (inverse.to_3x3() @ direction).normalized()
    step = None
    for _ in range(_THROUGH):
        hit, place, _normal, face = obj.ray_cast(origin, along, depsgraph=depsgraph)
        if not hit or numbers is None:
            break
        far = (obj.matrix_world @ place - start).length
        if 0 <= face < len(numbers.data):
            return numbers.data[face].value, far
        # What the modifier draws: curves' tubes know that they are, those of contact curves are no part.
        if shown is not None and 0 <= face < len(shown.data) and shown.data[face].value >= 0:
            return _TUBE, far
        step = step or 1e-5 * (place - origin).length  # as places are known to 24 bits
        origin = place + along * step
    return -1, np.inf


def _curve(context, obj, x, y):
    """(part of the curve that is nearest on the screen, how many pixels away)."""
    ends, parts = axis_object.curve_edges(obj)
    if not len(parts):
        return -1, np.inf
    matrix = np.array(context.region_data.perspective_matrix @ obj.matrix_world)
    points = np.concatenate([ends, np.ones((len(ends), 2, 1))], axis=2) @ matrix.T
    seen = (points[:, :, 3] > 0).all(axis=1)
    if not seen.any():
        return -1, np.inf
    size = np.array((context.region.width, context.region.height))
    flat = (points[seen, :, :2] / points[seen, :, 3:] + 1.0) * size / 2.0
    start, along = flat[:, 0], flat[:, 1] - flat[:, 0]
    mouse = np.array((x, y)) - start
    square = np.maximum((along ** 2).sum(axis=1), 1e-12)
    at = np.clip((mouse * along).sum(axis=1) / square, 0.0, 1.0)
    distance = np.linalg.norm(mouse - at[:, None] * along, axis=1)
    nearest = int(distance.argmin())
    return int(parts[seen][nearest]), float(distance[nearest])
