# SPDX-License-Identifier: GPL-3.0-or-later
"""Carries what the user attached to vertices over to a surface rebuilt from them.

Most vertices of the surface are vertices of the input and say which. The others (samples added on
edges and faces, corners of a power crust) take everything from the nearest known one along the
surface's edges. Corner data (UV maps) has no counterpart there and is left behind.
"""

import numpy as np

#: Attribute types carried over: (field, numbers per element, NumPy type).
_FIELDS = {
    "FLOAT": ("value", 1, np.float32), "INT": ("value", 1, np.int32),
    "INT8": ("value", 1, np.int32), "BOOLEAN": ("value", 1, bool),
    "FLOAT2": ("vector", 2, np.float32), "FLOAT_VECTOR": ("vector", 3, np.float32),
    "FLOAT_COLOR": ("color", 4, np.float32), "BYTE_COLOR": ("color", 4, np.float32),
}
#: Blender's own, which the new mesh has or should not get.
_NOT_THESE = {"position", "radius", "input_vertex"}


def fill_unknown(origin, edges):
    """Give every vertex with origin -1 that of a neighbour, from the known ones outwards."""
    origin = np.array(origin, dtype=np.int64)
    if not (origin >= 0).any():
        return origin
    edges = np.asarray(edges).reshape(-1, 2)
    both = np.concatenate([edges, edges[:, ::-1]])
    while True:
        open_edges = both[(origin[both[:, 0]] >= 0) & (origin[both[:, 1]] < 0)]
        if len(open_edges) == 0:
            return origin
        # Of several neighbours the one with the lowest origin, so that the result is always the same.
        order = np.lexsort((origin[open_edges[:, 0]], open_edges[:, 1]))
        targets, first = np.unique(open_edges[order, 1], return_index=True)
        origin[targets] = origin[open_edges[order, 0][first]]


def copy_attributes(source, target, origin):
    """Attributes of the source mesh's vertices; `origin[i] < 0` leaves the default."""
    known = np.flatnonzero(origin >= 0)
    for attribute in source.attributes:
        name = attribute.name
        if (attribute.domain != "POINT" or attribute.data_type not in _FIELDS
                or name in _NOT_THESE or name.startswith(".") or name in target.attributes):
            continue
        field, width, dtype = _FIELDS[attribute.data_type]
        values = np.empty(len(source.vertices) * width, dtype=dtype)
        attribute.data.foreach_get(field, values)
        result = np.zeros((len(target.vertices), width), dtype=dtype)
        result[known] = values.reshape(-1, width)[origin[known]]
        copy = target.attributes.new(name, attribute.data_type, "POINT")
        copy.data.foreach_set(field, result.ravel())


def copy_vertex_groups(source_object, target_object, origin):
    """Vertex groups, with their weights."""
    if not source_object.vertex_groups:
        return
    groups = [target_object.vertex_groups.new(name=group.name)
              for group in source_object.vertex_groups]
    followers = {}
    for vertex, index in enumerate(origin.tolist()):
        if index >= 0:
            followers.setdefault(index, []).append(vertex)
    for index, vertices in followers.items():
        for element in source_object.data.vertices[index].groups:
            groups[element.group].add(vertices, element.weight, "REPLACE")


def copy_materials(source_object, target_mesh):
    for slot in source_object.material_slots:
        target_mesh.materials.append(slot.material)
