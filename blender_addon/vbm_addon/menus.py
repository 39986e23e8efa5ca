# SPDX-License-Identifier: GPL-3.0-or-later
"""Menu entries. They are also what makes the operators findable with F3."""

import bpy


class VBM_MT_object(bpy.types.Menu):
    bl_label = "Ball Model"

    def draw(self, context):
        layout = self.layout
        layout.operator_context = "INVOKE_REGION_WIN"
        layout.operator("vbm.build_balls", icon="OUTLINER_OB_POINTCLOUD")
        layout.operator("vbm.rebuild_surface", icon="OUTLINER_OB_MESH")
        layout.operator("vbm.measure_thickness", icon="MOD_THICKNESS")
        layout.separator()
        layout.operator("vbm.simplify_shape", icon="MOD_SIMPLIFY")
        layout.operator("vbm.prune_axis")
        layout.operator("vbm.remove_part")
        layout.operator("vbm.undo_axis_step")
        layout.separator()
        layout.operator("vbm.topology_graph")
        layout.operator("vbm.curve_skeleton")
        layout.operator("vbm.axis_of_balls")
        layout.operator("vbm.make_armature")
        layout.operator("vbm.part_groups")
        layout.separator()
        layout.operator("vbm.cluster_balls")
        layout.operator("vbm.ball_surface")
        layout.separator()
        layout.operator("vbm.select_undersampled")


def _object_menu(self, context):
    self.layout.separator()
    self.layout.menu(VBM_MT_object.__name__)


def _select_menu(self, context):
    self.layout.separator()
    self.layout.operator_context = "INVOKE_REGION_WIN"
    self.layout.operator("vbm.select_undersampled")


def register():
    bpy.utils.register_class(VBM_MT_object)
    bpy.types.VIEW3D_MT_object.append(_object_menu)
    bpy.types.VIEW3D_MT_select_edit_mesh.append(_select_menu)


def unregister():
    bpy.types.VIEW3D_MT_select_edit_mesh.remove(_select_menu)
    bpy.types.VIEW3D_MT_object.remove(_object_menu)
    bpy.utils.unregister_class(VBM_MT_object)
