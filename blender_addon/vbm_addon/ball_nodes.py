# SPDX-License-Identifier: GPL-3.0-or-later
"""How balls are shown: Geometry Nodes that put a sphere on every vertex, and the material.

The group needs nothing of the add-on, so a file with balls looks the same where it is not installed.
It reads the attribute `radius`, writes the colour attribute `vbm_color`, and the material shows that.
"""

import bpy
import numpy as np

from . import colors, compat
from .creation import undone_on_failure

NAME = "VBM Balls"
COLOR = "vbm_color"
#: Changes when the group's inputs do, so that an older file's group is not taken for it.
_EDITION = 1
_EDITION_KEY = "vbm_edition"

SCALE, DETAIL, LOW, HIGH = "Ball Scale", "Detail", "Smallest Radius", "Largest Radius"
SOLID, MATERIAL = "Colors in Solid Mode", "Material"


def _find(collection, **attributes):
    for datablock in collection:
        if (datablock.get(_EDITION_KEY) == _EDITION and datablock.library is None
                and all(getattr(datablock, key) == value for key, value in attributes.items())):
            return datablock
    return None


def material():
    """The material of all ball objects, made if the file has none. (material, is it new)"""
    found = _find(bpy.data.materials)
    if found is not None:
        return found, False
    with undone_on_failure() as made:
        result = bpy.data.materials.new(NAME)
        made.append((bpy.data.materials, result))
        result[_EDITION_KEY] = _EDITION
        compat.enable_material_nodes(result)
        tree = result.node_tree
        shader = next(node for node in tree.nodes if node.type == "BSDF_PRINCIPLED")
        shader.inputs["Roughness"].default_value = 0.6
        # Spheres that are instances carry the colour on the instance, realised ones on their
        # vertices. Each of the two is black where the other applies, so their sum is right for both.
        mix = tree.nodes.new("ShaderNodeVectorMath")
        mix.operation = "ADD"
        mix.location = (-200, 200)
        for index, kind in enumerate(("GEOMETRY", "INSTANCER")):
            node = tree.nodes.new("ShaderNodeAttribute")
            node.attribute_type = kind
            node.attribute_name = COLOR
            node.location = (-400, 300 - 200 * index)
            tree.links.new(node.outputs["Color"], mix.inputs[index])
        tree.links.new(mix.outputs["Vector"], shader.inputs["Base Color"])
    return result, True


def _fill_ramp(ramp, scale):
    stops = colors.to_linear(colors.stops(scale))
    positions = np.linspace(0.0, 1.0, len(stops))
    elements = ramp.elements
    while len(elements) < len(stops):
        elements.new(0.5)
    for element, position, color in zip(elements, positions, stops):
        element.position = position
        element.color = (*color, 1.0)


def _socket(sockets, name):
    """The socket in use: nodes that work on several types have one of each name and type."""
    return next(socket for socket in sockets if socket.name == name and socket.enabled)


def _build(tree):
    kinds = (("Geometry", "NodeSocketGeometry", {}),
             (SCALE, "NodeSocketFloat", dict(default=1.0, minimum=0.0,
                                             tip="Size of the spheres shown, times their radius")),
             (DETAIL, "NodeSocketInt", dict(default=2, minimum=1, maximum=5,
                                            tip="Subdivisions of the spheres")),
             (LOW, "NodeSocketFloat", dict(default=0.0, tip="Radius of the first colour")),
             (HIGH, "NodeSocketFloat", dict(default=1.0, tip="Radius of the last colour")),
             (SOLID, "NodeSocketBool", dict(default=True, tip="Make the spheres real, so that "
                                            "Solid mode can colour them; instances take less memory")),
             (MATERIAL, "NodeSocketMaterial", {}))
    for name, kind, more in kinds:
        compat.new_group_socket(tree, "INPUT", kind, name, **more)
    compat.new_group_socket(tree, "OUTPUT", "NodeSocketGeometry", "Geometry")
    compat.mark_as_modifier(tree)

    place = iter(range(0, 20))

    def node(kind, **settings):
        made = tree.nodes.new(kind)
        made.location = (200 * next(place), 0)
        for key, value in settings.items():
            setattr(made, key, value)
        return made

    def link(source, target):
        tree.links.new(source, target)

    given = node("NodeGroupInput")
    radius = node("GeometryNodeInputNamedAttribute", data_type="FLOAT")
    radius.inputs["Name"].default_value = "radius"
    radius_value = _socket(radius.outputs, "Attribute")

    # Colour by radius.
    fraction = node("ShaderNodeMapRange")
    link(radius_value, _socket(fraction.inputs, "Value"))
    link(given.outputs[LOW], _socket(fraction.inputs, "From Min"))
    link(given.outputs[HIGH], _socket(fraction.inputs, "From Max"))
    ramp = node("ShaderNodeValToRGB", label="Colors")
    _fill_ramp(ramp.color_ramp, "VIRIDIS")
    link(_socket(fraction.outputs, "Result"), ramp.inputs["Fac"])
    store = node("GeometryNodeStoreNamedAttribute", data_type="FLOAT_COLOR", domain="POINT")
    store.inputs["Name"].default_value = COLOR
    link(given.outputs["Geometry"], store.inputs["Geometry"])
    link(ramp.outputs["Color"], _socket(store.inputs, "Value"))

    # A sphere at every vertex.
    sphere = node("GeometryNodeMeshIcoSphere")
    sphere.inputs["Radius"].default_value = 1.0
    link(given.outputs[DETAIL], sphere.inputs["Subdivisions"])
    smooth = node("GeometryNodeSetShadeSmooth")
    link(sphere.outputs["Mesh"], smooth.inputs[0])
    painted = node("GeometryNodeSetMaterial")
    link(smooth.outputs[0], painted.inputs[0])
    link(given.outputs[MATERIAL], painted.inputs["Material"])
    size = node("ShaderNodeMath", operation="MULTIPLY")
    link(radius_value, size.inputs[0])
    link(given.outputs[SCALE], size.inputs[1])
    spread = node("GeometryNodeInstanceOnPoints")
    link(store.outputs["Geometry"], spread.inputs["Points"])
    link(painted.outputs[0], spread.inputs["Instance"])
    link(size.outputs["Value"], spread.inputs["Scale"])

    real = node("GeometryNodeRealizeInstances")
    link(spread.outputs["Instances"], real.inputs[0])
    choose = node("GeometryNodeSwitch", input_type="GEOMETRY")
    link(given.outputs[SOLID], _socket(choose.inputs, "Switch"))
    link(spread.outputs["Instances"], _socket(choose.inputs, "False"))
    link(real.outputs[0], _socket(choose.inputs, "True"))
    result = node("NodeGroupOutput")
    link(_socket(choose.outputs, "Output"), result.inputs["Geometry"])


def node_group():
    """The node group of all ball objects, made if the file has none. (group, is it new)"""
    found = _find(bpy.data.node_groups, bl_idname="GeometryNodeTree")
    if found is not None:
        return found, False
    with undone_on_failure() as made:
        tree = bpy.data.node_groups.new(NAME, "GeometryNodeTree")
        made.append((bpy.data.node_groups, tree))
        tree[_EDITION_KEY] = _EDITION
        _build(tree)
    return tree, True
