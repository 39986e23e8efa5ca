# SPDX-License-Identifier: GPL-3.0-or-later
"""Medial meshes: the axis of N balls and curve skeletons; topology by GUDHI."""

import numpy as np
import pytest
import vbm

gudhi = pytest.importorskip("gudhi")

import models
import test_axis
from test_axis import betti

COUNTS = [5000, 1000, 300, 100, 30, 10]


def hollow_sphere():
    points = np.concatenate([models.sphere(4000, 1.0), models.sphere(1500, 0.6)])
    normals = points.copy()
    normals[4000:] *= -1
    return vbm.build(points, normals=normals)


def trefoil_tube(rings=500, sides=24, radius=0.35):
    """Points on a tube along a trefoil knot."""
    t = np.linspace(0, 2 * np.pi, rings, endpoint=False)
    line = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], 1)
    tangent = np.roll(line, -1, axis=0) - np.roll(line, 1, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    a = np.cross(tangent, [0.1, 0.2, 1.0])
    a /= np.linalg.norm(a, axis=1, keepdims=True)
    b = np.cross(tangent, a)
    turn = 2 * np.pi * (np.arange(sides)[None, :] + 0.5 * (np.arange(rings)[:, None] % 2)) / sides
    ring = np.cos(turn)[..., None] * a[:, None] + np.sin(turn)[..., None] * b[:, None]
    return (line[:, None] + radius * ring).reshape(-1, 3)


def from_file(name):
    vertices, faces = models.read(models.shared(name))
    return vbm.build(vertices) if "bunny" in name else vbm.build(vertices, faces)


SHAPES = {
    "box": (lambda: vbm.build(test_axis.box_points(0.05, 1)), [1, 0, 0]),
    "torus": (lambda: vbm.build(test_axis.torus_points()), [1, 1, 0]),
    "trefoil": (lambda: vbm.build(trefoil_tube()), [1, 1, 0]),
    "hollow sphere": (hollow_sphere, [1, 0, 1]),
    "two blobs": (lambda: vbm.build(np.concatenate([models.blob(2000), models.blob(1500) + 5])),
                  [2, 0, 0]),
    "double torus": (lambda: from_file("double-torus.obj"), [1, 2, 0]),
    "three holes": (lambda: from_file("3holes.obj"), [1, 3, 0]),
    "femur": (lambda: from_file("femur.off"), [1, 2, 0]),
    "bunny": (lambda: from_file("stanford-bunny.obj"), [1, 0, 0]),
}


@pytest.fixture(scope="module", params=list(SHAPES))
def shape(request):
    build, numbers = SHAPES[request.param]
    return build(), numbers


@pytest.fixture(scope="module")
def axis(shape):
    return shape[0].medial_axis()


def assert_clean(mesh):
    """No dead or doubled vertex or face; GUDHI's count in betti() finds doubled faces."""
    report = mesh.report
    assert np.isfinite(mesh.vertices).all() and (mesh.radii > 0).all()
    used = np.unique(np.concatenate([mesh.triangles.ravel(), mesh.edges.ravel()]))
    assert len(used) == report.vertices or report.vertices == report.components
    assert (np.diff(np.sort(mesh.triangles, axis=1), axis=1) > 0).all()
    faces = {tuple(sorted(t)) for t in mesh.triangles.tolist()}
    assert len(faces) == report.triangles
    sides = {(t[i], t[j]) for t in faces for i, j in ((0, 1), (0, 2), (1, 2))}
    curves = {tuple(sorted(e)) for e in mesh.edges.tolist()}
    assert not sides & curves and len(curves) == report.curve_edges
    assert len(sides) + len(curves) == report.edges


def pockets(mesh):
    """Hollow tetrahedra: four triangles on four vertices."""
    faces = {tuple(sorted(t)) for t in mesh.triangles.tolist()}
    over = {}
    for a, b, c in faces:
        for edge, other in (((a, b), c), ((a, c), b), ((b, c), a)):
            over.setdefault(edge, set()).add(other)
    found = set()
    for a, b, c in faces:
        for d in over[a, b] & over[a, c] & over[b, c]:
            found.add(tuple(sorted((a, b, c, d))))
    return len(found)


def test_every_count_has_the_axis_s_topology(shape, axis):
    numbers = shape[1]
    assert betti(axis) == numbers
    whole = axis.report.vertices
    for count in COUNTS:
        mesh = axis.simplify(count)
        assert mesh.report.vertices == min(count, whole)
        assert betti(mesh) == numbers, count
        assert_clean(mesh)
        assert pockets(mesh) <= numbers[2], count


def test_curve_skeleton_has_the_axis_s_topology(shape, axis):
    numbers = shape[1]
    mesh = axis.curve_skeleton()
    assert betti(mesh) == numbers
    assert_clean(mesh)
    assert (len(mesh.triangles) > 0) == (numbers[2] > 0) == bool(mesh.notes)
