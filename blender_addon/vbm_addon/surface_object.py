# SPDX-License-Identifier: GPL-3.0-or-later
"""A closed surface from the library as an object, with what the source's vertices carry."""

from dataclasses import dataclass

import bpy
import numpy as np
from bpy.props import EnumProperty

from . import creation, transfer

FACES = EnumProperty(
    name="Faces", default="TRIANGLES", description="Faces of the surface",
    items=[("TRIANGLES", "Triangles", "Every face cut into triangles"),
           ("POLYGONS", "Polygons", "The faces as they are; not quite flat")])
SHADING = EnumProperty(
    name="Shading", default="SOURCE", description="How the faces are shaded",
    items=[("SOURCE", "As the Source", "As most of the source's faces; smooth for loose points"),
           ("SMOOTH", "Smooth", "All smooth"), ("FLAT", "Flat", "All flat")])


@dataclass
class Choices:
    """How a surface becomes a mesh; the names are those of the operators' properties."""

    faces: str = "TRIANGLES"
    shading: str = "SOURCE"
    copy_data: bool = False
    ignore_faces: bool = False

    @classmethod
    def of(cls, owner):
        return cls(**{name: getattr(owner, name) for name in cls.__dataclass_fields__
                      if hasattr(owner, name)})


def make(made, name, origin, data, surface, choices):
    """A new object where `origin` stands, not linked yet; `data` is the source that was read."""
    mesh = new_mesh(made, name, origin, surface, choices)
    obj = bpy.data.objects.new(name, mesh)
    made.append((bpy.data.objects, obj))
    creation.place_like(obj, origin)
    carry_over(obj, origin, data, surface, choices)
    return obj


def new_mesh(made, name, origin, surface, choices):
    mesh = bpy.data.meshes.new(name)
    made.append((bpy.data.meshes, mesh))
    if choices.faces == "POLYGONS":
        offsets, corners = surface.polygons.offsets, surface.polygons.corners
    else:
        triangles = np.asarray(surface.triangles)
        offsets, corners = np.arange(0, 3 * len(triangles) + 1, 3), triangles.ravel()
    creation.fill_mesh(mesh, surface.vertices, offsets, corners)
    mesh.polygons.foreach_set("use_smooth",
                              np.full(len(mesh.polygons), _smooth(origin, choices)))
    creation.add_attribute(mesh, "radius", "FLOAT", surface.vertex_radius)
    creation.add_attribute(mesh, "input_vertex", "INT", surface.vertex_input)
    return mesh


def carry_over(obj, origin, data, surface, choices):
    """Give a new surface the source's materials, attributes and vertex groups, if that was chosen."""
    if not choices.copy_data:
        return
    transfer.copy_materials(origin, obj.data)
    if data.own:
        triangles = np.asarray(surface.triangles)
        edges = np.concatenate([triangles[:, (0, 1)], triangles[:, (1, 2)], triangles[:, (2, 0)]])
        vertices = transfer.fill_unknown(surface.vertex_input, edges)
        transfer.copy_attributes(origin.data, obj.data, vertices)
        transfer.copy_vertex_groups(origin, obj, vertices)


def _smooth(origin, choices):
    if choices.shading != "SOURCE":
        return choices.shading == "SMOOTH"
    if origin.type != "MESH" or choices.ignore_faces or not origin.data.polygons:
        return True
    smooth = np.empty(len(origin.data.polygons), dtype=bool)
    origin.data.polygons.foreach_get("use_smooth", smooth)
    return bool(smooth.mean() > 0.5)
