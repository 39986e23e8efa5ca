# SPDX-License-Identifier: GPL-3.0-or-later
"""The sidebar tab: what is worked on, the three buttons, their options, what came of it."""

import bpy
from bpy.props import FloatVectorProperty

from . import (colors, job_operator, library, op_balls, op_surface, op_thickness, options, session,
               source, text)


#: Notes shown with the result; the others are folded away, or the panels below would be out of sight.
_NOTES = 2


class _Tab:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "VBM"


def last(context, identifier):
    """The choices the operator will start from: those of its last run."""
    return context.window_manager.operator_properties_last(identifier)


class VBM_PT_main(_Tab, bpy.types.Panel):
    bl_label = "Ball Model"

    def draw(self, context):
        layout = self.layout
        if library.vbm is None:
            text.draw(layout.box(), context, library.problem, icon="ERROR")
            return
        obj, problem = source.resolve(context)
        if obj is None:
            text.draw(layout, context, problem, icon="INFO")
        else:
            column = layout.column(align=True)
            column.label(text=obj.name, icon=f"OUTLINER_OB_{obj.type}")
            if obj.type == "MESH":
                kind = "vertices" if obj.data.polygons else "loose points"
                column.label(text=f"{len(obj.data.vertices):,} {kind}", icon="BLANK1")
        if session.job is not None:
            job_operator.draw_running(layout, context)
        column = layout.column(align=True)
        column.scale_y = 1.4
        column.enabled = session.job is None
        column.operator("vbm.build_balls", icon="OUTLINER_OB_POINTCLOUD")
        column.operator("vbm.rebuild_surface", icon="OUTLINER_OB_MESH")
        column.operator("vbm.measure_thickness", icon="MOD_THICKNESS")


class VBM_PT_result(_Tab, bpy.types.Panel):
    bl_label = "Last Result"
    bl_parent_id = "VBM_PT_main"

    @classmethod
    def poll(cls, context):
        return bool(session.last.title)

    def draw(self, context):
        last, layout = session.last, self.layout
        box = layout.box()
        if last.failed:
            for line in last.lines:
                text.draw(box, context, line, icon="CANCEL")
        else:
            text.draw(box, context, last.title, icon="CHECKMARK")
            for line in last.lines:
                text.draw(box, context, line, icon="BLANK1")
        for note in last.notes[:_NOTES]:
            text.draw(box, context, note, icon="INFO")
        if last.elements:
            box.operator("vbm.select_faulty", icon="RESTRICT_SELECT_OFF")


class VBM_PT_notes(_Tab, bpy.types.Panel):
    bl_label = "More Notes"
    bl_parent_id = "VBM_PT_result"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return len(session.last.notes) > _NOTES

    def draw(self, context):
        box = self.layout.box()
        for note in session.last.notes[_NOTES:]:
            text.draw(box, context, note, icon="INFO")


class VBM_PT_legend(_Tab, bpy.types.Panel):
    bl_label = "Thickness Colors"
    bl_parent_id = "VBM_PT_main"

    @classmethod
    def poll(cls, context):
        obj = context.active_object
        return (obj is not None and obj.type == "MESH" and op_thickness.LEGEND_KEY in obj.data)

    def draw(self, context):
        legend = context.active_object.data[op_thickness.LEGEND_KEY]
        layout = self.layout
        swatches = layout.row(align=True)
        scale = legend["scale"]
        for index in range(len(colors.stops(scale))):
            swatches.prop(context.window_manager.vbm_swatches, f"{scale}_{index}", text="")
        ends = layout.row()
        ends.label(text=f"{legend['low']:.4g}")
        right = ends.row()
        right.alignment = "RIGHT"
        right.label(text=f"{legend['high']:.4g}")
        if legend["thin_below"] > 0.0:
            row = layout.row()
            cell = row.row()
            cell.ui_units_x = 1.5
            cell.prop(context.window_manager.vbm_swatches, "warning", text="")
            row.label(text=f"below {legend['thin_below']:.4g}: {legend['thin']:,} vertices")
        space = context.space_data
        if space.shading.type == "SOLID" and space.shading.color_type != "VERTEX":
            layout.prop(space.shading, "color_type", text="Show")


class Options(_Tab):
    bl_parent_id = "VBM_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return library.vbm is not None

    def prepare(self, context):
        # In a sidebar as narrow as Blender's own default, labels in a column of their own are cut.
        wide = context.region.width > 300 * context.preferences.system.ui_scale
        self.layout.use_property_split = wide
        self.layout.use_property_decorate = False
        return self.layout


class VBM_PT_build(Options, bpy.types.Panel):
    bl_label = "Samples and Balls"

    def draw(self, context):
        layout, shared = self.prepare(context), context.window_manager.vbm
        options.draw_source(layout, shared)
        options.draw_build(layout, shared, rare=False)


class VBM_PT_limits(Options, bpy.types.Panel):
    bl_label = "Limits"
    bl_parent_id = "VBM_PT_build"

    def draw(self, context):
        options.draw_build(self.prepare(context), context.window_manager.vbm, rare=True)


class VBM_PT_balls(Options, bpy.types.Panel):
    bl_label = "Balls"

    def draw(self, context):
        op_balls.draw_own(self.prepare(context), last(context, "vbm.build_balls"))


class VBM_PT_surface(Options, bpy.types.Panel):
    bl_label = "Surface"

    def draw(self, context):
        op_surface.draw_own(self.prepare(context), last(context, "vbm.rebuild_surface"))


class VBM_PT_thickness(Options, bpy.types.Panel):
    bl_label = "Thickness"

    def draw(self, context):
        layout = self.prepare(context)
        op_thickness.draw_own(layout, last(context, "vbm.measure_thickness"))
        layout.operator("vbm.select_undersampled", icon="RESTRICT_SELECT_OFF")


def _swatch(color):
    """A colour that shows in the legend, and stays what it is when clicked."""
    return FloatVectorProperty(name="Color", subtype="COLOR_GAMMA", size=3, min=0.0, max=1.0,
                               description="Belongs to the thickness written below",
                               get=lambda _self: tuple(color), set=lambda _self, _value: None)


class VBM_Swatches(bpy.types.PropertyGroup):
    """The legend's colours."""

    __annotations__ = {"warning": _swatch(colors.WARNING)}
    for _scale, *_ in colors.ITEMS:
        for _index, _color in enumerate(colors.stops(_scale)):
            __annotations__[f"{_scale}_{_index}"] = _swatch(_color.tolist())


_CLASSES = (VBM_Swatches, VBM_PT_main, VBM_PT_legend, VBM_PT_result, VBM_PT_notes, VBM_PT_build, VBM_PT_limits,
            VBM_PT_balls, VBM_PT_surface, VBM_PT_thickness)


def register():
    for cls in _CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.WindowManager.vbm_swatches = bpy.props.PointerProperty(type=VBM_Swatches)


def unregister():
    del bpy.types.WindowManager.vbm_swatches
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
