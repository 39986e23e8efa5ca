# SPDX-License-Identifier: GPL-3.0-or-later
"""Operator: an armature along the curve skeleton of a medial axis, and a mesh bound to it if asked."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

from . import armature, creation, op_graphs, options, session, source
from .axis_operator import AxisOperator, follower


class VBM_OT_make_armature(op_graphs.SkeletonOptions, AxisOperator, bpy.types.Operator):
    """Make an armature along the medial axis: a chain of bones for every branch of its curve skeleton. \
Prune the axis first, for fewer branches"""

    bl_idname = "vbm.make_armature"
    bl_label = "Armature"
    doing = "Making the armature"

    bone_length: FloatProperty(
        name="Bone Length", default=1.0, min=0.01, soft_max=10.0,
        description="How long a bone is, times the thickness of the shape there")
    most_bones: IntProperty(name="Most Bones per Branch", default=8, min=1, soft_max=50, max=1000,
                            description="A branch gets no more")
    drop_stubs: BoolProperty(
        name="Leave Out Stubs", default=True,
        description="No bones for side branches that end within the ball they begin in")
    bind: EnumProperty(
        name="Bind", default="NONE", description="Which mesh the bones are to move",
        items=[("NONE", "Nothing", "The armature alone"),
               ("SOURCE", "Source", "The object that the axis was computed from, with automatic "
                "weights"),
               ("SURFACE", "Simplified Surface", "The simplified surface, with automatic weights")])

    def new_steps(self, context, obj, done):
        return done

    def _prepare(self, context):
        obj, request = super()._prepare(context)
        request.wanted.surface = False
        request.wanted.skeleton = options.arguments_of(self, op_graphs.SKELETON_NAMES)
        if self.bind == "SOURCE" and obj.vbm_axis.source.type != "MESH":
            raise source.SourceError(f"{obj.vbm_axis.source.name} is not a mesh: it cannot be bound "
                                     "with automatic weights")
        if self.bind == "SURFACE" and follower(context, obj, "surface") is None:
            raise source.SourceError(f"{obj.name} has no simplified surface to bind")
        return obj, request

    def finish(self, context, obj, request, result):
        found = armature.chains(result.skeleton, self.bone_length, self.most_bones,
                                self.drop_stubs)
        if not found:
            raise source.SourceError(f"The skeleton of {obj.vbm_axis.source.name} is a point: there "
                                     "is nothing for bones to follow")
        notes = []
        with creation.undone_on_failure() as made:
            rig = armature.make(context, made, found, obj.vbm_axis.source)
            if self.bind != "NONE":
                target = (obj.vbm_axis.source if self.bind == "SOURCE"
                          else follower(context, obj, "surface"))
                notes = _bind(context, rig, target)
        bones = len(rig.data.bones)
        return session.Outcome(f"{rig.name}: {bones:,} bones in {len(found):,} chains",
                               [], notes)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        for name in ("bone_length", "most_bones", "drop_stubs", "bind"):
            layout.prop(self, name)
        layout.separator()
        for name in op_graphs.SKELETON_NAMES:
            layout.prop(self, name)


def _bind(context, rig, target):
    """Parent a mesh to the armature with automatic weights. Returns what there is to note."""
    if target.hide_get():
        creation.hide(target, False)
    before = len(target.vertex_groups)
    creation.select_alone(context, rig)
    target.select_set(True)
    bpy.ops.object.parent_set(type="ARMATURE_AUTO")
    creation.select_alone(context, rig)
    own = {group.index for group in target.vertex_groups[before:]}
    free = sum(not any(element.group in own and element.weight > 0.0 for element in vertex.groups)
               for vertex in target.data.vertices)
    return [f"{free:,} of {len(target.data.vertices):,} vertices of {target.name} follow no bone: "
            "Blender found no weights for them"] if free else []


def register():
    bpy.utils.register_class(VBM_OT_make_armature)


def unregister():
    bpy.utils.unregister_class(VBM_OT_make_armature)
