# SPDX-License-Identifier: GPL-3.0-or-later
"""The sidebar's panel of the medial axis: simplify, what was done, the parts, and what to make of them."""

import bpy

from . import (axis_object, axis_options, axis_operator, library, op_axis_of_balls, op_simplify,
               recipe, session, text)

_LOCK_ICONS = {"": "UNLOCKED", "inner": "MESH_PLANE", "tunnel": "LOCKED", "bridge": "LOCKED",
               "last": "LOCKED"}


class VBM_UL_parts(bpy.types.UIList):
    """Colour, name, triangles, volume, lock."""

    def draw_item(self, _context, layout, _data, item, _icon, _active, _property, _index=0,
                  _flag=0):
        row = layout.row(align=True)
        swatch = row.row()
        swatch.ui_units_x = 0.8
        swatch.prop(item, "color", text="")
        row.label(text=f" {item.name}")
        right = row.row(align=True)
        right.alignment = "RIGHT"
        right.label(text=f"{item.volume:.2g} %" if item.volume >= 0.1 else "<0.1 %")
        right.label(text="", icon=_LOCK_ICONS.get(item.lock, "LOCKED"))

    def draw_filter(self, _context, layout):
        row = layout.row(align=True)
        row.prop(self, "filter_name", text="", icon="VIEWZOOM")
        row.prop(self, "use_filter_sort_reverse", text="", icon="SORT_ASC")

    def filter_items(self, _context, data, property_name):
        """Largest volume first: what a user looks for is rarely the smallest."""
        items = getattr(data, property_name)
        helper = bpy.types.UI_UL_list
        flags = (helper.filter_items_by_name(self.filter_name, self.bitflag_filter_item, items,
                                             "name") if self.filter_name else [])
        order = helper.sort_items_helper(list(enumerate(item.volume for item in items)),
                                         key=lambda pair: -pair[1])
        return flags, order


class _Tab:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "VBM"

    @classmethod
    def poll(cls, context):
        return library.vbm is not None


class VBM_PT_axis(_Tab, bpy.types.Panel):
    bl_label = "Medial Axis"
    bl_order = 1

    def draw(self, context):
        layout = self.layout
        layout.enabled = session.job is None
        column = layout.column()
        column.scale_y = 1.4
        column.operator("vbm.simplify_shape", icon="MOD_SIMPLIFY")
        column.operator("vbm.axis_of_balls", icon="MOD_DECIM")
        obj, problem = axis_operator.find(context)
        if obj is None:
            text.draw(layout, context, problem, icon="INFO")


class VBM_PT_scheme(_Tab, bpy.types.Panel):
    bl_label = "Simplification"
    bl_parent_id = "VBM_PT_axis"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        wide = context.region.width > 300 * context.preferences.system.ui_scale
        layout.use_property_split = wide
        layout.use_property_decorate = False
        owner = context.window_manager.operator_properties_last("vbm.simplify_shape")
        op_simplify.draw_own(layout, owner)
        layout.separator()
        axis_options.draw_axis(layout, owner)


class VBM_PT_axis_of_balls(_Tab, bpy.types.Panel):
    bl_label = "Axis of N Balls"
    bl_parent_id = "VBM_PT_axis"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        wide = context.region.width > 300 * context.preferences.system.ui_scale
        layout.use_property_split = wide
        layout.use_property_decorate = False
        op_axis_of_balls.draw_own(
            layout, context.window_manager.operator_properties_last("vbm.axis_of_balls"))


class _OfAxis(_Tab):
    bl_parent_id = "VBM_PT_axis"

    @classmethod
    def poll(cls, context):
        return super().poll(context) and axis_operator.find(context)[0] is not None


class VBM_PT_parts(_OfAxis, bpy.types.Panel):
    bl_label = "Parts"

    def draw(self, context):
        layout = self.layout
        layout.enabled = session.job is None
        obj, _ = axis_operator.find(context)
        own = obj.vbm_axis
        layout.template_list("VBM_UL_parts", "", own, "parts", own, "active_part", rows=5)
        picked = 0 <= own.active_part < len(own.parts)
        if context.mode == "EDIT_MESH":
            picked = False
            text.draw(layout, context, "X removes the parts of the selected faces", icon="INFO")
        elif picked:
            self._part(layout, context, own.parts[own.active_part])
        else:
            text.draw(layout, context, "Pick a part: in this list, or with the tool Pick Parts in "
                      "the viewport. X removes it", icon="INFO")
        row = layout.row()
        row.enabled = not picked or not own.parts[own.active_part].lock
        row.operator("vbm.remove_part", icon="X").part = -1

    def _part(self, layout, context, item):
        box = layout.box().column(align=True)
        size = f"{item.edges:,} edges" if item.edges else f"{item.triangles:,} triangles"
        box.label(text=f"Level {item.level}, {size}")
        box.label(text=f"{item.volume:.3g} % of the volume")
        text.draw(box, context, axis_object.lock_text(item.lock),
                  icon=_LOCK_ICONS.get(item.lock, "LOCKED"))


class VBM_PT_steps(_OfAxis, bpy.types.Panel):
    bl_label = "Steps"

    def draw(self, context):
        layout = self.layout
        layout.enabled = session.job is None
        obj, _ = axis_operator.find(context)
        box = layout.box().column(align=True)
        done = recipe.described(obj)
        for number, line in enumerate(done, 1):
            text.draw(box, context, f"{number}. {line}")
        if not done:
            box.label(text="None: the axis is whole")
        column = layout.column(align=True)
        column.operator("vbm.prune_axis", icon="BRUSH_DATA")
        column.operator("vbm.undo_axis_step", icon="LOOP_BACK")


class VBM_PT_derived(_OfAxis, bpy.types.Panel):
    bl_label = "Made From It"

    def draw(self, context):
        layout = self.layout
        layout.enabled = session.job is None
        column = layout.column(align=True)
        column.operator("vbm.topology_graph", icon="OUTLINER_OB_ARMATURE")
        column.operator("vbm.curve_skeleton", icon="OUTLINER_OB_CURVE")
        column.operator("vbm.make_armature", icon="ARMATURE_DATA")
        column.operator("vbm.part_groups", icon="GROUP_VERTEX")


_CLASSES = (VBM_UL_parts, VBM_PT_axis, VBM_PT_scheme, VBM_PT_axis_of_balls, VBM_PT_parts, VBM_PT_steps, VBM_PT_derived)


def register():
    for cls in _CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
