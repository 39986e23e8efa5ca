# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of several shells: where one runs inside another it is no boundary, and gets no samples."""

import models
import numpy as np
import pytest
import vbm
from scipy.spatial import ConvexHull


def ball(count, radius=1.0, center=(0, 0, 0), inward=False):
    points = models.sphere(count, radius)
    triangles = ConvexHull(points).simplices
    a, b, c = (points[triangles[:, i]] for i in range(3))
    turned = (np.einsum("ij,ij->i", np.cross(b - a, c - a), a) < 0) != inward
    triangles[turned] = triangles[turned][:, ::-1]
    return points + center, triangles


def block(low, size):
    corners, triangles = models.box(size)
    return corners + low, triangles


def join(*shells):
    before = np.cumsum([0] + [len(points) for points, _ in shells])
    triangles = [triangles + n for n, (_, triangles) in zip(before, shells)]
    return np.concatenate([points for points, _ in shells]), np.concatenate(triangles).astype(np.int32)


def build(*shells, **options):
    vertices, triangles = join(*shells)
    return vbm.build(vertices, triangles=triangles, **options)


def distance_to_balls(points, *balls):
    """Signed, to the nearest of the spheres (center, radius)."""
    return np.stack([np.linalg.norm(points - c, axis=1) - r for c, r in balls], axis=1)


def test_two_balls_that_cross_are_sampled_outside_only():
    second = np.array([0.8, 0.1, 0.2])
    shells = ball(1500), ball(1200, 0.8, second)
    vertices, _ = join(*shells)
    model = build(*shells)
    inside = distance_to_balls(vertices, ((0, 0, 0), 1), (second, 0.8)).min(axis=1) < -0.02
    assert inside.sum() > 300
    assert (model.input_sample[inside] == -1).all()
    on_it = distance_to_balls(vertices, ((0, 0, 0), 1), (second, 0.8)).min(axis=1) > -1e-9
    assert (model.input_sample[on_it] >= 0).all()
    report = model.report
    assert report.dropped == (model.input_sample == -1).sum()
    assert report.samples == report.input_points - report.dropped - report.merged + report.added
    assert any("left out where parts of the mesh run inside others" in note for note in model.notes)
    # What is left is one solid, and its axis that of the union: no sheet along a wall inside.
    surface = model.surface()
    assert (surface.report.components, surface.report.genus) == (1, 0)
    models.assert_closed_manifold(len(surface.vertices), surface.triangles)
    whole = sum(4 / 3 * np.pi * r**3 for r in (1, 0.8))
    assert 0.6 * whole < surface.report.volume < whole
    axis = model.medial_axis()
    assert axis.radii.max() > 0.95  # with samples on the walls inside no ball was larger than half
    assert axis.report.components == 1 and axis.report.euler == 1


def test_a_shell_within_another_of_its_direction_is_left_out():
    shells = ball(1500), ball(500, 0.5)
    model = build(*shells)
    alone = build(ball(1500))
    assert model.report.dropped == 500 and model.report.samples == alone.report.samples
    assert np.array_equal(np.sort(model.radii), np.sort(alone.radii))


def test_cavities_stay_and_are_joined_where_they_cross():
    one = build(ball(2500), ball(600, 0.4, inward=True))
    assert one.report.dropped == 0
    two = build(
        ball(2500), ball(600, 0.4, (0.25, 0, 0), inward=True), ball(600, 0.4, (-0.2, 0.1, 0), inward=True)
    )
    assert two.report.dropped > 150
    for model in (one, two):
        assert model.surface().report.components == 2
        assert model.surface().report.genus == 0
        assert model.medial_axis().report.euler == 2


def test_a_cavity_that_breaks_through_makes_a_dent():
    center = np.array([0.55, 0.55, 0])  # within the other's box, or it would be taken as a solid
    vertices, _ = join(ball(2500), ball(800, 0.4, center))
    model = build(ball(2500), ball(800, 0.4, center, inward=True))
    d = distance_to_balls(vertices, ((0, 0, 0), 1), (center, 0.4))
    outer = np.arange(len(vertices)) < 2500
    gone = np.where(outer, d[:, 1] < -0.03, d[:, 0] > 0.03)
    stays = np.where(outer, d[:, 1] > 0.03, d[:, 0] < -0.03)
    assert gone.sum() > 100
    assert (model.input_sample[gone] == -1).all() and (model.input_sample[stays] >= 0).all()
    surface = model.surface().report
    assert (surface.components, surface.genus) == (1, 0)


def test_blocks_that_cross_are_a_cross():
    model = build(block((0, 0, 0), (3, 1, 1)), block((1.1, -1, 0.2), (0.7, 3, 0.6)))
    assert model.report.dropped == 0  # all corners are outside
    alone = build(block((0, 0, 0), (3, 1, 1)), block((1.1, 5, 0.2), (0.7, 3, 0.6)), spacing=model.report.spacing)
    assert model.report.added < alone.report.added - 100
    surface = model.surface().report
    assert (surface.components, surface.genus) == (1, 0)
    assert surface.volume == pytest.approx(3 + 0.7 * 3 * 0.6 - 0.7 * 0.6, rel=0.02)


@pytest.mark.parametrize("shift", [(2, 0, 0), (1, 0, 0), (2, 1, 1)])
def test_nothing_that_may_be_boundary_is_left_out(shift):
    # Blocks that touch in a face, overlap with faces in one plane, touch in a corner.
    one, two = block((0, 0, 0), (2, 1, 1)), block(shift, (2, 1, 1))
    model = build(one, two, spacing=0.1)
    sample = model.samples
    vertices, _ = join(one, two)
    assert (model.input_sample >= 0).all() and len(vertices) == 16
    # Every face of the union has samples all over: no point of it is far from one.
    random = np.random.default_rng(0)
    for low in ((0, 0, 0), shift):
        low, size = np.array(low, float), np.array((2.0, 1.0, 1.0))
        other = np.array(shift, float) - low if (low == 0).all() else -np.array(shift, float)
        at = random.uniform(0, 1, (300, 3)) * size
        axis = random.integers(0, 3, 300)
        at[np.arange(300), axis] = random.integers(0, 2, 300) * size[axis]
        covered = ((at > other - 1e-9) & (at < other + size + 1e-9)).all(axis=1)
        for p in (at + low)[~covered]:
            assert np.linalg.norm(sample - p, axis=1).min() < 0.11


def test_open_parts_and_propagation_keep_their_samples():
    sheet = np.array([(-0.3, -0.3, 0), (0.3, -0.3, 0), (0.3, 0.3, 0), (-0.3, 0.3, 0)]), np.array(
        [(0, 1, 2), (0, 2, 3)]
    )
    model = build(ball(1500), sheet)
    assert model.report.dropped == 0
    crossing = ball(1500), ball(1500, 1, (0.8, 0, 0))
    assert build(*crossing, labels="propagation").report.dropped == 0
