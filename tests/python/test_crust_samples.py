# SPDX-License-Identifier: GPL-3.0-or-later
"""The power crust passes through the samples: most are its vertices, the others are on or next to a face."""

import numpy as np
import pytest
from models import blob, read, shared, torus

import vbm


def distances(points, vertices, triangles):
    """Of every point from the nearest triangle, by brute force."""
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    out = np.empty(len(points))
    for i, p in enumerate(points):
        best = segment(p, a, b)
        best = np.minimum(best, segment(p, b, c))
        best = np.minimum(best, segment(p, c, a))
        normal = np.cross(b - a, c - a)
        size = np.linalg.norm(normal, axis=1)
        with np.errstate(invalid="ignore", divide="ignore"):
            height = np.abs(((p - a) * normal).sum(1)) / size
        over = size > 0
        for u, v in ((a, b), (b, c), (c, a)):
            over &= (np.cross(v - u, p - u) * normal).sum(1) >= 0
        out[i] = min(best.min(), height[over].min(initial=np.inf))
    return out


def segment(p, a, b):
    along = b - a
    t = ((p - a) * along).sum(1) / np.maximum((along**2).sum(1), 1e-300)
    return np.linalg.norm(a + np.clip(t, 0, 1)[:, None] * along - p, axis=1)


def spacing(points, samples):
    """Of every point, the distance to the nearest other sample."""
    return np.array([np.sort(np.linalg.norm(samples - p, axis=1))[1] for p in points])


SHAPES = {"blob": lambda: blob(3000), "torus": lambda: torus(80, 40)[0]}
FILES = ["3holes.obj", "penguin.obj", "spot.obj", "decimated-max.obj", "stanford-bunny.obj"]


@pytest.mark.parametrize("name", [*SHAPES, *FILES])
def test_every_sample_is_on_the_crust(name):
    points = SHAPES[name]() if name in SHAPES else read(shared(name))[0]
    model = vbm.build(points)
    crust = model.power_crust()
    named = crust.vertex_sample >= 0
    assert np.array_equal(crust.vertices[named], model.samples[crust.vertex_sample[named]])
    others = np.setdiff1d(np.arange(len(model.samples)), crust.vertex_sample)
    # Samples at which fewer than four balls meet are no corners; on a regular torus one ball touches a whole ring.
    assert name == "torus" or len(others) < 0.08 * len(model.samples)
    some = model.samples[np.random.default_rng(0).permutation(others)[:100]]
    if len(some):
        gap = distances(some, crust.vertices, crust.triangles) / spacing(some, model.samples)
        assert gap.max() < 0.2 and np.median(gap) < 1e-4
