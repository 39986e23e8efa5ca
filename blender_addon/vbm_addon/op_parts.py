# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators: take parts of a medial axis away, by hand or by significance, and take a step back."""

import bpy
from bpy.props import EnumProperty, IntProperty

from . import axis_object, axis_options, source, steps
from .axis_operator import AxisOperator, find
from .recipe import Recipe, is_axis


class RemovesParts(AxisOperator):
    """Mixin: takes parts away by hand."""

    doing = "Removing a part"
    modes = {"OBJECT", "EDIT_MESH"}
    part = -1

    @classmethod
    def poll(cls, context):
        if not super().poll(context):
            return False
        if context.mode == "EDIT_MESH" and not is_axis(context.active_object):
            cls.poll_message_set("The object in Edit Mode is not a medial axis")
            return False
        return True

    def new_steps(self, context, obj, done):
        own = obj.vbm_axis
        if self.part >= 0:
            chosen = [self.part]
        elif context.mode == "EDIT_MESH":
            chosen = axis_object.selected_parts(obj)
            if not chosen:
                raise source.SourceError("Select a face of the part first")
        elif own.active_part >= 0:
            chosen = [own.active_part]
        else:
            raise source.SourceError("Pick a part first: in the list, or by a click with the tool "
                                     "Pick Parts")
        if chosen[-1] >= len(own.parts):
            raise source.SourceError(f"{obj.name} has no part {chosen[-1]}: its parts are 0 to "
                                     f"{len(own.parts) - 1}")
        for number in chosen:
            lock = own.parts[number].lock
            if lock and len(chosen) == 1:
                raise source.SourceError(f"{own.parts[number].name} of {obj.name} stays. "
                                         f"{axis_object.lock_text(lock)}")
        places = tuple(tuple(own.parts[number].place) for number in chosen)
        return done + (steps.Remove(tuple(chosen), places),)


class VBM_OT_remove_part(RemovesParts, bpy.types.Operator):
    """Remove the picked part of the medial axis and its feature from the simplified surface. In Edit \
Mode: the parts of the selected faces"""

    bl_idname = "vbm.remove_part"
    bl_label = "Remove Part"

    part: IntProperty(name="Part", default=-1, min=-1, options={"SKIP_SAVE"},
                      description="Its number in the list; -1 for the picked or selected ones")


class VBM_OT_remove_picked_part(RemovesParts, bpy.types.Operator):
    """Remove the picked part of the medial axis and its feature from the simplified surface"""

    bl_idname = "vbm.remove_picked_part"
    bl_label = "Remove Picked Part"

    @classmethod
    def poll(cls, context):
        """Only where X is meant for a part. Anywhere else the key goes on to Blender's own X."""
        obj = context.active_object
        if not is_axis(obj) or not super().poll(context):
            return False
        return context.mode == "EDIT_MESH" or 0 <= obj.vbm_axis.active_part < len(obj.vbm_axis.parts)


class VBM_OT_prune_axis(AxisOperator, bpy.types.Operator):
    """Remove all parts at the border of the medial axis that are not more significant than a \
threshold, the least significant first, and their features from the simplified surface"""

    bl_idname = "vbm.prune_axis"
    bl_label = "Prune"
    doing = "Pruning the axis"

    measure: EnumProperty(name="By", items=axis_options.measure_items(True), default="VOLUME",
                          description="How significant a part is")
    threshold: axis_options.threshold(1.0, "Up To")
    rounds: IntProperty(name="Rounds", default=1, min=1, max=1000, soft_max=10,
                        description="How often: when parts are gone, those behind them are at the "
                        "border")

    def new_steps(self, context, obj, done):
        measure = self.measure.lower()
        return done + (steps.Prune(measure, steps.from_shown(measure, self.threshold),
                                   self.rounds),)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "measure")
        unit = axis_options.unit_label(self.measure)
        layout.prop(self, "threshold", text=f"Up To ({unit})")
        layout.prop(self, "rounds")


class VBM_OT_undo_axis_step(AxisOperator, bpy.types.Operator):
    """Bring back what the last step took from the medial axis, also in a file opened anew"""

    bl_idname = "vbm.undo_axis_step"
    bl_label = "Take Back Last Step"
    doing = "Taking a step back"

    @classmethod
    def poll(cls, context):
        if not super().poll(context):
            return False
        obj, _ = find(context)
        try:
            if Recipe.of(obj).steps:
                return True
            cls.poll_message_set("It is whole: no step was taken")
        except source.SourceError as error:
            cls.poll_message_set(str(error))
        return False

    def new_steps(self, context, obj, done):
        return done[:-1]


_CLASSES = (VBM_OT_remove_part, VBM_OT_remove_picked_part, VBM_OT_prune_axis, VBM_OT_undo_axis_step)


def register():
    for cls in _CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
