# SPDX-License-Identifier: GPL-3.0-or-later
"""Known answers: thickness of a sphere and a torus, volumes, and power crusts of parts of a model."""

import models
import numpy as np
import pytest
import vbm


def test_thickness_of_a_sphere():
    model = vbm.build(models.sphere(5000, radius=3.0))
    # Every inner polar ball is about the sphere itself.
    assert np.abs(model.thickness / 6 - 1).max() < 0.01
    assert np.isinf(model.outer_radius).all()
    assert np.abs(model.local_feature_size / 3 - 1).max() < 0.01


def test_thickness_of_a_torus():
    big, small = 2.0, 0.7
    points, tube = models.torus(200, 100, big, small)
    model = vbm.build(points)
    assert np.abs(model.thickness / (2 * small) - 1).max() < 0.03
    # Seen from the hole, the outside's medial axis is the torus's own axis. A pole is the farthest corner
    # of its Voronoi cell, so it lies beyond by an angle that shrinks as the spacing does.
    hole = np.cos(tube) < -0.5
    outer = (big + small * np.cos(tube[hole])) / -np.cos(tube[hole])
    assert np.abs(model.outer_radius[hole] / outer - 1).max() < 0.04


@pytest.mark.parametrize("scale", [1e-9, 1e9])
def test_lengths_are_in_the_input_s_units(points, model, scale):
    scaled = vbm.build(points * scale)
    assert np.allclose(scaled.thickness, model.thickness * scale, rtol=1e-6)
    volume = scaled.surface().report.volume
    assert volume == pytest.approx(model.surface().report.volume * scale**3, rel=1e-6)


@pytest.mark.parametrize("kind", ["surface", "power_crust"])
def test_surfaces_are_closed_and_face_outward(kind):
    points, _ = models.torus(60, 30)
    surface = getattr(vbm.build(points), kind)()
    models.assert_closed_manifold(len(surface.vertices), surface.triangles)
    volume = models.signed_volume(surface.vertices, surface.triangles)
    assert volume == pytest.approx(surface.report.volume)
    assert volume == pytest.approx(2 * np.pi**2 * 2.0 * 0.7**2, rel=0.03)
    assert (surface.report.components, surface.report.genus) == (1, 1)
    largest = np.abs(surface.vertices).max(axis=0)
    assert (largest <= np.abs(points).max(axis=0) * 1.02).all()  # no needles


def test_box_from_its_faces():
    vertices, triangles = models.box((4, 2, 1))
    model = vbm.build(vertices, triangles)
    assert model.report.added > 0 and model.report.spacing > 0
    surface = model.surface()
    models.assert_closed_manifold(len(surface.vertices), surface.triangles)
    assert surface.report.volume == pytest.approx(8, rel=2e-3)  # its edges are cut off slightly
    # Nothing on a box is thicker than its height, and the middle of the top is just that thick.
    top = np.linalg.norm(model.samples - (2, 1, 1), axis=1).argmin()
    touching = [b for b in range(model.inner_count) if top in model.samples_of(b)]
    assert model.radii[touching].max() == pytest.approx(0.5, rel=0.01)
    assert model.radii[model.inside].max() < 0.56


@pytest.mark.parametrize("spacing", [0.25, 0.6, 2.0])
@pytest.mark.parametrize("refine", [False, True])
def test_no_gap_exceeds_the_spacing(spacing, refine):
    vertices, triangles = models.box((4, 2, 1))
    vertices = vertices @ np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    model = vbm.build(vertices, triangles, spacing=spacing, refine=refine)
    assert model.report.spacing == spacing
    random = np.random.default_rng(4)
    weights = random.dirichlet([1, 1, 1], (len(triangles), 400))
    edge = random.random((len(triangles), 200, 1)) * [[[1, -1, 0]]] + [0, 1, 0]  # first to second corner
    corners = vertices[triangles]
    for share in (weights, edge):
        points = np.einsum("tpk,tkx->tpx", share, corners).reshape(-1, 3)
        nearest = [np.linalg.norm(model.samples - p, axis=1).min() for p in points]
        assert max(nearest) <= spacing
    # Nor is it met by far too many.
    area = 2 * (4 * 2 + 4 * 1 + 2 * 1)
    if not refine:
        assert len(model.samples) < 8 + 2.5 * area / spacing**2 + 2 * 28 / spacing


def two_spheres():
    """Two spheres beside each other, and which of them each point is on."""
    one = models.sphere(800)
    return np.r_[one, one * 0.5 + (3, 0, 0)], np.repeat([0, 1], 800)


def test_keep_part_of_a_model():
    points, which = two_spheres()
    model = vbm.build(points)
    centers = model.centers[: model.inner_count]
    whole = model.power_crust()
    assert whole.report.components == 2
    expected = 4 / 3 * np.pi * (1 + 1 / 8)
    assert whole.report.volume == pytest.approx(expected, rel=0.02)
    first = centers[:, 0] < 2
    kept = model.power_crust(first)
    assert kept.report.components == 1
    assert kept.report.volume == pytest.approx(4 / 3 * np.pi, rel=0.02)
    models.assert_closed_manifold(len(kept.vertices), kept.triangles)
    assert first[kept.polygon_ball[kept.polygon_ball >= 0]].all()
    same = [model.power_crust(keep) for keep in (
        np.flatnonzero(first), np.flatnonzero(first).tolist(), first.tolist(),
        np.flatnonzero(first)[::-1].astype(np.uint8 if model.inner_count < 256 else np.uint16))]
    for other in same:
        assert other.vertices.tobytes() == kept.vertices.tobytes()
        assert other.triangles.tobytes() == kept.triangles.tobytes()
    everything = model.power_crust(np.ones(model.inner_count, bool))
    assert everything.vertices.tobytes() == whole.vertices.tobytes()
