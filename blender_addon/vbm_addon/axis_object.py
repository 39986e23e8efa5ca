# SPDX-License-Identifier: GPL-3.0-or-later
"""The medial axis as a mesh: triangles of sheets and edges of curves, coloured by part.

Attributes: `radius` on vertices; `part`, `level` and `lock` on faces (lock: 0 where the part can go, see
LOCKS); on edges `curve_part`, `curve_level` and `curve_lock`, -1 on those of triangles, and `contact_node`,
the node of the topology graph where parts meet, -1 elsewhere; and the colour of the parts, on corners of
faces and, as `curve_color`, on edges. A modifier draws curves and contact curves (axis_nodes.py).
"""

import bmesh
import bpy
import numpy as np

from . import axis_nodes, compat, creation, library, part_colors

#: The library's reasons why a part cannot go, by the attribute's values.
LOCKS = ("", "inner", "tunnel", "bridge", "last")
PART, CURVE_PART, CONTACT_NODE = "part", "curve_part", "contact_node"


def lock_text(lock):
    """Why a part stays, in the library's words."""
    if not lock:
        return "It can be removed"
    if library.vbm is None or lock not in LOCKS:  # of a file that a newer version wrote
        return lock
    text = library.vbm.lock_text(lock)
    return text[:1].upper() + text[1:]


def make(made, axis, origin, diagonal, recipe_text):
    """A new axis object, not linked yet."""
    colors = part_colors.of_parts(axis)
    mesh = new_mesh(made, f"{origin.name} Axis", axis, colors)
    obj = bpy.data.objects.new(mesh.name, mesh)
    made.append((bpy.data.objects, obj))
    creation.place_like(obj, origin)
    obj.vbm_axis.source = origin
    # The axis lies within its shape: it is seen through it.
    obj.show_in_front = True
    axis_nodes.show(made, obj, diagonal)
    tell(obj, axis, colors, recipe_text)
    return obj


def new_mesh(made, name, axis, colors):
    mesh = bpy.data.meshes.new(name)
    made.append((bpy.data.meshes, mesh))
    _fill(mesh, axis, colors)
    material, is_new = part_colors.material()
    if is_new:
        made.append((bpy.data.materials, material))
    mesh.materials.append(material)
    return mesh


def _fill(mesh, axis, colors):
    triangles = np.asarray(axis.triangles)
    curves = np.asarray(axis.edges)
    creation.fill_mesh(mesh, axis.vertices, np.arange(0, 3 * len(triangles) + 1, 3),
                       triangles.ravel(), curves)
    creation.add_attribute(mesh, "radius", "FLOAT", axis.radii)
    part = np.asarray(axis.triangle_part)
    parts = axis.parts
    level = np.array([p.level for p in parts], dtype=np.int32)
    lock = np.array([LOCKS.index(p.locked) for p in parts], dtype=np.int32)
    creation.add_attribute(mesh, PART, "INT", part, "FACE")
    creation.add_attribute(mesh, "level", "INT", level[part], "FACE")
    creation.add_attribute(mesh, "lock", "INT", lock[part], "FACE")
    of_edge = _per_edge(mesh, curves, np.asarray(axis.edge_part))
    is_curve = of_edge >= 0
    creation.add_attribute(mesh, CURVE_PART, "INT", of_edge, "EDGE")
    for name, value in (("curve_level", level), ("curve_lock", lock)):
        found = np.full(len(of_edge), -1, dtype=np.int32)
        found[is_curve] = value[of_edge[is_curve]]
        creation.add_attribute(mesh, name, "INT", found, "EDGE")
    creation.add_attribute(mesh, CONTACT_NODE, "INT", _per_edge(
        mesh, np.asarray(axis.contact_edges), np.asarray(axis.contact_node)), "EDGE")
    rgba = np.ones((len(of_edge), 4), dtype=np.float32)
    rgba[is_curve, :3] = colors[of_edge[is_curve]]
    creation.add_attribute(mesh, "curve_color", "FLOAT_COLOR", rgba, "EDGE")
    rgba = np.ones((len(triangles), 3, 4), dtype=np.float32)
    rgba[:, :, :3] = colors[part][:, None]
    creation.add_attribute(mesh, part_colors.COLOR, "FLOAT_COLOR", rgba, "CORNER")
    compat.set_active_color(mesh, part_colors.COLOR)


def _per_edge(mesh, pairs, numbers):
    """The number of every edge that is one of the pairs, -1 for others: Blender has its own order of edges."""
    ends = np.empty(2 * len(mesh.edges), dtype=np.int32)
    mesh.edges.foreach_get("vertices", ends)
    count = max(len(mesh.vertices), 1)
    keys = _keys(ends.reshape(-1, 2), count)
    found = np.full(len(keys), -1, dtype=np.int32)
    if len(pairs):
        wanted = _keys(pairs, count)
        order = np.argsort(wanted)
        at = np.searchsorted(wanted[order], keys).clip(max=len(wanted) - 1)
        same = wanted[order][at] == keys
        found[same] = numbers[order][at[same]]
    return found


def _keys(pairs, count):
    pairs = np.sort(np.asarray(pairs, dtype=np.int64), axis=1)
    return pairs[:, 0] * count + pairs[:, 1]


def tell(obj, axis, colors, recipe_text):
    """What the sidebar shows, and what the axis is made again from."""
    own = obj.vbm_axis
    own.recipe = recipe_text
    own.active_part = -1
    own.parts.clear()
    for number, (part, color) in enumerate(zip(axis.parts, colors)):
        item = own.parts.add()
        item.name = f"{'Curve' if part.curve_edges else 'Part'} {number}"
        item.level = part.level
        item.lock = part.locked
        item.triangles = part.triangles
        item.edges = part.curve_edges
        item.volume = 100.0 * part.volume
        item.place = part.position
        item.color = color
    creation.describe(obj, axis.report, axis.notes)


def curve_edges(obj):
    """(ends, k x 2 x 3 in the object's coordinates, part of each) of the edges that are curves."""
    mesh = obj.data
    attribute = mesh.attributes.get(CURVE_PART)
    if attribute is None or len(attribute.data) != len(mesh.edges):
        return np.zeros((0, 2, 3)), np.zeros(0, dtype=np.int32)
    numbers = np.empty(len(mesh.edges), dtype=np.int32)
    attribute.data.foreach_get("value", numbers)
    ends = np.empty(2 * len(mesh.edges), dtype=np.int32)
    mesh.edges.foreach_get("vertices", ends)
    chosen = numbers >= 0
    return compat.read_positions(mesh)[ends.reshape(-1, 2)[chosen]], numbers[chosen]


def tie(shown):
    """Let the axis object know the others of {"surface", "graph", "skeleton"}, which follow it."""
    axis = shown["axis"]
    for kind, obj in shown.items():
        if kind != "axis":
            setattr(axis.vbm_axis, kind, obj)
            obj.vbm_axis.owner = axis


def selected_parts(obj):
    """Parts with a selected face, or a selected edge of a curve, in ascending order. In Edit Mode."""
    shape = bmesh.from_edit_mesh(obj.data)
    chosen = set()
    for elements, name in ((shape.faces, PART), (shape.edges, CURVE_PART)):
        numbers = elements.layers.int.get(name)
        if numbers is not None:
            chosen.update(element[numbers] for element in elements if element.select)
    return sorted(chosen - {-1})
