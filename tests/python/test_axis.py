# SPDX-License-Identifier: GPL-3.0-or-later
"""The medial axis: its topology by GUDHI, its parts, pruning, undo, and the surface of what is left."""

import numpy as np
import pytest
import vbm

gudhi = pytest.importorskip("gudhi")


def betti(axis):
    """Of the axis as a simplicial complex, without the library's counting."""
    complex = gudhi.SimplexTree()
    for vertex in range(len(axis.vertices)):
        complex.insert([vertex])
    for simplex in [*axis.edges.tolist(), *axis.triangles.tolist()]:
        complex.insert(simplex)
    assert complex.num_vertices() == len(axis.vertices)
    # No triangle twice: the complex has as many simplices as the report.
    report = axis.report
    assert complex.num_simplices() == report.vertices + report.edges + report.triangles
    complex.compute_persistence(homology_coeff_field=2, persistence_dim_max=True)
    return (complex.betti_numbers() + [0, 0, 0])[:3]


def box_points(spacing, seed, size=(4, 2, 1)):
    """Samples on a box, shaken within its faces, and turned any way."""
    random = np.random.default_rng(seed)
    faces = []
    for axis in range(3):
        u, v = (a for a in range(3) if a != axis)
        count = [round(size[a] / spacing) for a in (u, v)]
        i, j = np.meshgrid(*[np.arange(n + 1) for n in count], indexing="ij")
        at = np.stack([i.ravel(), j.ravel()], axis=1).astype(float)
        inner = ((at > 0) & (at < count)).all(axis=1, keepdims=True)
        at += inner * random.uniform(-0.3, 0.3, at.shape)
        for side in (0, size[axis]):
            face = np.empty((len(at), 3))
            face[:, [u, v]] = at * spacing
            face[:, axis] = side
            faces.append(face)
    points = np.unique(np.concatenate(faces).round(12), axis=0)
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    return points @ turn.T


def torus_points(around=120, across=40, ring=1.0, tube=0.35):
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across)
    u, v = u.ravel(), v.ravel()
    random = np.random.default_rng(3)
    u, v = u + random.uniform(-0.01, 0.01, u.shape), v + random.uniform(-0.03, 0.03, v.shape)
    rho = ring + tube * np.cos(v)
    return np.stack([rho * np.cos(u), rho * np.sin(u), tube * np.sin(v)], axis=1)


def sphere_points(count, radius):
    k = np.arange(count) + 0.5
    polar, turn = np.arccos(1 - 2 * k / count), np.pi * (1 + 5**0.5) * k
    return radius * np.stack(
        [np.cos(turn) * np.sin(polar), np.sin(turn) * np.sin(polar), np.cos(polar)], axis=1
    )


@pytest.mark.parametrize("spacing, seed", [(0.1, 0), (0.05, 1), (0.05, 2)])
def test_box_has_twelve_outer_sheets_and_one_inner(spacing, seed):
    axis = vbm.build(box_points(spacing, seed)).medial_axis()
    assert betti(axis) == [1, 0, 0]
    assert sorted(part.level for part in axis.parts) == [1] * 12 + [2]
    inner = next(part for part in axis.parts if part.level == 2)
    # The rectangle in the middle: 3 by 1, half-way between the largest faces.
    assert inner.area == pytest.approx(3, rel=0.03)
    assert inner.locked == "inner" and all(p.locked == "" for p in axis.parts if p.level == 1)
    assert inner.width == pytest.approx(1, rel=0.05) and inner.angle > 170
    assert len(axis.edges) == 0


def test_triangles_are_equidistant_from_their_samples():
    model = vbm.build(box_points(0.1, 4))
    axis = model.medial_axis()
    a, b = model.samples[axis.triangle_samples].swapaxes(0, 1)
    for corner in axis.triangles.T:
        center, radius = axis.vertices[corner], axis.radii[corner]
        for sample in (a, b):
            assert np.allclose(np.linalg.norm(sample - center, axis=1), radius, atol=1e-9)
    # A vertex is not there twice, and all are used.
    assert len(np.unique(axis.vertices.round(9), axis=0)) == len(axis.vertices)
    assert len(np.unique(axis.triangles)) == len(axis.vertices)


