# SPDX-License-Identifier: GPL-3.0-or-later
"""The sidebar's panel of operators that start from balls."""

import bpy

from . import ball_source, library, op_ball_surface, op_cluster, panel, session, text


class VBM_PT_any_balls(bpy.types.Panel):
    bl_label = "Any Balls"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "VBM"
    bl_order = 2

    @classmethod
    def poll(cls, context):
        return library.vbm is not None

    def draw(self, context):
        layout = self.layout
        layout.enabled = session.job is None
        chosen = ball_source.selected(context)
        if chosen:
            others = f" and {len(chosen) - 1:,} more" if len(chosen) > 1 else ""
            layout.label(text=chosen[0].name + others, icon=f"OUTLINER_OB_{chosen[0].type}")
        else:
            text.draw(layout, context, "Select a ball object, metaballs, spheres, or empties drawn as "
                      "spheres", icon="INFO")
        column = layout.column(align=True)
        column.operator("vbm.cluster_balls", icon="STICKY_UVS_LOC")
        column.operator("vbm.ball_surface", icon="META_DATA")
        column = layout.column(align=True)
        column.operator("vbm.import_balls", icon="IMPORT")
        column.operator("vbm.export_balls", icon="EXPORT")


class _Options(panel.Options):
    bl_parent_id = "VBM_PT_any_balls"


class VBM_PT_clusters(_Options, bpy.types.Panel):
    bl_label = "Clusters"

    def draw(self, context):
        op_cluster.draw_own(self.prepare(context), panel.last(context, "vbm.cluster_balls"))


class VBM_PT_ball_surface(_Options, bpy.types.Panel):
    bl_label = "Surface from Balls"

    def draw(self, context):
        op_ball_surface.draw_own(self.prepare(context), panel.last(context, "vbm.ball_surface"))


_CLASSES = (VBM_PT_any_balls, VBM_PT_clusters, VBM_PT_ball_surface)


def register():
    for cls in _CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
