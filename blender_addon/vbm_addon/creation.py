# SPDX-License-Identifier: GPL-3.0-or-later
"""New objects: placed like the one they were computed from, and taken back if anything fails."""

from contextlib import contextmanager

import bpy
import numpy as np

from . import compat


@contextmanager
def undone_on_failure():
    """Yields a list for new datablocks; if the block raises, they are removed, the last one first."""
    made = []
    try:
        yield made
    except BaseException:
        for collection, datablock in reversed(made):
            collection.remove(datablock)
        raise


def fill_mesh(mesh, vertices, offsets=None, corners=None, edges=()):
    """Vertices and, if given, polygons: polygon i has corners[offsets[i]:offsets[i + 1]]. `edges` are
    those of no polygon, k x 2."""
    mesh.vertices.add(len(vertices))
    mesh.vertices.foreach_set("co", np.ascontiguousarray(vertices, dtype=np.float32).ravel())
    if len(edges):
        mesh.edges.add(len(edges))
        mesh.edges.foreach_set("vertices", np.ascontiguousarray(edges, dtype=np.int32).ravel())
    if offsets is not None and len(offsets) > 1:
        offsets = np.asarray(offsets, dtype=np.int32)
        compat.write_faces(mesh, offsets[:-1], np.diff(offsets),
                           np.ascontiguousarray(corners, dtype=np.int32))
    mesh.update(calc_edges=True, calc_edges_loose=len(edges) > 0)


def add_attribute(mesh, name, kind, values, domain="POINT"):
    """A new attribute. `kind` is Blender's: FLOAT, INT, BOOLEAN, FLOAT_COLOR."""
    fill_attribute(mesh.attributes.new(name, kind, domain), values)


def fill_attribute(attribute, values):
    kind = attribute.data_type
    dtype = {"INT": np.int32, "BOOLEAN": bool}.get(kind, np.float32)
    attribute.data.foreach_set("color" if kind == "FLOAT_COLOR" else "value",
                               np.ascontiguousarray(values, dtype=dtype).ravel())


def swap_data(obj, data):
    """Give an object another mesh or curve; the old one goes if nothing else shows it."""
    old = obj.data
    name = old.name
    for slot in old.materials:
        if slot is not None and slot.name not in data.materials:
            data.materials.append(slot)
    obj.data = data
    if old.users == 0:
        (bpy.data.meshes if obj.type == "MESH" else bpy.data.curves).remove(old)
        data.name = name


_TRANSFORM = ("rotation_mode", "location", "rotation_euler", "rotation_quaternion",
              "rotation_axis_angle", "scale", "delta_location", "delta_rotation_euler",
              "delta_rotation_quaternion", "delta_scale")


def place_like(obj, origin):
    """Put `obj` where `origin` is. What was computed is in origin's own coordinates.

    Parent and channels are copied where that is enough: a matrix taken apart into location, rotation
    and scale would lose the parent's shear, and exact numbers.
    """
    if origin.constraints:
        obj.matrix_world = origin.matrix_world
        return
    obj.parent = origin.parent
    obj.parent_type = origin.parent_type
    obj.parent_bone = origin.parent_bone
    obj.matrix_parent_inverse = origin.matrix_parent_inverse
    for name in _TRANSFORM:
        setattr(obj, name, getattr(origin, name))


def show_result(context, obj, origin, source_display):
    """Link `obj` beside `origin`, select it alone, and treat what it was computed from as asked."""
    show_results(context, [obj], origin, source_display)


def show_results(context, objects, origin, source_display):
    """As show_result() for several, the last of which is selected."""
    before = context.view_layer.objects.active
    collection = _collection_of(origin, context.view_layer.layer_collection)
    for obj in objects:
        collection.objects.link(obj)
    select_alone(context, objects[-1])
    # The balls that stood for the origin give way with it.
    for other in {origin, before}:
        if source_display == "HIDE":
            hide(other, True)
        elif source_display == "WIRE":
            other.display_type = "WIRE"


def takes_objects(collection):
    """Not if it is a library's, or stands for one."""
    return collection.library is None and collection.override_library is None


def _collection_of(obj, layer):
    """A collection that has `obj`, is switched on in the view layer and takes objects; the scene's own if there is
    none."""
    return _found(obj, layer) or layer.collection


def _found(obj, layer):
    if not layer.exclude and takes_objects(layer.collection) and layer.collection.objects.get(obj.name) == obj:
        return layer.collection
    for child in layer.children:
        found = _found(obj, child)
        if found is not None:
            return found
    return None


def select_alone(context, obj):
    """Make `obj` the active and only selected object."""
    for other in context.selected_objects:
        other.select_set(False)
    obj.select_set(True)
    context.view_layer.objects.active = obj


def hide(obj, hidden):
    """In viewports and, what hide_set() alone does not do, in renders."""
    obj.hide_set(hidden)
    obj.hide_render = hidden


def describe(obj, report, notes):
    """What the library says about the result, as custom properties that stay with it."""
    obj["vbm_report"] = {key: _plain(value) for key, value in report._asdict().items()}
    obj["vbm_notes"] = list(notes)


def _plain(value):
    """What properties can hold: 32-bit whole numbers, floats, text."""
    if isinstance(value, (bool, str, float)):
        return value
    value = int(value)
    return value if abs(value) < 2**31 else float(value)
