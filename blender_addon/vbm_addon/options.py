# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user can choose before balls are built, the same for every operator.

The library describes its own parameters (vbm.parameters()); the Blender properties are made from that
table, so that names, help and ranges are the library's. Operators carry these properties for scripts
and for the redo panel; the sidebar keeps one set, `WindowManager.vbm`, that invoked operators start
from, so that three buttons pressed one after the other work on one and the same model.
"""

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty

from .library import vbm

_INT_MAX = 2**31 - 1
_FLOAT_MAX = 3.4e38
# Label rules for kinds of input that Blender does not have.
_NOT_IN_BLENDER = {"labels": {"voxels", "scan"}}
# Shown apart from the first choices.
_RARELY_NEEDED = {"drop_invalid", "sample_limit", "cell_limit"}


def _property(parameter, flags):
    common = {"name": parameter["label"], "description": parameter["help"], "options": flags}
    kind, default = parameter["type"], parameter["default"]
    if kind == "bool":
        return BoolProperty(default=default, **common)
    if kind == "enum":
        unfit = _NOT_IN_BLENDER.get(parameter["name"], ())
        # Blender writes identifiers in capitals.
        items = [(name.upper(), label, tip, value)
                 for value, (name, label, tip) in enumerate(parameter["items"])
                 if name not in unfit]
        return EnumProperty(items=items, default=default.upper(), **common)
    low, high = parameter["minimum"], parameter["maximum"]
    if kind == "int":
        return IntProperty(default=default, min=max(low, -_INT_MAX), max=min(high, _INT_MAX),
                           **common)
    length = {"subtype": "DISTANCE"} if kind == "length" else {}
    return FloatProperty(default=default, min=max(low, -_FLOAT_MAX), max=min(high, _FLOAT_MAX),
                         precision=4 if length else 3, **length, **common)


def table(operation):
    """The library's parameters of an operation."""
    return [row for row in vbm.parameters() if row["operation"] == operation] if vbm else []


def properties_of(operation, flags):
    """A Blender property for each parameter of an operation, by name."""
    return {row["name"]: _property(row, flags) for row in table(operation)}


def arguments_of(owner, names):
    """The library's keyword arguments that `owner`'s properties of these names stand for."""
    return {name: _as_meant(getattr(owner, name)) for name in names}


def _as_meant(value):
    """Identifiers in the library's small letters; the number that the field shows, 0.01, not the float that is
    nearest to it and may be out of range."""
    if isinstance(value, float):
        return float(str(np.float32(value)))
    return value.lower() if isinstance(value, str) else value


BUILD_NAMES = tuple(row["name"] for row in table("build"))


def _annotations(flags, with_modifiers=True):
    properties = properties_of("build", flags)
    properties["ignore_faces"] = BoolProperty(
        name="Points Only", options=flags,
        description="Forget the faces and take the vertices alone, as of a scan")
    properties["normals_attribute"] = StringProperty(
        name="Normals", options=flags,
        description="Points: the vector attribute of the vertices that holds their outward "
        "normals; empty for none")
    if with_modifiers:
        properties["use_modifiers"] = BoolProperty(
            name="Apply Modifiers", default=True, options=flags,
            description="Take the mesh as the modifiers leave it in the viewport")
    return properties


def build_arguments(owner):
    """The keyword arguments for vbm.build() that `owner`'s properties stand for."""
    return arguments_of(owner, BUILD_NAMES)


class OwnMeshOptions:
    """For operators whose results belong to the user's own vertices: no modifiers in between."""

    __annotations__ = _annotations({"SKIP_SAVE"}, with_modifiers=False)
    use_modifiers = False


class BuildOptions:
    """For operators that make a new object."""

    __annotations__ = _annotations({"SKIP_SAVE"})


def _has(owner, name):
    return name in getattr(owner, "properties", owner).bl_rna.properties


def _shared_names(operator):
    return [name for name in VBM_Settings.bl_rna.properties.keys()
            if name not in ("rna_type", "name") and _has(operator, name)]


def take_shared(operator, context):
    """Give an invoked operator the sidebar's choices, where the caller has made none."""
    for name in _shared_names(operator):
        if not operator.properties.is_property_set(name):
            setattr(operator, name, getattr(context.window_manager.vbm, name))


def keep_shared(operator, context):
    """What was chosen in the redo panel is what the next operator starts from."""
    for name in _shared_names(operator):
        setattr(context.window_manager.vbm, name, getattr(operator, name))


def draw_property(layout, owner, name, slider=False):
    """A property; where labels have no column of their own, a menu or text gets half the width."""
    kind = getattr(owner, "properties", owner).bl_rna.properties[name]
    if layout.use_property_split or kind.type not in {"ENUM", "STRING"}:
        layout.prop(owner, name, slider=slider)
        return
    halves = layout.split(factor=0.5, align=True)
    halves.label(text=kind.name)
    halves.prop(owner, name, text="")


def draw_source(layout, owner):
    draw_property(layout, owner, "ignore_faces")
    if owner.ignore_faces:
        draw_property(layout, owner, "normals_attribute")
    if _has(owner, "use_modifiers"):
        draw_property(layout, owner, "use_modifiers")


def draw_build(layout, owner, rare):
    """The library's parameters; `rare` asks for the seldom needed ones instead of the others."""
    for name in BUILD_NAMES:
        if (name in _RARELY_NEEDED) == rare:
            draw_property(layout, owner, name)


class VBM_Settings(bpy.types.PropertyGroup):
    """The sidebar's choices, for as long as Blender runs."""

    __annotations__ = dict(_annotations(set()), progress=FloatProperty(
        name="Progress", subtype="PERCENTAGE", min=0.0, max=100.0, precision=0))


def register():
    bpy.utils.register_class(VBM_Settings)
    bpy.types.WindowManager.vbm = bpy.props.PointerProperty(type=VBM_Settings)


def unregister():
    del bpy.types.WindowManager.vbm
    bpy.utils.unregister_class(VBM_Settings)
