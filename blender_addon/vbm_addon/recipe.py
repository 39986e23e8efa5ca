# SPDX-License-Identifier: GPL-3.0-or-later
"""What defines an axis object, kept on the object itself: `Object.vbm_axis`.

The computed axis is not saved. Its source, its options and its steps are, as text, so that undo, redo,
saving and appending carry them; from these it is found in the cache or computed again. The list of
parts is a copy for the sidebar to show.
"""

import bpy
from bpy.props import (BoolProperty, CollectionProperty, FloatProperty, FloatVectorProperty,
                       IntProperty, PointerProperty, StringProperty)

from . import source, steps

_EDITION = 1


class Recipe:
    """Options of reading, building, axis, surface and skeleton, the source's digest, and the steps."""

    def __init__(self, reading, build, axis, surface, skeleton, digest, done=()):
        self.reading = reading
        self.build = build
        self.axis = axis
        self.surface = surface
        self.skeleton = skeleton
        self.digest = digest
        self.steps = done

    def dumps(self):
        return steps.dumps({"edition": _EDITION, "reading": self.reading, "build": self.build,
                            "axis": self.axis, "surface": self.surface, "skeleton": self.skeleton,
                            "digest": self.digest, "steps": steps.to_plain(self.steps)})

    @classmethod
    def of(cls, obj):
        """The recipe on an axis object. Raises SourceError where it cannot be read."""
        try:
            plain = steps.loads(obj.vbm_axis.recipe)
            if plain["edition"] != _EDITION:
                raise source.SourceError(f"{obj.name} was made by another version of this add-on: "
                                         "simplify the shape anew")
            return cls(*(dict(plain[key]) for key in ("reading", "build", "axis", "surface",
                                                         "skeleton")),
                       str(plain["digest"]), steps.from_plain(plain["steps"]))
        except (KeyError, TypeError, ValueError, AttributeError) as error:
            raise source.SourceError(f"What {obj.name} was made from cannot be read any more: "
                                     "simplify the shape anew") from error


def is_axis(obj):
    own = source.axis_state(obj)
    return own is not None and obj.type == "MESH" and bool(own.recipe)


def described(obj):
    """The steps of an axis object in words, or the reason why there are none."""
    try:
        return [step.describe() for step in Recipe.of(obj).steps]
    except source.SourceError as error:
        return [str(error)]


class VBM_AxisPart(bpy.types.PropertyGroup):
    """A part of the medial axis, as the sidebar lists it."""

    level: IntProperty(name="Level", description="1: it has a border; 2: it touches a part of "
                       "level 1, and so on")
    lock: StringProperty(name="Lock", description="Why it cannot go; empty if it can")
    triangles: IntProperty(name="Triangles")
    edges: IntProperty(name="Edges", description="Edges of a curve")
    volume: FloatProperty(name="Volume", description="Share of the shape's volume that it stands "
                          "for, in percent")
    place: FloatVectorProperty(name="Place", size=3, precision=6, description="Its middle")
    color: FloatVectorProperty(name="Color", subtype="COLOR", size=3, min=0.0, max=1.0,
                               description="Its colour in the viewport")


class VBM_Axis(bpy.types.PropertyGroup):
    """What an axis object knows of itself."""

    recipe: StringProperty(name="Recipe")
    source: PointerProperty(type=bpy.types.Object, name="Source",
                            description="The object whose medial axis this is")
    surface: PointerProperty(type=bpy.types.Object, name="Simplified Surface",
                             description="The surface of the parts that are left")
    graph: PointerProperty(type=bpy.types.Object, name="Topology Graph",
                           description="The topology graph of the parts that are left")
    skeleton: PointerProperty(type=bpy.types.Object, name="Curve Skeleton",
                              description="The curve skeleton of the parts that are left")
    parts: CollectionProperty(type=VBM_AxisPart)
    active_part: IntProperty(name="Part", default=-1, min=-1,
                             description="The part that is picked; -1 for none")
    owner: PointerProperty(type=bpy.types.Object, name="Axis",
                           description="The axis object that this one follows")
    follows: BoolProperty(name="Follows", description="Whether the object stands for what its axis "
                          "was computed from, as a graph does")


_CLASSES = (VBM_AxisPart, VBM_Axis)


def register():
    for cls in _CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Object.vbm_axis = PointerProperty(type=VBM_Axis)


def unregister():
    del bpy.types.Object.vbm_axis
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
