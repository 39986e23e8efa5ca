# SPDX-License-Identifier: GPL-3.0-or-later
"""Balls from what is selected: ball objects, metaballs, empties drawn as spheres, and meshes that are spheres."""

import hashlib
from dataclasses import dataclass, field

import bpy
import numpy as np

from . import compat
from .source import SourceError

#: How much the vertices of a sphere may differ in their distance from its centre, as a part of the radius: less
#: than an ellipsoid that looks like one, more than a subdivided sphere's.
_ROUND = 0.03
#: How near its faces' planes may come to the centre: an icosahedron is a sphere, a cube or a cylinder is none.
_BULGING = 0.75
#: How much of the directions from the centre its faces must fill.
_CLOSED = 0.98
#: And how much an object's scale may differ from axis to axis.
_EVEN = 1e-3


@dataclass
class Balls:
    """Centres and radii: in the coordinates of `origin`, or in the world's where that is None."""

    name: str
    centers: np.ndarray
    radii: np.ndarray
    origin: object
    notes: list = field(default_factory=list)
    #: The objects' names, and the place in that list of each ball's.
    objects: list = field(default_factory=list)
    owner: np.ndarray = None
    own: bool = False  # what job_operator asks of a source: errors are not about mesh elements

    @property
    def digest(self):
        digest = hashlib.blake2b(np.ascontiguousarray(self.centers), digest_size=16)
        digest.update(np.ascontiguousarray(self.radii))
        return digest.digest()


def is_ball_object(obj):
    """A mesh whose vertices have a radius, and that is not the surface of something."""
    if obj is None or obj.type != "MESH" or obj.data.attributes.get("radius") is None:
        return False
    return obj.data.attributes["radius"].domain == "POINT" and "input_vertex" not in obj.data.attributes


def usable(obj):
    return obj.type == "META" or is_ball_object(obj) or obj.type == "MESH" or (
        obj.type == "EMPTY" and obj.empty_display_type == "SPHERE")


def selected(context):
    """The objects that read() would take: the selected ones, the active one first."""
    found = [obj for obj in context.selected_objects if usable(obj)]
    active = context.active_object
    if active in found:
        found.remove(active)
        found.insert(0, active)
    return found


def read(context, world=False):
    """The balls of the selected objects; one object's in its own coordinates, unless the world's are asked
    for. Raises SourceError."""
    objects = selected(context)
    if not objects:
        raise SourceError("Select balls: a ball object, metaballs, spheres, or empties drawn as spheres")
    notes = []
    if not world and len(objects) == 1 and (objects[0].type == "META" or is_ball_object(objects[0])):
        parts, origin = [_finite(objects[0], *_local(objects[0], notes))], objects[0]
    else:
        parts, origin = [_finite(obj, *_world(obj, notes)) for obj in objects], None
    balls = Balls(objects[0].name, np.concatenate([part[0] for part in parts]),
                  np.concatenate([part[1] for part in parts]), origin, notes, [obj.name for obj in objects],
                  np.repeat(np.arange(len(parts)), [len(part[1]) for part in parts]))
    if len(balls.radii) == 0:
        raise SourceError(". ".join([f"{balls.name} has no balls", *notes]))
    return balls


def _finite(obj, centers, radii):
    """Of several objects' balls, which object's one is no ball."""
    bad = np.flatnonzero(~np.isfinite(np.c_[centers, radii]).all(axis=1))
    if len(bad):
        which = f"ball {bad[0]} of {obj.name}" if len(radii) > 1 else obj.name
        raise SourceError(f"The place or size of {which} is not finite")
    return centers, radii


def _local(obj, notes):
    return _metaballs(obj, notes) if obj.type == "META" else of_ball_object(obj)


