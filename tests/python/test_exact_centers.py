# SPDX-License-Identifier: GPL-3.0-or-later
"""Nearly flat tetrahedra: their balls' centres, far off in doubles, are computed exactly."""

import numpy as np
import pytest
from models import read, shared, sphere

import vbm


def two_spheres():
    points = sphere(2500)
    other = points + (0.8, 0.1, 0.2)
    return np.concatenate([points[np.linalg.norm(points - (0.8, 0.1, 0.2), axis=1) > 1],
                           other[np.linalg.norm(other, axis=1) > 1]])


def lat_long():
    turn, height = np.meshgrid(np.arange(96) * np.pi / 48, np.arange(1, 48) * np.pi / 48 - np.pi / 2)
    return np.stack([np.cos(turn) * np.cos(height), np.sin(turn) * np.cos(height), np.sin(height)], -1).reshape(-1, 3)


def mushroom():
    return read(shared("mushroom.obj"))[0]


@pytest.mark.parametrize("shape", [two_spheres, lat_long, mushroom], ids=lambda f: f.__name__)
def test_balls_touch_their_samples_and_hold_none(shape):
    points = shape()
    model = vbm.build(points, balls="voronoi")
    assert model.report.exact_centers > 0
    size = np.linalg.norm(np.ptp(points, axis=0))
    samples, centers, radii = model.samples, model.centers, model.radii
    some = np.random.default_rng(1).permutation(len(radii))[:3000]
    # The rounding of a distance as long as the radius itself.
    slack = 1e-10 * size + 1e-14 * radii
    for i in range(0, len(some), 300):
        b = some[i : i + 300]
        gap = np.linalg.norm(samples[None] - centers[b, None], axis=2) - radii[b, None]
        assert (gap.min(axis=1) > -slack[b]).all()
        for row, ball in zip(gap, b):
            assert (np.abs(row[model.samples_of(ball)]) < slack[ball]).all(), (ball, radii[ball])
