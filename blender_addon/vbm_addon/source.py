# SPDX-License-Identifier: GPL-3.0-or-later
"""From a Blender object to the arrays the library takes, in the object's own (local) coordinates."""

import hashlib
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Optional

import numpy as np

from . import compat

#: Objects that have a mesh or can be turned into one.
TYPES = {"MESH", "CURVE", "SURFACE", "META", "FONT"}
#: Custom property of a ball object: the name of the object its balls were built from.
SOURCE_KEY = "vbm_source"


class SourceError(Exception):
    """The object cannot be used; one sentence for its user."""


@dataclass
class Source:
    name: str
    points: np.ndarray  # n x 3
    sizes: Optional[np.ndarray]  # corners per face; None for points alone
    corners: Optional[np.ndarray]
    normals: Optional[np.ndarray]
    own: bool  # whether indices are those of the user's own mesh
    digest: bytes


def axis_state(obj):
    """`obj.vbm_axis` where it was ever written, else None: reading it would put it on any object."""
    return obj.vbm_axis if obj is not None and obj.is_property_set("vbm_axis") else None


def resolve(context):
    """(object to build from, why there is none). Balls, and a medial axis with its graph and its
    skeleton, stand for what they were computed from."""
    active = context.active_object
    if active is None:
        return None, "There is no active object: select a mesh"
    own = axis_state(active)
    if own is not None and (own.recipe or own.follows):
        state = own if own.recipe else axis_state(own.owner)
        origin = state.source if state is not None else None
        if origin is None or context.view_layer.objects.get(origin.name) != origin:
            return None, f"What {active.name} was computed from is gone: select another mesh"
        active = origin
    elif SOURCE_KEY in active:
        name = active[SOURCE_KEY]
        origin = context.view_layer.objects.get(name)
        if origin is None:
            return None, f"{name}, from which these balls were built, is gone: select another mesh"
        active = origin
    if active.type not in TYPES:
        return None, f"{active.name} has no mesh and cannot be turned into one"
    return active, ""


@contextmanager
def _evaluable(context, obj):
    """Hidden objects are not evaluated: show this one for a moment."""
    hidden = obj.hide_get()
    monitor = obj.hide_viewport
    if hidden or monitor:
        obj.hide_set(False)
        obj.hide_viewport = False
    try:
        yield
    finally:
        if hidden or monitor:
            obj.hide_viewport = monitor
            obj.hide_set(hidden)


def _arrays(mesh, ignore_faces):
    points = compat.read_positions(mesh).astype(np.float64)
    if ignore_faces or len(mesh.polygons) == 0:
        return points, None, None
    sizes = np.empty(len(mesh.polygons), dtype=np.int32)
    corners = np.empty(len(mesh.loops), dtype=np.int32)
    mesh.polygons.foreach_get("loop_total", sizes)
    mesh.loops.foreach_get("vertex_index", corners)
    return points, sizes, corners


def _normals(mesh, attribute_name, object_name):
    attribute = mesh.attributes.get(attribute_name)
    if attribute is None:
        raise SourceError(f'{object_name} has no attribute "{attribute_name}" to take normals from')
    if attribute.data_type != "FLOAT_VECTOR" or attribute.domain != "POINT":
        raise SourceError(f'The attribute "{attribute_name}" of {object_name} is not a vector on '
                          "its vertices, so it cannot give normals")
    flat = np.empty(3 * len(mesh.vertices), dtype=np.float32)
    attribute.data.foreach_get("vector", flat)
    return flat.reshape(-1, 3).astype(np.float64)


def _digest(*arrays):
    digest = hashlib.blake2b(digest_size=16)
    for array in arrays:
        digest.update(b"-" if array is None else str(array.shape).encode())
        if array is not None:
            digest.update(np.ascontiguousarray(array))
    return digest.digest()


def _from_mesh(mesh, obj, own, ignore_faces, normals_attribute):
    points, sizes, corners = _arrays(mesh, ignore_faces)
    normals = None
    if sizes is None and normals_attribute:
        normals = _normals(mesh, normals_attribute, obj.name)
    return Source(obj.name, points, sizes, corners, normals, own,
                  _digest(points, sizes, corners, normals))


def _same_elements(mesh, own_mesh):
    """Whether modifiers only moved the vertices, so that indices mean the same on both meshes."""
    return (len(mesh.vertices) == len(own_mesh.vertices)
            and len(mesh.polygons) == len(own_mesh.polygons)
            and len(mesh.loops) == len(own_mesh.loops))


def read(context, obj, use_modifiers=True, ignore_faces=False, normals_attribute=""):
    """Read an object of one of TYPES. Raises SourceError."""
    if obj.type == "MESH":
        obj.update_from_editmode()
        if not use_modifiers or not obj.modifiers:
            return _from_mesh(obj.data, obj, True, ignore_faces, normals_attribute)
    with _evaluable(context, obj):
        if not obj.visible_get():
            raise SourceError(f"{obj.name} is in a collection that is switched off, so its "
                              "modifiers are not evaluated: show it first")
        evaluated = obj.evaluated_get(context.evaluated_depsgraph_get())
        try:
            mesh = evaluated.to_mesh()
        except RuntimeError as error:
            raise SourceError(f"{obj.name} gives no mesh: {error}") from error
        if mesh is None:
            raise SourceError(f"{obj.name} gives no mesh")
        try:
            own = obj.type == "MESH" and _same_elements(mesh, obj.data)
            return _from_mesh(mesh, obj, own, ignore_faces, normals_attribute)
        finally:
            evaluated.to_mesh_clear()
