# SPDX-License-Identifier: GPL-3.0-or-later
"""The medial axis from the power shape: topology by GUDHI, what its vertices and triangles are."""

import re

import models
import numpy as np
import pytest
import vbm
from test_axis import betti, box_points, sphere_points, torus_points


def trefoil_points(count=300, across=24, tube=0.25):
    """Samples on a tube round a trefoil knot, shaken within its surface."""
    random = np.random.default_rng(11)
    t = np.repeat(np.arange(count) * 2 * np.pi / count, across)
    turn = np.tile(np.arange(across) * 2 * np.pi / across, count)
    t = t + random.uniform(-0.3, 0.3, t.shape) * 2 * np.pi / count
    turn = turn + random.uniform(-0.3, 0.3, turn.shape) * 2 * np.pi / across

    def knot(t):
        return np.stack(
            [np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], axis=1
        )

    along = knot(t + 1e-4) - knot(t - 1e-4)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    side = np.cross(along, [0.0, 0.0, 1.0])
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    up = np.cross(side, along)
    return knot(t) + tube * (np.cos(turn)[:, None] * side + np.sin(turn)[:, None] * up)


def hollow_sphere():
    points = np.concatenate([sphere_points(4000, 1.0), sphere_points(1500, 0.6)])
    normals = points.copy()
    normals[4000:] *= -1
    return vbm.build(points, normals=normals)


def from_points(name):
    return vbm.build(models.read(models.shared(name))[0])


def from_mesh(name):
    vertices, faces = models.read(models.shared(name))
    return vbm.build(vertices, faces=faces)


SOLIDS = {
    "box": (lambda: vbm.build(box_points(0.1, 0)), [1, 0, 0]),
    "torus": (lambda: vbm.build(torus_points()), [1, 1, 0]),
    "hollow sphere": (hollow_sphere, [1, 0, 1]),
    "trefoil": (lambda: vbm.build(trefoil_points()), [1, 1, 0]),
    "double-torus": (lambda: from_points("double-torus.obj"), [1, 2, 0]),
    "3holes": (lambda: from_points("3holes.obj"), [1, 3, 0]),
    "femur": (lambda: from_mesh("femur.off"), [1, 2, 0]),
    "penguin": (lambda: from_mesh("penguin.obj"), [1, 0, 0]),
}


@pytest.mark.parametrize("method", ["voronoi", "power_shape"])
@pytest.mark.parametrize("name", SOLIDS)
def test_topology_is_the_solids_before_and_after_pruning(name, method):
    make, wanted = SOLIDS[name]
    axis = make().medial_axis(method)
    assert betti(axis) == wanted
    whole = axis.report
    axis.prune(volume=0.01, iterations=2)
    assert betti(axis) == wanted
    axis.prune(triangles=1e9, iterations=3)
    assert betti(axis) == wanted
    while axis.undo():
        pass
    assert axis.report == whole and betti(axis) == wanted


@pytest.mark.parametrize("spacing, seed", [(0.1, 0), (0.05, 1), (0.05, 2)])
def test_box_has_twelve_outer_sheets_and_one_inner(spacing, seed):
    axis = vbm.build(box_points(spacing, seed)).medial_axis("power_shape")
    assert sorted(part.level for part in axis.parts) == [1] * 12 + [2]
    inner = next(part for part in axis.parts if part.level == 2)
    assert inner.area == pytest.approx(3, rel=0.04)
    assert inner.width == pytest.approx(1, rel=0.05)


def test_vertices_are_empty_balls_that_touch_and_poles_among_them():
    model = vbm.build(box_points(0.1, 4))
    axis = model.medial_axis("power_shape")
    assert len(np.unique(axis.vertices.round(12), axis=0)) == len(axis.vertices)
    assert len(np.unique(axis.triangles)) == len(axis.vertices)
    nearest = np.array([np.linalg.norm(model.samples - v, axis=1).min() for v in axis.vertices])
    assert (nearest >= axis.radii - 1e-9).all() and (nearest < axis.radii + 0.05).all()
    # Thesis 7.5.2, observation 1: inner poles are vertices of the axis.
    poles = {tuple(c) for c in model.centers[: model.inner_count].round(9)}
    among = sum(tuple(v) in poles for v in axis.vertices.round(9))
    assert among > 0.6 * len(poles)


