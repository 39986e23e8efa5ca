# SPDX-License-Identifier: GPL-3.0-or-later
"""How balls are shown: Geometry Nodes that put a sphere on every vertex, and the material.

The group needs nothing of the add-on, so a file with balls looks the same where it is not installed.
It reads the attribute `radius`, writes the colour attribute `vbm_color`, and the material shows that.
"""

import bpy
import numpy as np

from . import colors, compat, node_building
from .creation import undone_on_failure

NAME = "VBM Balls"
COLOR = "vbm_color"
#: Within the group: which vertices are the balls' centres.
_CENTER = "vbm_center"
#: Changes when the group does, so that an older file's group is not taken for it.
_EDITION = 2
_EDITION_KEY = "vbm_edition"

SCALE, DETAIL, LOW, HIGH = "Ball Scale", "Detail", "Smallest Radius", "Largest Radius"
SOLID, MATERIAL = "Colors in Solid Mode", "Material"


def material():
    """The material of all ball objects, made if the file has none. (material, is it new)"""
    found = node_building.find(bpy.data.materials, _EDITION_KEY, _EDITION)
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

    node, link = node_building.tools(tree)

    given = node("NodeGroupInput")
    radius = node("GeometryNodeInputNamedAttribute", data_type="FLOAT")
    radius.inputs["Name"].default_value = "radius"
    radius_value = node_building.socket(radius.outputs, "Attribute")

    # Colour by radius.
    fraction = node("ShaderNodeMapRange")
    link(radius_value, node_building.socket(fraction.inputs, "Value"))
    link(given.outputs[LOW], node_building.socket(fraction.inputs, "From Min"))
    link(given.outputs[HIGH], node_building.socket(fraction.inputs, "From Max"))
    ramp = node("ShaderNodeValToRGB", label="Colors")
    _fill_ramp(ramp.color_ramp, "VIRIDIS")
    link(node_building.socket(fraction.outputs, "Result"), ramp.inputs["Fac"])
    store = node("GeometryNodeStoreNamedAttribute", data_type="FLOAT_COLOR", domain="POINT")
    store.inputs["Name"].default_value = COLOR
    link(given.outputs["Geometry"], store.inputs["Geometry"])
    link(ramp.outputs["Color"], node_building.socket(store.inputs, "Value"))

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
    # From 4.0 on Solid mode shows the colours that the first of joined meshes has as its active ones: so the balls'
    # own mesh comes first, and what it brought along goes again.
    marked = node("GeometryNodeStoreNamedAttribute", data_type="BOOLEAN", domain="POINT")
    marked.inputs["Name"].default_value = _CENTER
    node_building.socket(marked.inputs, "Value").default_value = True
    link(store.outputs["Geometry"], marked.inputs["Geometry"])
    both = node("GeometryNodeJoinGeometry")
    link(real.outputs[0], both.inputs[0])
    link(marked.outputs["Geometry"], both.inputs[0])  # the last one linked is the first
    center = node("GeometryNodeInputNamedAttribute", data_type="BOOLEAN")
    center.inputs["Name"].default_value = _CENTER
    without = node("GeometryNodeDeleteGeometry", domain="POINT")
    link(both.outputs[0], without.inputs["Geometry"])
    link(node_building.socket(center.outputs, "Attribute"), without.inputs["Selection"])
    clean = node("GeometryNodeRemoveAttribute")
    clean.inputs["Name"].default_value = _CENTER
    link(without.outputs[0], clean.inputs["Geometry"])
    choose = node("GeometryNodeSwitch", input_type="GEOMETRY")
    link(given.outputs[SOLID], node_building.socket(choose.inputs, "Switch"))
    link(spread.outputs["Instances"], node_building.socket(choose.inputs, "False"))
    link(clean.outputs["Geometry"], node_building.socket(choose.inputs, "True"))
    result = node("NodeGroupOutput")
    link(node_building.socket(choose.outputs, "Output"), result.inputs["Geometry"])


def node_group():
    """The node group of all ball objects, made if the file has none. (group, is it new)"""
    return node_building.group(NAME, _EDITION_KEY, _EDITION, _build)