def test_pruning_keeps_topology_and_undo_brings_back():
    model = vbm.build(box_points(0.1, 5))
    axis = model.medial_axis()
    whole = axis.report
    before = axis.triangles.copy()
    volume = model.power_crust().report.volume
    axis.prune(volume=0.9)
    assert betti(axis) == [1, 0, 0]
    assert axis.report.parts < whole.parts and axis.report.volume < 1
    assert 0 < axis.kept_balls.sum() < len(axis.kept_balls)
    surface = axis.surface()
    assert (surface.report.components, surface.report.genus) == (1, 0)
    assert surface.report.volume < volume
    assert axis.undo() and axis.report == whole
    assert np.array_equal(axis.triangles, before)
    assert not axis.undo()


def test_a_copy_goes_its_own_way():
    axis = vbm.build(box_points(0.1, 5)).medial_axis()
    whole = axis.report
    axis.prune(volume=0.01)
    pruned = axis.report
    other = axis.copy()
    other.prune(volume=0.9)
    assert other.report.parts < pruned.parts and axis.report == pruned
    assert other.undo() and other.undo() and other.report == whole
    assert axis.report == pruned and pruned.parts < whole.parts


def test_a_part_is_removed_by_its_number():
    axis = vbm.build(box_points(0.1, 6)).medial_axis()
    free = next(i for i, part in enumerate(axis.parts) if not part.locked)
    gone = axis.parts[free].triangles
    count = axis.report.triangles
    axis.remove(free)
    assert axis.report.triangles == count - gone
    assert betti(axis) == [1, 0, 0]


def test_a_torus_keeps_its_tunnel():
    model = vbm.build(torus_points())
    axis = model.medial_axis()
    assert betti(axis) == [1, 1, 0]
    axis.prune(triangles=1e9, volume=1, iterations=5)
    assert betti(axis) == [1, 1, 0]
    assert axis.surface().report.genus == 1
    assert axis.parts and all(part.locked for part in axis.parts)
    with pytest.raises(vbm.InputError, match="part 0 cannot go"):
        axis.remove(0)
    with pytest.raises(vbm.InputError, match="there is no part 1000"):
        axis.remove([1000])


def test_a_hollow_sphere_keeps_its_cavity():
    points = np.concatenate([sphere_points(4000, 1.0), sphere_points(1500, 0.6)])
    normals = points.copy()
    normals[4000:] *= -1
    model = vbm.build(points, normals=normals)
    axis = model.medial_axis()
    assert betti(axis) == [1, 0, 1]
    axis.prune(triangles=1e9, iterations=3)
    assert betti(axis) == [1, 0, 1]
    assert axis.surface().report.components == 2


def test_topology_graph_of_a_box():
    axis = vbm.build(box_points(0.1, 7)).medial_axis()
    graph = axis.topology_graph()
    # All contact curves hang together: one node, which every part touches.
    assert len(graph["nodes"]) == 1 and len(graph["parts"]) == 13
    assert sorted(graph["edges"][:, 0].tolist()) == list(range(13))


def test_thresholds_are_checked():
    axis = vbm.build(box_points(0.1, 8)).medial_axis()
    report = axis.report
    for wrong in ({}, {"triangles": -1}, {"volume": float("nan")}, {"angle": 3, "iterations": 0}):
        with pytest.raises(vbm.ArgumentError):
            axis.prune(**wrong)
    with pytest.raises(vbm.ArgumentError):
        vbm.build(box_points(0.1, 8)).medial_axis(angle=200)
    assert axis.report == report


def test_progress_and_cancel():
    model = vbm.build(box_points(0.05, 9))
    seen = []
    model.medial_axis(progress=lambda fraction, stage: seen.append((fraction, stage)))
    assert seen and [f for f, _ in seen] == sorted(f for f, _ in seen)
    with pytest.raises(vbm.Cancelled):
        model.medial_axis(progress=lambda fraction, stage: True)