def test_triangles_name_two_samples_next_to_what_they_are_equidistant_from():
    model = vbm.build(box_points(0.1, 4))
    axis = model.medial_axis("power_shape")
    a, b = axis.triangle_samples.T
    assert (a != b).all() and axis.triangle_samples.max() < len(model.samples)
    assert axis.triangle_points.shape == (len(a), 2, 3)
    for corner in axis.triangles.T:
        center, radius = axis.vertices[corner], axis.radii[corner]
        for side, s in enumerate((a, b)):
            off = np.linalg.norm(axis.triangle_points[:, side] - center, axis=1) - radius
            assert np.abs(off).max() < 1e-9
            off = np.linalg.norm(model.samples[s] - center, axis=1) - radius
            assert off.min() > -1e-9 and off.max() < 0.05
    axis = model.medial_axis()
    assert np.array_equal(axis.triangle_points, model.samples[axis.triangle_samples])


def singular_points(axis):
    """How many there are, and how many of them are samples."""
    found = re.search(r"(\d+) singular points, (\d+) of them at samples", axis.notes[0])
    return int(found[1]), int(found[2])


def test_with_all_voronoi_balls_all_singular_points_are_samples():
    """The power diagram of all Voronoi balls is the samples' Delaunay triangulation."""
    points = box_points(0.1, 0)
    every, at_samples = singular_points(vbm.build(points, balls="voronoi").medial_axis("power_shape"))
    assert every == at_samples > 0
    every, at_samples = singular_points(vbm.build(points).medial_axis("power_shape"))
    assert 0 < at_samples < every


def test_where_the_balls_have_another_topology_singular_points_are_left_out():
    axis = from_mesh("femur.off").medial_axis("power_shape")
    assert any("left out where the sampling is too thin" in note for note in axis.notes)


def test_same_input_same_axis():
    first, second = (vbm.build(torus_points()).medial_axis("power_shape") for _ in range(2))
    for name in ("vertices", "radii", "triangles", "triangle_samples", "triangle_part", "edges"):
        assert getattr(first, name).tobytes() == getattr(second, name).tobytes()


def test_method_is_checked():
    model = vbm.build(box_points(0.2, 0))
    with pytest.raises(vbm.ArgumentError, match="'voronoi' or 'power_shape', not 'thinning'"):
        model.medial_axis("thinning")
    with pytest.raises(TypeError, match="method must be"):
        model.medial_axis(1)
    assert model.medial_axis().report == model.medial_axis(method="voronoi").report


def test_progress_and_cancel():
    model = vbm.build(box_points(0.05, 9))
    seen = []
    model.medial_axis("power_shape", progress=lambda fraction, stage: seen.append((fraction, stage)))
    assert [f for f, _ in seen] == sorted(f for f, _ in seen)
    stages = list(dict.fromkeys(stage for _, stage in seen))
    assert "power shape" in stages and "Voronoi diagram of singular points" in stages
    for wanted in stages:
        with pytest.raises(vbm.Cancelled):
            model.medial_axis("power_shape", progress=lambda fraction, stage: stage == wanted)


def lattice_box(n=6):
    grid = np.stack(np.meshgrid(*[np.arange(n + 1.0)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    return grid[((grid == 0) | (grid == n)).any(axis=1)]


NASTY = {
    "octahedron": lambda: np.concatenate([np.eye(3), -np.eye(3)]),
    "cospherical": lambda: sphere_points(500, 1.0),
    "lattice": lattice_box,
    "cloud": lambda: np.random.default_rng(5).normal(size=(400, 3)),
    "plate": lambda: lattice_box() * (1, 1, 1e-3),
    "far away": lambda: box_points(0.2, 3) + 1e6,
    "two that touch": lambda: np.concatenate([sphere_points(300, 1.0), sphere_points(301, 1.0) + (2, 0, 0)]),
    "close together": lambda: np.concatenate([p := box_points(0.2, 4), p * (1 + 1e-9)]),
}


@pytest.mark.parametrize("name", NASTY)
def test_nasty_points_give_the_topology_of_the_other_construction(name):
    model = vbm.build(NASTY[name]())
    axis = model.medial_axis("power_shape")
    assert betti(axis) == betti(model.medial_axis())
    before = betti(axis)
    axis.prune(volume=0.05, iterations=2)
    assert betti(axis) == before
    assert np.isfinite(axis.vertices).all() and (axis.radii > 0).all()
    axis.surface()
