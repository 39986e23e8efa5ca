# SPDX-License-Identifier: GPL-3.0-or-later
"""The sidebar's panel of operators that start from balls."""

import bpy

from . import ball_source, library, session, text


class VBM_PT_any_balls(bpy.types.Panel):
    bl_label = "Any Balls"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "VBM"
    bl_order = 2
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return library.vbm is not None

    def draw(self, context):
        layout = self.layout
        layout.enabled = session.job is None
        count = len(ball_source.selected(context))
        if not count:
            text.draw(layout, context, "Select a ball object, metaballs, spheres, or empties drawn as "
                      "spheres", icon="INFO")
        column = layout.column(align=True)
        column.operator("vbm.cluster_balls", icon="STICKY_UVS_LOC")
        column.operator("vbm.ball_surface", icon="META_DATA")
        column = layout.column(align=True)
        column.operator("vbm.import_balls", icon="IMPORT")
        column.operator("vbm.export_balls", icon="EXPORT")


def register():
    bpy.utils.register_class(VBM_PT_any_balls)


def unregister():
    bpy.utils.unregister_class(VBM_PT_any_balls)
