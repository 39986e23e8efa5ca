# SPDX-License-Identifier: GPL-3.0-or-later
"""The topology graph as a mesh of edges (thesis 7.5.3, Figures 7.9 and 7.11), shown as balls and tubes.

A node is a ball where parts meet; a part is a point at its middle, in the part's colour, joined to the
nodes it touches. Attributes of vertices: `part`, -1 on nodes; `radius` of the ball shown.
"""

import bpy
import numpy as np

from . import compat, creation, graph_nodes, part_colors

#: Sizes as parts of the shape's diagonal.
_NODE, _PART, _TUBE = 0.012, 0.006, 0.0025
_NODE_COLOR = (1.0, 1.0, 1.0)


def make(made, axis, origin, diagonal):
    """A new object that shows the graph where `origin` stands, not linked yet."""
    mesh = new_mesh(made, f"{origin.name} Graph", axis, diagonal)
    group, is_new = graph_nodes.node_group()
    if is_new:
        made.append((bpy.data.node_groups, group))
    obj = bpy.data.objects.new(mesh.name, mesh)
    made.append((bpy.data.objects, obj))
    creation.place_like(obj, origin)
    obj.show_in_front = True
    obj.vbm_axis.follows = True
    modifier = obj.modifiers.new(graph_nodes.NAME, "NODES")
    modifier.node_group = group
    compat.set_modifier_input(modifier, graph_nodes.TUBE, _TUBE * diagonal)
    compat.set_modifier_input(modifier, graph_nodes.MATERIAL, mesh.materials[0])
    return obj


def new_mesh(made, name, axis, diagonal):
    graph = axis.topology_graph()
    nodes, parts = np.asarray(graph["nodes"]), np.asarray(graph["parts"])
    edges = np.asarray(graph["edges"]) + (len(nodes), 0)
    mesh = bpy.data.meshes.new(name)
    made.append((bpy.data.meshes, mesh))
    creation.fill_mesh(mesh, np.concatenate([nodes.reshape(-1, 3), parts.reshape(-1, 3)]),
                       edges=edges)
    creation.add_attribute(mesh, "part", "INT",
                           np.r_[np.full(len(nodes), -1), np.arange(len(parts))])
    creation.add_attribute(mesh, "radius", "FLOAT", diagonal * np.r_[
        np.full(len(nodes), _NODE), np.full(len(parts), _PART)])
    rgba = np.ones((len(nodes) + len(parts), 4))
    rgba[:len(nodes), :3] = _NODE_COLOR
    rgba[len(nodes):, :3] = part_colors.of_parts(axis)
    creation.add_attribute(mesh, part_colors.COLOR, "FLOAT_COLOR", rgba)
    compat.set_active_color(mesh, part_colors.COLOR)
    material, is_new = part_colors.material()
    if is_new:
        made.append((bpy.data.materials, material))
    mesh.materials.append(material)
    return mesh
