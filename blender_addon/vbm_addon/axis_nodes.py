# SPDX-License-Identifier: GPL-3.0-or-later
"""How an axis object is shown: Geometry Nodes that draw its curves, which have no faces, as tubes in the colour
of their part, and its contact curves as thinner white ones. Its sheets are the mesh itself.

As with the balls, the group needs nothing of the add-on. It reads the edge attributes `curve_part`,
`curve_color` and `contact_node` (see axis_object.py). Faces of the mesh keep their numbers; the others have the
number of their curve, or -1, as `part`.
"""

import bpy

from . import compat, node_building, part_colors

NAME = "VBM Axis"
CURVE, CONTACT, MATERIAL = "Curve Radius", "Contact Radius", "Material"
_EDITION_KEY = "vbm_axis_edition"
_EDITION = 1
#: Radii as parts of the shape's diagonal.
_CURVE, _CONTACT = 0.0025, 0.0008


def show(made, obj, diagonal):
    """Let an object of axis_object.py be drawn so."""
    group, is_new = node_group()
    if is_new:
        made.append((bpy.data.node_groups, group))
    modifier = obj.modifiers.new(NAME, "NODES")
    modifier.node_group = group
    compat.set_modifier_input(modifier, CURVE, _CURVE * diagonal)
    compat.set_modifier_input(modifier, CONTACT, _CONTACT * diagonal)
    compat.set_modifier_input(modifier, MATERIAL, obj.data.materials[0])


def _build(tree):
    for name, kind, more in (
            ("Geometry", "NodeSocketGeometry", {}),
            (CURVE, "NodeSocketFloat", dict(default=0.01, minimum=0.0,
                                            tip="Radius of the tubes that show curves")),
            (CONTACT, "NodeSocketFloat", dict(
                default=0.004, minimum=0.0,
                tip="Radius of the tubes that show where sheets meet; 0 for none")),
            (MATERIAL, "NodeSocketMaterial", {})):
        compat.new_group_socket(tree, "INPUT", kind, name, **more)
    compat.new_group_socket(tree, "OUTPUT", "NodeSocketGeometry", "Geometry")
    compat.mark_as_modifier(tree)
    node, link = node_building.tools(tree)
    given = node("NodeGroupInput")

    def attribute(name, kind):
        read = node("GeometryNodeInputNamedAttribute", data_type=kind)
        read.inputs["Name"].default_value = name
        return node_building.socket(read.outputs, "Attribute")

    def tubes(number, radius, sides, color, part):
        """Tubes round the edges whose attribute `number` is not negative; none where the radius is 0."""
        is_one = node("FunctionNodeCompare", data_type="INT", operation="GREATER_EQUAL")
        link(attribute(number, "INT"), node_building.socket(is_one.inputs, "A"))
        node_building.socket(is_one.inputs, "B").default_value = 0
        is_wanted = node("FunctionNodeCompare", data_type="FLOAT", operation="GREATER_THAN")
        link(given.outputs[radius], node_building.socket(is_wanted.inputs, "A"))
        node_building.socket(is_wanted.inputs, "B").default_value = 0.0
        both = node("FunctionNodeBooleanMath", operation="AND")
        link(is_one.outputs["Result"], both.inputs[0])
        link(is_wanted.outputs["Result"], both.inputs[1])
        chosen = node("GeometryNodeSeparateGeometry", domain="EDGE")
        link(given.outputs["Geometry"], chosen.inputs["Geometry"])
        link(both.outputs[0], chosen.inputs["Selection"])
        line = node("GeometryNodeMeshToCurve")
        link(chosen.outputs["Selection"], line.inputs["Mesh"])
        # A tube's thickness is not the radius of the balls along it.
        even = node("GeometryNodeSetCurveRadius")
        even.inputs["Radius"].default_value = 1.0
        link(line.outputs["Curve"], even.inputs["Curve"])
        circle = node("GeometryNodeCurvePrimitiveCircle")
        circle.inputs["Resolution"].default_value = sides
        link(given.outputs[radius], node_building.socket(circle.inputs, "Radius"))
        tube = node("GeometryNodeCurveToMesh")
        link(even.outputs["Curve"], tube.inputs["Curve"])
        link(circle.outputs["Curve"], tube.inputs["Profile Curve"])
        smooth = node("GeometryNodeSetShadeSmooth")
        link(tube.outputs["Mesh"], smooth.inputs[0])
        stored = smooth.outputs[0]
        for name, kind, domain, content in ((part_colors.COLOR, "FLOAT_COLOR", "POINT", color),
                                            ("part", "INT", "FACE", part)):
            store = node("GeometryNodeStoreNamedAttribute", data_type=kind, domain=domain)
            store.inputs["Name"].default_value = name
            value = node_building.socket(store.inputs, "Value")
            if isinstance(content, str):
                link(attribute(content, kind), value)
            else:
                value.default_value = content
            link(stored, store.inputs["Geometry"])
            stored = store.outputs["Geometry"]
        painted = node("GeometryNodeSetMaterial")
        link(stored, painted.inputs[0])
        link(given.outputs[MATERIAL], painted.inputs["Material"])
        return painted.outputs[0]

    shown = [tubes("curve_part", CURVE, 12, "curve_color", "curve_part"),
             tubes("contact_node", CONTACT, 6, (1.0, 1.0, 1.0, 1.0), -1)]
    join = node("GeometryNodeJoinGeometry")
    # What is linked last comes first: the mesh's own faces keep their numbers, by which they are picked.
    for geometry in (*shown, given.outputs["Geometry"]):
        link(geometry, join.inputs[0])
    result = node("NodeGroupOutput")
    link(join.outputs[0], result.inputs["Geometry"])


def node_group():
    """The node group of all axis objects, made if the file has none. (group, is it new)"""
    return node_building.group(NAME, _EDITION_KEY, _EDITION, _build)
