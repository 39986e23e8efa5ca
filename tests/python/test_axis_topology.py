# SPDX-License-Identifier: GPL-3.0-or-later
"""The medial axis has the solid's Betti numbers before and after everything that is done to it; nothing in
it is there twice, torn or hollow. All is counted by GUDHI, from the arrays alone."""

import collections

import models
import numpy as np
import pytest
import vbm

gudhi = pytest.importorskip("gudhi")


def complex_of(simplices, vertices):
    tree = gudhi.SimplexTree()
    for rows in (np.arange(vertices)[:, None], *simplices):
        if len(rows):
            tree.insert_batch(np.array(rows.T, np.int32, order="C"), np.zeros(len(rows)))
    return tree


def betti_of(tree):
    tree.compute_persistence(homology_coeff_field=2, persistence_dim_max=True)
    return tuple((tree.betti_numbers() + [0, 0, 0])[:3])


def axis_betti(axis):
    tree = complex_of([axis.edges, axis.triangles], len(axis.vertices))
    assert tree.num_vertices() == len(axis.vertices)
    # Nothing is there twice: as many simplices as the report says.
    report = axis.report
    assert tree.num_simplices() == report.vertices + report.edges + report.triangles
    assert report.components == betti_of(tree)[0]
    return betti_of(tree)


def surfaces_of(triangles):
    """The triangles of each connected piece, by flooding over shared edges."""
    at_vertex = collections.defaultdict(list)
    for t, corners in enumerate(triangles.tolist()):
        for v in corners:
            at_vertex[v].append(t)
    seen = np.zeros(len(triangles), bool)
    for first in range(len(triangles)):
        if seen[first]:
            continue
        seen[first] = True
        piece = [first]
        for t in piece:
            for v in triangles[t].tolist():
                for other in at_vertex[v]:
                    if not seen[other]:
                        seen[other] = True
                        piece.append(other)
        yield triangles[piece]


def solid_betti(vertices, triangles):
    """Betti numbers of the solid inside a closed oriented surface, by Alexander's duality: half the
    surface's cycles bound inside, each piece that faces inwards is a cavity's wall."""
    pieces = list(surfaces_of(triangles))
    walls = sum(models.signed_volume(vertices, piece) < 0 for piece in pieces)
    used, flat = np.unique(triangles, return_inverse=True)
    b0, b1, b2 = betti_of(complex_of([flat.reshape(-1, 3)], len(used)))
    assert b0 == b2 == len(pieces) and b1 % 2 == 0
    return (b0 - walls, b1 // 2, walls)


def tube(curve, around=24, radius=0.3):
    """A closed tube's mesh about a closed curve."""
    tangent = np.roll(curve, -1, axis=0) - np.roll(curve, 1, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    normal = np.cross(tangent, (0.0, 0.0, 1.0))
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    other = np.cross(tangent, normal)
    turn = 2 * np.pi * np.arange(around) / around
    ring = np.cos(turn)[None, :, None] * normal[:, None] + np.sin(turn)[None, :, None] * other[:, None]
    points = curve[:, None] + radius * ring
    n = len(curve)
    i, j = np.meshgrid(np.arange(n), np.arange(around), indexing="ij")
    at = lambda i, j: (i % n) * around + j % around
    quads = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
    a, b, c, d = (q.ravel() for q in quads)
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    if models.signed_volume(points.reshape(-1, 3), triangles) < 0:
        triangles = triangles[:, ::-1]
    return points.reshape(-1, 3), np.ascontiguousarray(triangles, np.int32)


def trefoil():
    t = 2 * np.pi * np.arange(180) / 180
    return tube(np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], 1))


def torus():
    t = 2 * np.pi * np.arange(90) / 90
    return tube(np.stack([np.cos(t), np.sin(t), 0 * t], 1), radius=0.35)


def hollow_sphere():
    from scipy.spatial import ConvexHull

    outer, inner = models.sphere(1500), models.sphere(600, 0.55)
    shells = []
    for points, side in ((outer, 1), (inner, -1)):
        triangles = ConvexHull(points).simplices
        a, b, c = (points[triangles[:, i]] for i in range(3))
        turned = np.einsum("ij,ij->i", np.cross(b - a, c - a), a) * side < 0
        triangles[turned] = triangles[turned][:, ::-1]
        shells.append(triangles)
    return np.concatenate([outer, inner]), np.concatenate([shells[0], shells[1] + len(outer)]).astype(np.int32)