def of_ball_object(obj):
    """(centres, radii) of a ball object's inner balls, in its own coordinates."""
    mesh = obj.data
    if obj.mode == "EDIT":
        obj.update_from_editmode()
    centers = compat.read_positions(mesh).astype(np.float64)
    radii = np.empty(len(centers), dtype=np.float32)
    mesh.attributes["radius"].data.foreach_get("value", radii)
    radii = radii.astype(np.float64)
    inside = mesh.attributes.get("inside")
    if inside is not None and inside.data_type == "BOOLEAN" and inside.domain == "POINT":
        kept = np.empty(len(centers), dtype=bool)
        inside.data.foreach_get("value", kept)
        centers, radii = centers[kept], radii[kept]
    return centers, radii


def _metaballs(obj, notes):
    """The elements that add: their spheres of influence's size is the radius that the user sees set."""
    found = [element for element in obj.data.elements
             if element.type == "BALL" and not element.use_negative]
    left = len(obj.data.elements) - len(found)
    if left:
        notes.append(f"1 element of {obj.name} that is no ball, or takes away, was left out" if left == 1 else
                     f"{left} elements of {obj.name} that are no balls, or take away, were left out")
    return (np.array([tuple(element.co) for element in found], dtype=np.float64).reshape(-1, 3),
            np.array([element.radius for element in found], dtype=np.float64))


def _world(obj, notes):
    matrix = np.array(obj.matrix_world)
    if obj.type == "META" or is_ball_object(obj):
        centers, radii = _local(obj, notes)
        return centers @ matrix[:3, :3].T + matrix[:3, 3], radii * _even_scale(obj)
    if obj.type == "EMPTY":
        return matrix[None, :3, 3], np.array([obj.empty_display_size * _even_scale(obj)])
    return _sphere(obj, matrix)


def _even_scale(obj):
    scale = np.abs(obj.matrix_world.to_scale())
    if np.ptp(scale) > _EVEN * scale.max():
        raise SourceError(f"{obj.name} is scaled differently along its axes, so its balls are none: "
                          "apply its scale")
    return float(scale.mean())


def _sphere(obj, matrix):
    """A mesh object that is a sphere, with its modifiers."""
    evaluated = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    try:
        points = compat.read_positions(mesh).astype(np.float64) @ matrix[:3, :3].T + matrix[:3, 3]
        mesh.calc_loop_triangles()
        triangles = np.empty(3 * len(mesh.loop_triangles), dtype=np.int32)
        mesh.loop_triangles.foreach_get("vertices", triangles)
    finally:
        evaluated.to_mesh_clear()
    if len(points) >= 4:
        center = 0.5 * (points.min(axis=0) + points.max(axis=0))
        for _ in range(2):  # the least-squares sphere: linear, and again from nearby for exactness
            shifted = points - center
            system = np.c_[2 * shifted, np.ones(len(points))]
            answer = np.linalg.lstsq(system, (shifted ** 2).sum(axis=1), rcond=None)[0]
            center = center + answer[:3]
        distance = np.linalg.norm(points - center, axis=1)
        radius = distance.mean()
        if radius > 0 and np.ptp(distance) <= _ROUND * radius and _is_round(
                (points[triangles.reshape(-1, 3)] - center) / radius):
            return center[None], np.array([distance.max()])
    scale = np.abs(obj.matrix_world.to_scale())
    why = ", being scaled differently along its axes," if np.ptp(scale) > _EVEN * scale.max() else ""
    raise SourceError(f"{obj.name}{why} is no sphere, and has no attribute radius that would make balls of "
                      "its vertices")


def _is_round(corners):
    """Whether triangles with their corners on a sphere of radius 1 round the origin are a sphere: they surround the
    origin (solid angles: van Oosterom and Strackee 1983), none nearer than _BULGING."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    normal = np.cross(b - a, c - a)
    size = np.linalg.norm(normal, axis=1)
    height = np.abs(np.einsum("ij,ij->i", a, normal))
    volume = np.abs(np.einsum("ij,ij->i", a, np.cross(b, c)))
    angle = 2 * np.arctan2(volume, 1 + np.einsum("ij,ij->i", a, b) + np.einsum("ij,ij->i", b, c)
                           + np.einsum("ij,ij->i", c, a))
    real = size > 1e-9
    return (height >= _BULGING * size)[real].all() and abs(angle.sum() / (4 * np.pi) - 1) <= 1 - _CLOSED
