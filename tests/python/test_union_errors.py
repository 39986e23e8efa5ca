# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a surface from balls and the boundary of their union are apart, against brute force."""

import math

import numpy as np
import pytest
import vbm

import models
from test_ball_surface import random_balls

FIELDS = ("surface_error_max", "surface_error_mean", "union_error_max", "union_error_mean")


def errors_of(surface):
    return np.array([getattr(surface.report, name) for name in FIELDS])


def signed(points, centers, radii):
    return (np.linalg.norm(points[:, None] - centers, axis=2) - radii).min(axis=1)


def boundary(centers, radii, each, random):
    """Random points on all spheres, without those in other balls."""
    out = random.normal(size=(len(radii), each, 3))
    out /= np.linalg.norm(out, axis=2, keepdims=True)
    points = (centers[:, None] + radii[:, None, None] * out).reshape(-1, 3)
    return points[signed(points, centers, radii) > -1e-9]


def on_triangles(corners, count, random):
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    some = corners[random.choice(len(corners), count, p=area / area.sum())]
    u, v = random.random((2, count, 1))
    over = u + v > 1
    u, v = np.where(over, 1 - u, u), np.where(over, 1 - v, v)
    return some[:, 0] * (1 - u - v) + some[:, 1] * u + some[:, 2] * v


@pytest.mark.parametrize("seed, bulge", [(14, 0.15), (23, 0.15), (4, 0.05), (4, 1)])
def test_against_brute_force(seed, bulge):
    random = np.random.default_rng(seed)
    centers, radii = random_balls(seed)
    surface = vbm.surface_from_balls(centers, radii, bulge=bulge, errors=True)
    corners = surface.vertices[surface.triangles]
    surface_max, surface_mean, union_max, union_mean = errors_of(surface)

    on_union = boundary(centers, radii, max(100, 3000 // len(radii)), random)
    away = models.to_triangles(on_union, corners)
    assert 0.95 * away.max() < union_max < 1.5 * away.max()  # more points find more
    assert 0.5 * away.mean() < union_mean < 2 * away.mean()  # spread by rays, not by area

    points = on_triangles(corners, 3000, random)
    d = signed(points, centers, radii)
    least, most = abs(d), np.maximum(d, 0)
    for k in np.flatnonzero(d < 0):
        most[k] = np.linalg.norm(on_union - points[k], axis=1).min()
    assert 0.95 * least.mean() < surface_mean < 1.05 * most.mean()
    assert 0.9 * least.max() < surface_max < 2.5 * most.max()


def test_one_ball_is_known():
    """Of a ball the surface is a polyhedron in it: both are off by what it lacks."""
    surface = vbm.surface_from_balls([[1.0, 2, 3]], [2.0], errors=True)
    corners = surface.vertices[surface.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    height = 2 - ((corners[:, 0] - [1, 2, 3]) * normals).sum(axis=1)
    surface_max, surface_mean, union_max, union_mean = errors_of(surface)
    assert union_max == pytest.approx(height.max(), rel=0.02)
    assert surface_max == pytest.approx(height.max(), rel=0.02)
    random = np.random.default_rng(1)
    away = models.to_triangles(boundary(np.array([[1.0, 2, 3]]), np.array([2.0]), 3000, random), corners)
    assert union_mean == pytest.approx(away.mean(), rel=0.03)
    inside = on_triangles(corners, 20_000, random)
    assert surface_mean == pytest.approx((2 - np.linalg.norm(inside - [1, 2, 3], axis=1)).mean(), rel=0.02)


def test_a_hole_that_is_closed_shows_from_the_union():
    """What is narrow and closed lies off the union: the report must say so from either side."""
    wide = vbm.surface_from_balls(*tube(600), errors=True)
    exact = vbm.surface_from_balls(*tube(600), narrow=0, bulge=0.001, errors=True)
    assert (errors_of(wide) > 3 * errors_of(exact)).all()


def tube(count, radius=0.3):
    """Balls along a ring, a little uneven."""
    random = np.random.default_rng(5)
    angle = np.sort(random.random(count)) * 2 * math.pi
    centers = np.stack([np.cos(angle), np.sin(angle), np.zeros(count)], axis=1)
    return centers + 0.01 * random.normal(size=centers.shape), np.full(count, radius)


@pytest.mark.parametrize("style", ["singular_points", "power_crust"])
def test_errors_fall_as_sampling_rises(style):
    """Balls within an ellipsoid, touching it: both ways, largest and mean."""
    rows = []
    for count in (200, 800, 3200):
        points = models.sphere(count, 1.0) * [1, 0.8, 0.6]
        model = vbm.build(points)
        inner = model.inside
        rows.append(errors_of(vbm.surface_from_balls(model.centers[inner], model.radii[inner],
                                                     style=style, errors=True)))
    assert (np.diff(rows, axis=0) < 0).all(), rows
    assert (rows[2] < 0.5 * rows[0]).all(), rows


@pytest.mark.parametrize("style", ["singular_points", "skin", "power_crust"])
def test_the_surface_is_the_same(style):
    centers, radii = random_balls(3)
    plain = vbm.surface_from_balls(centers, radii, style=style)
    stages = []
    measured = vbm.surface_from_balls(centers, radii, style=style, errors=True,
                                      progress=lambda done, stage: stages.append((done, stage)))
    assert plain.vertices.tobytes() == measured.vertices.tobytes()
    assert plain.triangles.tobytes() == measured.triangles.tobytes()
    assert not errors_of(plain).any() and (errors_of(measured) > 0).all()
    assert stages[-1][0] == 1 and [s[0] for s in stages] == sorted(s[0] for s in stages)
    again = vbm.surface_from_balls(centers, radii, style=style, errors=True)
    assert (errors_of(again) == errors_of(measured)).all()


def test_units_and_places_do_not_matter():
    centers, radii = random_balls(0)
    one = errors_of(vbm.surface_from_balls(centers, radii, errors=True))
    far = errors_of(vbm.surface_from_balls(centers * 1024 + 4096, radii * 1024, errors=True))
    assert far == pytest.approx(1024 * one, rel=1e-6)


@pytest.mark.parametrize("wrong", ["yes", 0.5, None])
def test_the_option_is_checked(wrong):
    with pytest.raises(TypeError, match="errors must be True or False"):
        vbm.surface_from_balls([[0.0, 0, 0]], [1.0], errors=wrong)
