# SPDX-License-Identifier: GPL-3.0-or-later
"""What several test files need: shapes, and judges that do not ask the add-on."""

import hashlib

import bmesh
import bpy
import numpy as np


def active():
    return bpy.context.view_layer.objects.active


def activate(obj):
    obj.hide_set(False)
    bpy.ops.object.select_all(action="DESELECT")
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    return obj


def icosphere(radius=1.0, subdivisions=4):
    bpy.ops.mesh.primitive_ico_sphere_add(radius=radius, subdivisions=subdivisions)
    return active()


def torus():
    bpy.ops.mesh.primitive_torus_add(major_radius=1.0, minor_radius=0.4, major_segments=48,
                                     minor_segments=24)
    return active()


def box(x, y, z, cuts=15):
    bpy.ops.mesh.primitive_cube_add(size=1.0)
    obj = active()
    shape = bmesh.new()
    shape.from_mesh(obj.data)
    bmesh.ops.subdivide_edges(shape, edges=shape.edges[:], cuts=cuts, use_grid_fill=True)
    bmesh.ops.scale(shape, vec=(x, y, z), verts=shape.verts[:])
    shape.to_mesh(obj.data)
    shape.free()
    return obj


def positions(mesh):
    flat = np.empty(3 * len(mesh.vertices), dtype=np.float32)
    mesh.vertices.foreach_get("co", flat)
    return flat.reshape(-1, 3)


def values(mesh, name):
    data = mesh.attributes[name].data
    flat = np.empty(len(data), dtype={"INT": np.int32, "BOOLEAN": bool}.get(
        mesh.attributes[name].data_type, np.float32))
    data.foreach_get("value", flat)
    return flat


def colors(mesh, name):
    flat = np.empty(4 * len(mesh.vertices), dtype=np.float32)
    mesh.attributes[name].data.foreach_get("color", flat)
    return flat.reshape(-1, 4)


def topology(mesh):
    """(components, genus) of a mesh, after checking with BMesh that it is closed and manifold."""
    shape = bmesh.new()
    shape.from_mesh(mesh)
    try:
        assert len(shape.faces) > 0
        for edge in shape.edges:
            assert edge.is_manifold, "an edge without two faces"
            assert edge.is_contiguous, "two faces that contradict each other"
        for vertex in shape.verts:
            assert vertex.is_manifold, "a vertex whose faces are not one fan"
        assert shape.calc_volume(signed=True) > 0.0, "inside out"
        euler = len(shape.verts) - len(shape.edges) + len(shape.faces)
        components, todo = 0, set(shape.verts)
        while todo:
            components += 1
            front = [todo.pop()]
            while front:
                for edge in front.pop().link_edges:
                    for vertex in edge.verts:
                        if vertex in todo:
                            todo.remove(vertex)
                            front.append(vertex)
        return components, components - euler // 2
    finally:
        shape.free()


def _fingerprint(mesh):
    digest = hashlib.sha256(positions(mesh).tobytes())
    corners = np.empty(len(mesh.loops), dtype=np.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    digest.update(corners.tobytes())
    for attribute in mesh.attributes:
        digest.update(f"{attribute.name} {attribute.data_type} {attribute.domain}".encode())
    digest.update(repr(sorted(mesh.keys())).encode())
    return digest.hexdigest()


def snapshot():
    """Everything of the file that an operator of this add-on could leave a trace in."""
    view_layer = bpy.context.view_layer
    state = {"mode": bpy.context.mode,
             "active": view_layer.objects.active and view_layer.objects.active.name,
             "selected": sorted(obj.name for obj in bpy.context.selected_objects)}
    for kind in ("objects", "meshes", "materials", "node_groups", "collections", "images", "curves"):
        state[kind] = sorted((datablock.name, datablock.users)
                             for datablock in getattr(bpy.data, kind))
    state["contents"] = {mesh.name: _fingerprint(mesh) for mesh in bpy.data.meshes}
    state["shown"] = {obj.name: (obj.hide_get(), obj.hide_render, obj.display_type,
                                 sorted(obj.keys()), tuple(map(tuple, obj.matrix_world)))
                      for obj in view_layer.objects}
    return state
