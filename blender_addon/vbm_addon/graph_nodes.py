# SPDX-License-Identifier: GPL-3.0-or-later
"""How a topology graph is shown: Geometry Nodes that draw its edges as tubes and its nodes as balls.

As with the balls, the group needs nothing of the add-on. It reads the vertex attributes `radius`, of the
ball shown there (0 for none), and the colour, which it leaves as it is.
"""

from . import compat, node_building

NAME = "VBM Graph"
TUBE, MATERIAL = "Tube Radius", "Material"
_EDITION_KEY = "vbm_graph_edition"
_EDITION = 1


def _build(tree):
    for name, kind, more in (
            ("Geometry", "NodeSocketGeometry", {}),
            (TUBE, "NodeSocketFloat", dict(default=0.01, minimum=0.0, tip="Radius of the edges")),
            (MATERIAL, "NodeSocketMaterial", {})):
        compat.new_group_socket(tree, "INPUT", kind, name, **more)
    compat.new_group_socket(tree, "OUTPUT", "NodeSocketGeometry", "Geometry")
    compat.mark_as_modifier(tree)
    node, link = node_building.tools(tree)

    given = node("NodeGroupInput")
    curve = node("GeometryNodeMeshToCurve")
    link(given.outputs["Geometry"], curve.inputs["Mesh"])
    # A tube's thickness is not the radius of the balls at its ends.
    even = node("GeometryNodeSetCurveRadius")
    even.inputs["Radius"].default_value = 1.0
    link(curve.outputs["Curve"], even.inputs["Curve"])
    circle = node("GeometryNodeCurvePrimitiveCircle")
    circle.inputs["Resolution"].default_value = 12
    link(given.outputs[TUBE], node_building.socket(circle.inputs, "Radius"))
    tube = node("GeometryNodeCurveToMesh")
    link(even.outputs["Curve"], tube.inputs["Curve"])
    link(circle.outputs["Curve"], tube.inputs["Profile Curve"])

    radius = node("GeometryNodeInputNamedAttribute", data_type="FLOAT")
    radius.inputs["Name"].default_value = "radius"
    sphere = node("GeometryNodeMeshIcoSphere")
    sphere.inputs["Radius"].default_value = 1.0
    sphere.inputs["Subdivisions"].default_value = 3
    spread = node("GeometryNodeInstanceOnPoints")
    link(given.outputs["Geometry"], spread.inputs["Points"])
    link(sphere.outputs["Mesh"], spread.inputs["Instance"])
    link(node_building.socket(radius.outputs, "Attribute"), spread.inputs["Scale"])
    real = node("GeometryNodeRealizeInstances")
    link(spread.outputs["Instances"], real.inputs[0])

    join = node("GeometryNodeJoinGeometry")
    link(tube.outputs["Mesh"], join.inputs[0])
    link(real.outputs[0], join.inputs[0])
    smooth = node("GeometryNodeSetShadeSmooth")
    link(join.outputs[0], smooth.inputs[0])
    painted = node("GeometryNodeSetMaterial")
    link(smooth.outputs[0], painted.inputs[0])
    link(given.outputs[MATERIAL], painted.inputs["Material"])
    result = node("NodeGroupOutput")
    link(painted.outputs[0], result.inputs["Geometry"])


def node_group():
    """The node group of all graphs, made if the file has none. (group, is it new)"""
    return node_building.group(NAME, _EDITION_KEY, _EDITION, _build)
