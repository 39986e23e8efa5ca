# SPDX-License-Identifier: GPL-3.0-or-later
"""Picking a part of a medial axis by a click: operator, tool, and the key that removes what is picked."""

import bpy

from . import axis_object, picking
from .axis_operator import find
from .op_parts import VBM_OT_remove_picked_part
from .recipe import is_axis


class VBM_OT_pick_part(bpy.types.Operator):
    """Pick the part of a medial axis under the mouse; X then removes it"""

    bl_idname = "vbm.pick_part"
    bl_label = "Pick Part"
    bl_options = {"UNDO"}

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT" and context.region_data is not None

    def invoke(self, context, event):
        obj, part = picking.under_mouse(context, event.mouse_region_x, event.mouse_region_y)
        if obj is None:
            active, _ = find(context)
            if active is None or active.vbm_axis.active_part < 0:
                return {"PASS_THROUGH"}  # to the view: a click on another object selects it
            active.vbm_axis.active_part = -1
            return {"FINISHED"}
        if context.view_layer.objects.active != obj:
            for other in context.selected_objects:
                other.select_set(False)
            obj.select_set(True)
            context.view_layer.objects.active = obj
        obj.vbm_axis.active_part = part
        self.report({"INFO"}, told(obj, part))
        return {"FINISHED"}


def told(obj, part):
    """What there is to know about a part, in one line."""
    item = obj.vbm_axis.parts[part]
    size = f"{item.edges:,} edges" if item.edges else f"{item.triangles:,} triangles"
    what = "X removes it" if not item.lock else axis_object.lock_text(item.lock)
    return f"{item.name}: level {item.level}, {size}, {item.volume:.3g} % of the volume. {what}"


class VBM_TL_parts(bpy.types.WorkSpaceTool):
    bl_space_type = "VIEW_3D"
    bl_context_mode = "OBJECT"
    bl_idname = "vbm.parts"
    bl_label = "Pick Parts"
    bl_description = ("Pick parts of a medial axis.\n"
                      "Click a part, then press X to remove it and its feature")
    bl_icon = "ops.generic.select"
    bl_widget = None
    bl_keymap = (("vbm.pick_part", {"type": "LEFTMOUSE", "value": "PRESS"}, None),)

    def draw_settings(context, layout, _tool):
        obj, problem = find(context)
        if obj is None:
            layout.label(text=problem)
        elif 0 <= obj.vbm_axis.active_part < len(obj.vbm_axis.parts):
            layout.label(text=told(obj, obj.vbm_axis.active_part))
        else:
            layout.label(text="Click a part of the medial axis")


_CLASSES = (VBM_OT_pick_part,)
_keys = []


def _add_keys():
    keyconfig = bpy.context.window_manager.keyconfigs.addon
    if keyconfig is None:  # without a window
        return
    for name, space in (("Object Mode", "EMPTY"), ("Mesh", "EMPTY")):
        keymap = keyconfig.keymaps.new(name=name, space_type=space)
        # Before Blender's own, which gets the key wherever poll() says no.
        _keys.append((keymap, keymap.keymap_items.new(VBM_OT_remove_picked_part.bl_idname, "X",
                                                      "PRESS", head=True)))


def register():
    for cls in _CLASSES:
        bpy.utils.register_class(cls)
    bpy.utils.register_tool(VBM_TL_parts, after={"builtin.measure"}, separator=True)
    _add_keys()


def unregister():
    for keymap, item in _keys:
        keymap.keymap_items.remove(item)
    _keys.clear()
    bpy.utils.unregister_tool(VBM_TL_parts)
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