GENERATED = {
    "box": (lambda: models.box((4.0, 2.0, 1.0)), (1, 0, 0)),
    "torus": (torus, (1, 1, 0)),
    "trefoil": (trefoil, (1, 1, 0)),
    "hollow sphere": (hollow_sphere, (1, 0, 1)),
}
FILES = {
    "double-torus.obj": (1, 2, 0),
    "3holes.obj": (1, 3, 0),
    "femur.off": (1, 2, 0),
    "fandisk.obj": (1, 0, 0),
    "decimated-max.obj": (1, 0, 0),
    "penguin.obj": None,
    "skull_low_resolution.obj": (1, 2, 0),
    "spot.obj": (1, 0, 0),
    "stanford-bunny.obj": (1, 0, 0),
}


def shape(name):
    """Vertices and triangles."""
    if name in GENERATED:
        return GENERATED[name][0]()
    vertices, faces = models.read(models.shared(name))
    fans = [(f[0], f[i], f[i + 1]) for f in faces for i in range(1, len(f) - 1)]
    return vertices, np.array(fans, np.int32)


def is_closed(triangles):
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    return (np.unique(edges, axis=0, return_counts=True)[1] == 2).all()


def first_free(axis):
    return next((i for i, part in enumerate(axis.parts) if not part.locked), None)


def operations(axis):
    """Do everything there is to an axis; yields the name of each as it is done."""
    whole = axis.report
    steps = [
        ({"triangles": 5}, {"iterations": 2}),
        ({"volume": 0.01}, {}),
        ({"balls": 0.02}, {}),
        ({"width": 0.05}, {}),
        ({"angle": 100}, {}),
    ]
    for thresholds, more in steps:
        axis.prune(**thresholds, **more)
        yield f"prune {thresholds}"
    if (part := first_free(axis)) is not None:
        axis.remove(part)
        yield "remove a part"
    if (part := first_free(axis)) is not None and axis.parts[part].triangles:
        axis.remove(triangles=np.flatnonzero(axis.triangle_part == part)[-1:])
        yield "remove by a triangle"
    assert axis.undo()
    yield "undo"
    axis.prune(triangles=1e9, volume=1, iterations=50)
    yield "prune to the end"
    while axis.undo():
        pass
    assert axis.report == whole
    yield "undo all"


def check_cells(axis, diagonal):
    """No vertex twice, no crack, no pocket."""
    vertices, triangles = axis.vertices, axis.triangles
    assert len(np.unique(vertices, axis=0)) == len(vertices)
    assert len(np.unique(np.sort(triangles, axis=1), axis=0)) == len(triangles)
    assert all(len(set(row)) == 3 for row in triangles.tolist())
    thirds = collections.defaultdict(set)
    for a, b, c in triangles.tolist():
        thirds[frozenset((a, b))].add(c)
        thirds[frozenset((b, c))].add(a)
        thirds[frozenset((c, a))].add(b)
    # A crack would be two borders in the same place: vertices nearer than any two that are joined.
    from scipy.spatial import cKDTree

    border = sorted({v for edge, across in thirds.items() if len(across) == 1 for v in edge})
    near = cKDTree(vertices[border]).query_pairs(1e-10 * diagonal)
    assert all(frozenset((border[i], border[j])) in thirds for i, j in near)
    for a, b, c in triangles.tolist():
        apex = thirds[frozenset((a, b))] & thirds[frozenset((b, c))] & thirds[frozenset((c, a))]
        assert not apex, "four triangles bound a tetrahedron"


@pytest.mark.parametrize("name", [*GENERATED, *FILES])
def test_topology_is_the_solids_through_everything(name):
    vertices, triangles = shape(name)
    model = vbm.build(vertices, triangles=triangles)
    surface = model.surface()
    solid = solid_betti(surface.vertices, surface.triangles)
    known = GENERATED[name][1] if name in GENERATED else FILES[name]
    if known:
        assert solid == known
    if is_closed(triangles):
        assert solid == solid_betti(vertices, triangles)
    axis = model.medial_axis()
    assert axis_betti(axis) == solid
    check_cells(axis, model.report.diagonal)
    small = axis.report.triangles < 30000
    for done in operations(axis):
        if small or done in ("prune {'volume': 0.01}", "prune to the end", "undo all"):
            assert axis_betti(axis) == solid, done
        if done in ("prune {'volume': 0.01}", "prune to the end"):
            check_cells(axis, model.report.diagonal)
            simplified = axis.surface()
            models.assert_closed_manifold(len(simplified.vertices), simplified.triangles)
            assert solid_betti(simplified.vertices, simplified.triangles) == solid, done
