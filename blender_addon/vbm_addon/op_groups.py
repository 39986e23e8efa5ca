# SPDX-License-Identifier: GPL-3.0-or-later
"""Operator: the parts of a medial axis as vertex groups of the mesh that it was computed from."""

import bpy
import numpy as np

from . import creation, part_groups, session, source
from .axis_operator import AxisOperator

#: More are of no use in a list that people read, and Blender slows down with them.
_MOST_GROUPS = 500
_PREFIX = "VBM "


class VBM_OT_part_groups(AxisOperator, bpy.types.Operator):
    """Give the mesh that the medial axis was computed from a vertex group for every part: each vertex \
belongs to the part of its inner ball"""

    bl_idname = "vbm.part_groups"
    bl_label = "Vertex Groups"
    doing = "Grouping vertices by part"

    def new_steps(self, context, obj, done):
        return done

    def _prepare(self, context):
        obj, request = super()._prepare(context)
        request.wanted.surface, request.wanted.skeleton = False, None
        origin = obj.vbm_axis.source
        if origin.type != "MESH" or not request.source.own:
            raise source.SourceError(f"The axis was not computed from {origin.name}'s own vertices, "
                                     "but from what its modifiers make of them: apply those first")
        if origin.data.library is not None:
            raise source.SourceError(f"The mesh of {origin.name} is linked from another file")
        return obj, request

    def finish(self, context, obj, request, result):
        origin = obj.vbm_axis.source
        count = len(result.axis.parts)
        if count > _MOST_GROUPS:
            raise source.SourceError(f"{obj.name} has {count:,} parts, too many for vertex groups "
                                     f"(at most {_MOST_GROUPS}): prune it first")
        edges = np.empty(2 * len(origin.data.edges), dtype=np.int32)
        origin.data.edges.foreach_get("vertices", edges)
        part = part_groups.of_vertices(result.built.model, result.axis, edges.reshape(-1, 2))
        names = {number: f"{_PREFIX}{item.name}" for number, item in enumerate(obj.vbm_axis.parts)}
        names[part_groups.REMOVED] = f"{_PREFIX}Removed"
        for group in [group for group in origin.vertex_groups if group.name.startswith(_PREFIX)]:
            origin.vertex_groups.remove(group)
        made = 0
        for number, name in names.items():
            members = np.flatnonzero(part == number)
            if len(members):
                origin.vertex_groups.new(name=name).add(members.tolist(), 1.0, "REPLACE")
                made += 1
        creation.hide(origin, False)
        creation.select_alone(context, origin)
        free = int((part == part_groups.NONE).sum())
        notes = [f"{free:,} vertices have no inner ball and belong to no part"] if free else []
        return session.Outcome(f"{origin.name}: {made:,} vertex groups", [], notes)


def register():
    bpy.utils.register_class(VBM_OT_part_groups)


def unregister():
    bpy.utils.unregister_class(VBM_OT_part_groups)
